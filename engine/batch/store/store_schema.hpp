// The tables of a store, and the views by which people query it (private to the store).
//
// Columns are named as in exports. Numbers have columns without a type: with the type REAL, SQLite would turn -0.0 into
// 0.0. Unknown values are NULL.
#pragma once

#include <string>

#include "engine/batch/operations/operation.hpp"
#include "engine/batch/store/database.hpp"

namespace lober::detail {

/// Raise it when the tables change, among them the columns and the lists of operations.
inline constexpr int store_format = 12;

/// "results_overlay".
[[nodiscard]] std::string table_of(const Operation& operation);
/// A name as SQL takes it whatever it is.
[[nodiscard]] std::string quoted_name(const std::string& name);
/// Creates all tables and views.
[[nodiscard]] std::string store_schema();
/// Whether they are there, to the letter: a column of another name would be filled and not be found again.
[[nodiscard]] bool has_store_schema(const Database& database);

}  // namespace lober::detail

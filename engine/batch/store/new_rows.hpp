// Results on their way into a table of the store (private to it).
//
// To bind a row of forty values to the parameters of a statement and to copy them from there takes longer than to make
// the row. So results are a virtual table that only this connection sees, and INSERT ... SELECT reads them in memory.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "engine/batch/manifest/plan.hpp"
#include "engine/batch/operations/operation.hpp"
#include "engine/batch/operations/result.hpp"
#include "engine/batch/store/database.hpp"

namespace lober::detail {

/// Stands for a row; damage of what is in it changes it.
[[nodiscard]] std::int64_t checksum(const Result& result, std::int64_t run, std::string_view lists);

class NewRows {
 public:
  NewRows(const Database& database, const Operation& operation);
  ~NewRows();
  NewRows(const NewRows&) = delete;
  NewRows& operator=(const NewRows&) = delete;

  /// Inserts the results into the table of the operation: into new rows whose numbers follow each other, or a single
  /// one into `row`, which has to be free. `run` is that of results that have none. `plan` has the jobs of the results,
  /// or is null. Returns the last row. Throws DataError.
  std::int64_t insert(std::span<const Result* const> results, std::int64_t run, const Plan* plan,
                      std::optional<std::int64_t> row);

 private:
  class Source;
  const Database& database_;
  std::unique_ptr<Source> source_;
  std::optional<Statement> insert_;
};

}  // namespace lober::detail

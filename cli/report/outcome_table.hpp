// The numbers of a result as text, as the table of operations describes it.
#pragma once

#include <span>
#include <string>

#include "lober/operations.hpp"

namespace lober::cli {

/// A line for each number, flag and text, with its error bar and its unit; a table for each list of objects, of its
/// first fifty; of points and matrices how many there are.
[[nodiscard]] std::string outcome_table(std::span<const operations::Field> fields, const void* whole);

}  // namespace lober::cli

// Tables of numbers as files: a row for each point, a column for each quantity.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace lober::cli {

struct Columns {
  std::vector<std::string> names;
  std::size_t rows = 0;
  /// Writes the numbers of a row, one for each name; called by several threads at a time.
  std::function<void(std::size_t row, std::span<double> values)> row;
  /// Shape of the array in an NPY file, without its last axis, the columns; the product is `rows`. Empty: one axis of
  /// rows.
  std::vector<std::size_t> shape;
};

/// Writes the table in the format that the ending of the path names (output_names.hpp): .npy, float64, rows x columns
/// or of the shape given; .csv and .txt, the names in the first line; .dat (Tecplot), the names as VARIABLES; .raw,
/// rows of float64; "-" is text on standard output. Numbers that are not finite are nan and inf in text. Streams:
/// memory does not grow with the rows. Throws UsageError, DataError, Cancelled.
void write_columns(const std::string& path, const Columns& columns);

}  // namespace lober::cli

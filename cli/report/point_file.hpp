// Points into a file whose ending says the format.
#pragma once

#include <span>
#include <string>

#include "lober/curve/curve.hpp"

namespace lober::cli {

/// Writes the points in the format that the ending of the path names (output_names.hpp). Throws UsageError, DataError.
void write_points(const std::string& path, std::span<const Point> points);

}  // namespace lober::cli

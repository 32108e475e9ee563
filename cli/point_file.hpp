// Points into a file whose ending says the format.
#pragma once

#include <cstdint>
#include <string>

#include "engine/curve/curve.hpp"
#include "engine/memory.hpp"

namespace lober::cli {

/// Writes the points in the format that the ending of the path names: .npy, .csv, .txt, .dat (Tecplot), .raw. "-" takes
/// text. `format_of` throws UsageError for any other ending.
enum class PointFormat : std::uint8_t { npy, csv, text, tecplot, raw };
[[nodiscard]] PointFormat format_of(const std::string& path);
void write_points(const std::string& path, const Buffer<Point>& points);

}  // namespace lober::cli

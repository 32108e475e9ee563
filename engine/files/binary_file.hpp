// Binary files of points: NumPy arrays and raw float64 pairs.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "lober/curve/files.hpp"

namespace lober::detail {

/// Reads `bytes`, which begin with the magic string of NPY, into one zone of `file`. Versions 1.0 to 3.0.
void read_npy(std::span<const std::byte> bytes, CurveFile& file);

/// Reads `bytes` as native float64 pairs into one zone of `file`.
void read_raw(std::span<const std::byte> bytes, CurveFile& file);

/// Adds the zone that a binary file consists of. Throws DataError when a point is not finite or there is
/// none.
void add_only_zone(std::vector<Point> points, CurveFile& file);

}  // namespace lober::detail

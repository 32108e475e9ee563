// The one check that every reader and writer of binary numbers needs.
#pragma once

#include <cstddef>
#include <span>

#include "kernels/point.hpp"

namespace lober::detail {

/// Index of the first point with an infinite coordinate or one that is not a number; the size when there is
/// none. O(N), parallel.
[[nodiscard]] std::size_t first_not_finite(std::span<const Point> points);

}  // namespace lober::detail

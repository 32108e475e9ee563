// Vertices that two curves have in common, one by one.
#pragma once

#include <cstddef>

#include "kernels/point.hpp"

namespace lober::detail {

/// A number n <= count such that for k = 1 to n a[k] is b[k], or b[-k] where `direction` is negative, and not a[k - 1]:
/// as large as whole vectors show it, so that the vertex after the n-th may be one more. O(n).
std::size_t common_vertices(const Point* a, const Point* b, int direction, std::size_t count);

}  // namespace lober::detail

// Curves that a file does not close.
#pragma once

#include <span>
#include <string>

#include "kernels/point.hpp"

namespace lober::detail {

/// The remark about a curve that is read as closed although its file does not repeat the first vertex: when the segment
/// that closes it is longer than ten times the median segment, the curve may well be open, and the remark says so; else
/// it is empty. The median is that of some thousand segments, evenly spread, repeated vertices aside. O(1) in the
/// number of points.
[[nodiscard]] std::string closing_remark(std::span<const Point> points);

}  // namespace lober::detail

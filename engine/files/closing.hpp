// Curves that a file does not close.
#pragma once

#include <span>
#include <string>

#include "kernels/point.hpp"
#include "lober/curve/periods.hpp"

namespace lober::detail {

/// The remark about a curve that is read as closed although its file does not repeat the first vertex: when the segment
/// that closes it is longer than ten times the median segment, the curve may well be open, and the remark says so; else
/// it is empty. The median is that of some thousand segments, evenly spread, repeated vertices aside. O(1) in the
/// number of points.
[[nodiscard]] std::string closing_remark(std::span<const Point> points);

/// Throws DataError "spec: ..." for a closed curve that goes round a cylinder, which would be closed by a segment
/// across all of it.
void require_closed_in_the_plane(std::span<const Point> points, Periods periods, const std::string& spec);

}  // namespace lober::detail

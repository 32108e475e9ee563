// How much a polyline turns, and what that says about the smooth curve it stands for.
#pragma once

#include <cmath>
#include <cstddef>

#include "kernels/point.hpp"

namespace lober::detail {

/// The lengths of `segments` segments in a row, which have segments + 1 points, and the curvatures at the vertices
/// between them, curvatures[k] at points[k + 1]: of the smooth curve through three points, the turning over the mean
/// length of the two segments. The turning is 2 tan(angle / 2), which agrees with the angle (radians) by which the
/// direction turns to third order, exceeds it for corners, and is cut off at 4 (an angle of 127 degrees); 0 where a
/// segment has no length. No trigonometry.
void turns_along(const Point* points, std::size_t segments, double* lengths, double* curvatures);

/// The bounds on parts of a segment: the sagitta kappa h^2 / 8, which is how far the smooth curve over a segment of
/// length h lies from it (never more than h / 2, because the turning is cut off), and the length; and how many parts
/// are counted at most.
struct PartsAsked {
  double tolerance, max_length, max_parts;
};
/// Into how many parts, a real number, `count` segments of these lengths have to be cut, where curvatures[k] and
/// curvatures[k + 1] are those at the ends of segment k, negative ones as if there were none; `max_parts` where that is
/// not a number.
void parts_needed(const double* lengths, const double* curvatures, std::size_t count, PartsAsked asked, double* parts);

}  // namespace lober::detail

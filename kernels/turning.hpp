// How much a polyline turns, and what that says about the smooth curve it stands for.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "kernels/point.hpp"

namespace lober {

/// A stand-in for the angle (radians) by which the direction turns at b: 2 tan(angle / 2), which agrees with it to
/// third order, exceeds it for corners, and is cut off at 4 (an angle of 127 degrees). `ab` and `bc` are the lengths of
/// the two segments; 0 when one of them is 0. No trigonometry.
[[nodiscard]] inline double turning(Point a, Point b, Point c, double ab, double bc) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - b.x, vy = c.y - b.y;
  const double sine = std::fabs(ux * vy - uy * vx);    // times both lengths, as is
  const double below = ab * bc + (ux * vx + uy * vy);  // 1 + cosine
  return 2 * sine < 4 * below ? 2 * sine / below : ab * bc > 0 ? 4.0 : 0.0;
}

/// The curvature at b of the smooth curve through a, b, c: the turning over the mean length of the segments.
[[nodiscard]] inline double vertex_curvature(Point a, Point b, Point c, double ab, double bc) {
  const double angle = turning(a, b, c, ab, bc);
  return angle > 0 ? 2 * angle / (ab + bc) : 0.0;
}

/// The lengths of `segments` segments in a row, which have segments + 1 points, and the curvatures at the vertices
/// between them: curvatures[k] at points[k + 1]. The same bits as vertex_curvature, several times faster.
void turns_along(const Point* points, std::size_t segments, double* lengths, double* curvatures);

/// The largest distance between a segment of this length and the smooth curve over it: kappa h^2 / 8, the sagitta, with
/// kappa the larger of the curvatures at its ends. Never more than half the length, because `turning` is cut off.
[[nodiscard]] inline double sagitta(double length, double curvature_before, double curvature_after) {
  return std::max(curvature_before, curvature_after) * length * length / 8;
}

/// What parts of a segment must keep to: the sagitta and the length, and how many parts are counted at most.
struct PartsAsked {
  double tolerance, longest, most;
};
/// Into how many parts, a real number, segments of these lengths and curvatures have to be cut; `most` where that is no
/// number.
void parts_needed(const double* lengths, const double* curvatures, std::size_t count, PartsAsked asked, double* parts);

}  // namespace lober

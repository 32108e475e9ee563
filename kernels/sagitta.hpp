// The area between a segment and the smooth curve that it stands for.
#pragma once

#include <cstddef>

#include "kernels/point.hpp"

namespace lober::detail {

/// Twice the signed area between the segment p1 -> p2 and a cubic through both with the tangents of the parabolas
/// (chordal parameter) through p0 p1 p2 and p1 p2 p3; positive when the curve bends to the right of the segment, i.e.
/// outwards on a counter-clockwise curve. For a smooth curve the leading term kappa h^3 / 6 is right, the error is of
/// order h^5. A vertex where the direction turns by more than 45 degrees, or where the curvature is more than eight
/// times that at the other end of the segment, is taken for a corner: the cubic starts there along the segment. An
/// estimate in plain double: segments shorter than 1e-150 have none. With Hermite form z = m1 H10 + e H01 + m2 H11 the
/// area is (|m1 e| + |e m2|) / 10 - |m1 m2| / 60.
[[nodiscard]] double twice_chord_area(Point p0, Point p1, Point p2, Point p3);

/// The areas of `count` segments in a row, the same bits, in a fraction of the time: segment k runs from points[k + 1]
/// to points[k + 2], so there are count + 3 points.
void twice_chord_areas(const Point* points, std::size_t count, double* areas);

/// Sums over segments a -> b of c = cross(a - o, b - o), of c (a - o + b - o), of their lengths and of the absolute
/// values of their chord areas. In plain double: with o on the curve a closed loop of length l and width w loses about
/// l / w ulps.
struct ArcMeasures {
  double twice_area = 0, moment_x = 0, moment_y = 0, length = 0, chord_area = 0;
};

/// Adds those of `count` segments: points[1] -> ... -> points[count + 1]; points[0] and points[count + 2] are their
/// neighbours. The same bits on every machine.
void add_arc_measures(const Point* points, std::size_t count, Point origin, ArcMeasures& sums);

/// The part of it before parameter t of the segment, as a fraction: the chord-to-arc area of a parabola, 3 t^2 - 2 t^3.
[[nodiscard]] inline double sagitta_fraction(double t) {
  return t * t * (3 - 2 * t);
}

}  // namespace lober::detail

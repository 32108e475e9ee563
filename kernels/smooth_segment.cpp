#include "kernels/smooth_segment.hpp"

namespace lober::detail {
Point SmoothSegment::at(double u) const {
  const double y = u * (f[1] + u * (f[2] + u * (f[3] + u * (f[4] + u * f[5]))));
  return {u * chord.x - y * chord.y, u * chord.y + y * chord.x};
}

Point SmoothSegment::velocity(double u) const {
  const double slope = f[1] + u * (2 * f[2] + u * (3 * f[3] + u * (4 * f[4] + u * 5 * f[5])));
  return {chord.x - slope * chord.y, chord.y + slope * chord.x};
}

double SmoothSegment::chord_area(double u) const {
  // A term c u^k of f leaves c u^(k + 1) (1 - 2 / (k + 1)).
  const double sum = u * u * u * (f[2] * (1.0 / 3) + u * (f[3] * 0.5 + u * (f[4] * 0.6 + u * f[5] * (2.0 / 3))));
  return dot(chord, chord) * sum;
}

SmoothSegment fit_smooth_segment(const std::array<Point, 8>& p) {
  const Point* window = p.data();
  SmoothSegment segment;
  fit_smooth_segments(&window, 1, &segment);
  return segment;
}

}  // namespace lober::detail

// The area of one smooth closed curve.

#include <cmath>

#include "engine/geometry/curve/scaled.hpp"
#include "engine/geometry/smooth/chord_areas.hpp"
#include "kernels/box.hpp"
#include "lober/overlay/smooth.hpp"

namespace lober {
using namespace detail;

SmoothArea smooth_area(const ClosedCurve& curve) {
  validate(curve, "smooth area");
  const int exponent = scaling_exponent(box_of(curve.points()));
  std::vector<Point> points;
  if (exponent != 0) points = scaled(curve, exponent);
  const CurveView scaled = exponent != 0 ? CurveView{points, true} : CurveView(curve);
  const ChordAreaTable sums((SmoothCurve(scaled)));
  SmoothArea result;
  const double scale = std::ldexp(0.5, -2 * exponent), polygon = signed_area(scaled);
  result.area = scaled_area(2 * polygon + sums.total().area.hi + sums.total().area.lo, -1 - 2 * exponent);
  result.error = scale * sums.total().error + std::fabs(result.area) * 0x1p-50;
  result.fallback_segments = sums.fallbacks();
  return result;
}

}  // namespace lober

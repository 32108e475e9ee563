#include "engine/geometry/views.hpp"

#include "engine/geometry/curve/require.hpp"

namespace lober::detail {

Overlay overlay(CurveView c1, CurveView c2, const OverlayOptions& options) {
  require_region(c1, "curve 1", "overlay");
  require_region(c2, "curve 2", "overlay");
  return overlay(ClosedCurve::borrow(c1.points), ClosedCurve::borrow(c2.points), options);
}

InteriorAreas interior_areas(CurveView c1, CurveView c2, const InteriorOptions& options) {
  require_closed(c1, "curve 1", "interior");
  require_closed(c2, "curve 2", "interior");
  return interior_areas(ClosedCurve::borrow(c1.points), ClosedCurve::borrow(c2.points), options);
}

Regions regions(CurveView c1, std::optional<CurveView> c2, const RegionOptions& options) {
  require_region(c1, "curve 1", "regions");
  const ClosedCurve first = ClosedCurve::borrow(c1.points);
  if (!c2) return regions(first, options);
  require_region(*c2, "curve 2", "regions");
  return regions(first, ClosedCurve::borrow(c2->points), options);
}

Tangle tangle(CurveView u, CurveView s, const TangleOptions& options) {
  require_open(u, "U", "tangle");
  require_open(s, "S", "tangle");
  return tangle(OpenCurve::borrow(u.points), OpenCurve::borrow(s.points), options);
}

SmoothArea smooth_area(CurveView curve) {
  require_closed(curve, "the curve", "smooth area");
  return smooth_area(ClosedCurve::borrow(curve.points));
}

CommonArea common_area(CurveView first, CurveView second) {
  require_region(first, "curve 1", "overlay");
  require_region(second, "curve 2", "overlay");
  return common_area(ClosedCurve::borrow(first.points), ClosedCurve::borrow(second.points));
}

}  // namespace lober::detail

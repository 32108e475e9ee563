// The operations on views, for tests that hold points in vectors: the public functions, with the points borrowed. Where
// a curve is not of the kind that is wanted, the functions on indexed curves say so.
#pragma once

#include <optional>

#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"
#include "lober/overlay/smooth.hpp"
#include "lober/tangle/tangle.hpp"

namespace lober::detail {

[[nodiscard]] inline Overlay overlay(CurveView c1, CurveView c2, const OverlayOptions& options = {}) {
  if (!c1.closed || !c2.closed) return lober::overlay(IndexedCurve(c1), IndexedCurve(c2), options);
  return lober::overlay(ClosedCurve::borrow(c1.points), ClosedCurve::borrow(c2.points), options);
}

[[nodiscard]] inline InteriorAreas interior_areas(CurveView c1, CurveView c2, const InteriorOptions& options = {}) {
  if (!c1.closed || !c2.closed) return lober::interior_areas(IndexedCurve(c1), IndexedCurve(c2), options);
  return lober::interior_areas(ClosedCurve::borrow(c1.points), ClosedCurve::borrow(c2.points), options);
}

[[nodiscard]] inline Regions regions(CurveView curve, const RegionOptions& options = {}) {
  if (!curve.closed) return lober::regions(IndexedCurve(curve), options);
  return lober::regions(ClosedCurve::borrow(curve.points), options);
}
[[nodiscard]] inline Regions regions(CurveView c1, CurveView c2, const RegionOptions& options = {}) {
  if (!c1.closed || !c2.closed) return lober::regions(IndexedCurve(c1), IndexedCurve(c2), options);
  return lober::regions(ClosedCurve::borrow(c1.points), ClosedCurve::borrow(c2.points), options);
}

[[nodiscard]] inline Tangle tangle(CurveView u, CurveView s, const TangleOptions& options = {}) {
  if (u.closed || s.closed) return lober::tangle(IndexedCurve(u), IndexedCurve(s), options);
  return lober::tangle(OpenCurve::borrow(u.points), OpenCurve::borrow(s.points), options);
}

[[nodiscard]] inline SmoothArea smooth_area(CurveView curve) {
  return lober::smooth_area(ClosedCurve::borrow(curve.points));
}

[[nodiscard]] inline CommonArea common_area(CurveView first, CurveView second) {
  return lober::common_area(ClosedCurve::borrow(first.points), ClosedCurve::borrow(second.points));
}

}  // namespace lober::detail

// Areas between smooth curves: those that run through the points, not along the segments between them.
//
// Each segment is replaced by a graph over it through the six nearest vertices (kernels/smooth_segment.hpp), so that
// areas have an error of order h^6, h the length of segments, where the curves are smooth, against h^2 of polygons.
// Each crossing is moved to where the smooth curves cross. At corners, and where the points beside a segment are noise,
// the segment stays.
//
//   lober::Overlay result = lober::overlay(c1, c2);
//   lober::SmoothAreas smooth = lober::smooth_areas(result);
//   use(smooth.areas.c1_minus_c2, smooth.error.c1_minus_c2);
#pragma once

#include <cstdint>

#include "lober/base/export.hpp"
#include "lober/curve/curve.hpp"
#include "lober/overlay/areas.hpp"
#include "lober/overlay/overlay.hpp"

namespace lober {

/// Areas between smooth curves through the vertices.
struct SmoothAreas {
  Areas areas;  ///< the areas
  /// Estimates of |areas - area of the smooth curves that the points were taken from|, on the safe side: for each arc
  /// three times the change that the next two vertices would make (kernels/smooth_segment.hpp), without regard to
  /// signs; the area that an unmoved crossing may hide, and that of lobes where only the smooth curves cross; rounding.
  Areas error;
  std::uint64_t fallback_segments = 0;   ///< segments of both curves, not of length zero, that stay straight
  std::uint64_t fallback_crossings = 0;  ///< crossings at a point that stay where the polygons have them, for lack of a
                                         ///< crossing of the smooth curves near by that keeps its order along both
};

/// The smooth areas that belong to a result of `overlay` (pieces are not needed). The topology is that of the polygons:
/// crossings of smooth curves whose polygons pass by each other are not found; the area between them is in the error. A
/// shared arc stays shared, with the geometry of C1. Throws DataError when coordinates range too widely. O(n + m),
/// parallel; the same bits for any number of threads.
[[nodiscard]] LOBER_API SmoothAreas smooth_areas(const Overlay& result);

/// The area of one smooth curve.
struct SmoothArea {
  double area = 0;                      ///< signed, positive counter-clockwise
  double error = 0;                     ///< as in SmoothAreas
  std::uint64_t fallback_segments = 0;  ///< segments, not of length zero, that stay straight
};

/// The area of one closed curve, in the same sense; where it crosses itself, weighted by winding numbers. Throws
/// DataError as `validate` does. O(n), parallel.
[[nodiscard]] LOBER_API SmoothArea smooth_area(const ClosedCurve& curve);

/// An area that two curves have in common.
struct CommonArea {
  double area = 0, error = 0;  ///< the area, and its error bar
};

/// The area that two closed curves have in common. The error is of order h^6 where the polygons are simple; else the
/// area is by winding numbers of the polygons, with an error bar for the difference to the smooth curves. Throws as
/// smooth_areas and regions do.
[[nodiscard]] LOBER_API CommonArea common_area(const ClosedCurve& first, const ClosedCurve& second);

/// The integral over the plane of the product of the winding numbers of two closed curves of any shape: their common
/// area, each part as often as both wind round it, negative where one of them winds the other way. The error is of
/// order h^6 except on arcs that the other curve crosses, when they are not simple: there it is of order h^2, and in
/// the error bar. Zero for a curve of fewer than three distinct vertices. Throws DataError as smooth_areas and regions
/// do. Takes the time of `regions` and of a point query for each vertex in the box of the other curve.
[[nodiscard]] LOBER_API CommonArea winding_product(const ClosedCurve& first, const ClosedCurve& second);

}  // namespace lober

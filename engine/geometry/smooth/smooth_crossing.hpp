// The crossing of two smooth curves near a crossing of their polygons (private to smooth/).
#pragma once

#include <optional>

#include "engine/geometry/crossings/contacts.hpp"
#include "engine/geometry/smooth/smooth_curve.hpp"

namespace lober::detail {

struct SmoothCrossing {
  SmoothPosition position1, position2;
};

/// Newton's iteration in the two parameters from the contact of the polygons, over at most two segments on either side.
/// The crossing; nothing unless it converges to a point where C2 passes C1 in the given sense (from right to left, as
/// the input runs).
[[nodiscard]] std::optional<SmoothCrossing> find_smooth_crossing(const SmoothCurve& c1, const SmoothCurve& c2,
                                                                 const Contact& contact, bool rightward_to_left);

/// The terms that one contact adds to the running sums of chord-to-arc areas before its two segments, so that they
/// reach the point where both curves pass; `uncertainty` is twice the area that may hide where the smooth curves do not
/// meet in that point, and the errors of the two segments.
struct EndOfArcs {
  double on1 = 0, on2 = 0;
  double uncertainty = 0;
};

/// The end of arcs at the moved crossing, or at the contact where there is none. The sum of (v_i - o) x (v_{i+1} - o)
/// up to the common point Q less that of the polygon up to its contact P is that of the loop from P along the polygon
/// to the segment of Q, along the smooth curve to Q and straight back, and P x Q, which is left out: it is the same for
/// both curves and cancels in every region.
[[nodiscard]] EndOfArcs end_of_arcs(const SmoothCurve& c1, const SmoothCurve& c2, const Contact& contact,
                                    const std::optional<SmoothCrossing>& crossing);

}  // namespace lober::detail

// Walking the boundary of a piece arc by arc (private to overlay/).
#pragma once

#include <vector>

#include "engine/overlay/overlay.hpp"

namespace lober {

/// A stretch of a curve between two contacts. `from` and `to` are contact numbers and follow each other in the
/// direction of the walk; `forward` says whether that is the direction of the input. Whole curves have no contacts:
/// from == to == none.
struct Stretch {
  static constexpr std::uint32_t none = 0xffffffff;
  int curve;  ///< 1 or 2
  bool forward;
  std::uint32_t from, to;
};

/// The boundary that the steps of a piece (Pieces::outer, Pieces::Hole) stand for, shared arcs included (as parts of
/// C1). `keeps_left1`, `keeps_left2`: whether the walk runs along C1 (C2) counter-clockwise.
[[nodiscard]] std::vector<Stretch> stretches(const Overlay& result, std::span<const std::uint32_t> steps, bool forward1,
                                             bool forward2);

/// Directions (as the input runs) in which the boundary of pieces of a pairing runs along the two curves.
struct Directions {
  bool forward1, forward2;
};
[[nodiscard]] Directions directions(const Overlay& result, Pairing pairing);

/// The vertices of a stretch, its first point included, its last one not.
void append_points(const Overlay& result, const Stretch& stretch, std::vector<Point>& points);

}  // namespace lober

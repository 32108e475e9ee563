// Walking the boundary of a piece arc by arc (private to overlay/).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lober/overlay/overlay.hpp"

namespace lober::detail {

/// An arc of a curve between two contacts. `from` and `to` are contact numbers and follow each other in the
/// direction of the walk; `forward` says whether that is the direction of the input. Whole curves have no contacts:
/// from == to == none.
struct BoundaryArc {
  static constexpr std::uint32_t none = 0xffffffff;
  int curve;  ///< 1 or 2
  bool forward;
  std::uint32_t from, to;
};

/// Directions (as the input runs) in which the boundary of pieces of a pairing runs along the two curves.
struct Directions {
  bool forward1, forward2;
};
[[nodiscard]] Directions directions(const Overlay& result, Pairing pairing);

/// The boundary that the steps `begin` to `end` of a piece (Pieces::outer, Pieces::Hole) stand for, shared arcs
/// included (as parts of C1). Those of all steps together are one closed walk.
[[nodiscard]] std::vector<BoundaryArc> boundary_arcs(const Overlay& result, std::span<const std::uint32_t> steps,
                                                     std::size_t begin, std::size_t end, Directions forward);

/// The points of an arc, its first one included, its last one not: a contact, unless the arc is a whole curve,
/// and then vertices of the curve, in up to two runs. Both runs are in the order of the input; a walk that is not
/// forward passes the second one first, each from its end.
struct ArcPoints {
  bool forward;
  bool whole;
  Point first;  ///< the contact; nothing if `whole`
  std::span<const Point> low, high;
  [[nodiscard]] std::size_t size() const { return low.size() + high.size() + (whole ? 0 : 1); }
};
[[nodiscard]] ArcPoints points_of(const Overlay& result, const BoundaryArc& arc);

/// Number of points of all these steps together. O(steps).
[[nodiscard]] std::size_t count_points(const Overlay& result, std::span<const std::uint32_t> steps, Directions forward);

}  // namespace lober::detail

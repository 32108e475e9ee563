// Shoelace sums of one curve, apart for the parts outside, on and inside the other (private to interior/).
#pragma once

#include <span>

#include "engine/geometry/interior/contacts_along.hpp"
#include "lober/overlay/interior.hpp"

namespace lober::detail {

/// Sums of cross(v_i - o, v_{i+1} - o) about one origin o, in double-double. Q1, Q2 and Q3 are combinations of them.
struct SideSums {
  DD outside, on, inside;
  double error = 0;  ///< bound on the rounding of each, the parameters of contacts taken for exact

  [[nodiscard]] DD total() const { return outside + on + inside; }
};

/// `extent` bounds the distance of the origin from the curve in the maximum norm. `after` are the labels of the parts
/// that follow the contacts; without contacts the whole curve is on side `whole`. O(N), parallel.
[[nodiscard]] SideSums sum_by_arcs(const BoxTree& tree, Point origin, double extent, const ContactsAlong& contacts,
                                   const Buffer<Side>& after, Side whole);

/// Each segment counts half for the side of either end. O(N), parallel.
[[nodiscard]] SideSums sum_by_ends(std::span<const Point> points, std::span<const Side> labels, Point origin,
                                   double extent);

}  // namespace lober::detail

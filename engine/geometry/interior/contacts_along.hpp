// The contacts of two curves as one of them meets them (private to interior/).
#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/geometry/crossings/crossings_data.hpp"
#include "lober/overlay/crossings.hpp"

namespace lober::detail {

/// A contact, seen from one curve: `own` is this curve, `other` the other one.
struct SeenContact {
  std::uint32_t own_segment, other_segment;
  DD t;                  ///< parameter on `own`
  bool at_own_vertex;    ///< at the first end of own_segment
  bool at_other_vertex;  ///< at the first end of other_segment
  bool proper;           ///< inside both segments, which cross
  bool other_goes_left;  ///< for a proper one: `other` passes from right to left of `own`
};

/// The contacts in order along curve `curve` (1 or 2), from its first vertex on.
class ContactsAlong {
 public:
  ContactsAlong(const Crossings& nodes, int curve) : graph_(graph_of(nodes)), first_(curve == 1) {}

  [[nodiscard]] std::size_t size() const { return graph_.contacts.size(); }
  [[nodiscard]] std::uint32_t segment(std::size_t k) const {
    return first_ ? graph_.contacts[k].segment1 : graph_.contacts[graph_.contacts2[k]].segment2;
  }
  [[nodiscard]] SeenContact operator[](std::size_t k) const {
    const Contact c = graph_.contacts[first_ ? k : graph_.contacts2[k]];
    if (first_) return {c.segment1, c.segment2, c.t1, c.vertex1, c.vertex2, c.proper(), c.rho > 0};
    return {c.segment2, c.segment1, c.t2, c.vertex2, c.vertex1, c.proper(), c.rho < 0};
  }
  /// The number of the first contact on segment `begin` or a later one; size() if there is none.
  [[nodiscard]] std::size_t first_from(std::size_t begin) const {
    std::size_t low = 0, high = size();
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (segment(middle) < begin) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

 private:
  const NodeGraph& graph_;
  bool first_;
};

}  // namespace lober::detail

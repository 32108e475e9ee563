// The side of each part of a curve between two contacts with the other one (private to interior/).
#pragma once

#include <array>

#include "engine/geometry/interior/contacts_along.hpp"
#include "lober/overlay/interior.hpp"

namespace lober::detail {

struct ArcLabels {
  Buffer<Side> after;         ///< side of the part that follows each contact
  std::uint64_t queries = 0;  ///< how many of them took a winding number
};

/// Labels the parts of both curves, `contacts` as either meets them. A part that has a vertex strictly inside gets the
/// label of the first one, by its winding number; a straight one is decided at the contact where it begins. All exact.
/// Parallel, O(contacts log N).
[[nodiscard]] std::array<ArcLabels, 2> label_arcs(const IndexedCurve& c1, const IndexedCurve& c2,
                                                  std::array<bool, 2> clockwise,
                                                  const std::array<ContactsAlong, 2>& contacts);

}  // namespace lober::detail

// Bounds for the common area of two lobes by sums over crossings (private to tangle/).
#pragma once

#include <algorithm>
#include <cmath>

#include "lober/tangle/tangle.hpp"

namespace lober::detail {

/// `found` with an area by sums over crossings, which have no bounds of their own where polygons of one manifold cross
/// each other although the manifold does not. The common area of two lobes is not negative, and not larger than the
/// smaller one: the error is twice the excess of the sums over these bounds, at most the smaller lobe, and all of it
/// where crossings do not leave the lobes as often as they enter them.
[[nodiscard]] inline LobeOverlap bounded(const Tangle& tangle, LobeOverlap found, double area, bool paired) {
  const double least = std::min(std::fabs(tangle.lobes[found.i].area), std::fabs(tangle.lobes[found.j].area));
  const double beyond = std::max({-area, area - least, 0.0});
  found.area = std::clamp(area, 0.0, least);
  found.error = std::max(found.error, paired ? std::min(2 * beyond, least) : least);
  return found;
}

}  // namespace lober::detail

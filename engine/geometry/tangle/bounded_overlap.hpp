// What sums over crossings may say that two lobes have in common (private to tangle/).
#pragma once

#include <algorithm>
#include <cmath>

#include "lober/tangle.hpp"

namespace lober::detail {

/// `found` with an area by sums over crossings, which have no bounds of their own where polygons of one manifold cross
/// each other although the manifold does not. Two lobes have nothing less than nothing in common, and no more than the
/// smaller one of them: by twice what the sums are beyond they may be wrong, and by all of it where crossings do not
/// leave the lobes as often as they enter them.
[[nodiscard]] inline LobeOverlap bounded(const Tangle& tangle, LobeOverlap found, double area, bool paired) {
  const double least = std::min(std::fabs(tangle.lobes[found.i].area), std::fabs(tangle.lobes[found.j].area));
  const double beyond = std::max({-area, area - least, 0.0});
  found.area = std::clamp(area, 0.0, least);
  found.error = std::max(found.error, paired ? std::min(2 * beyond, least) : least);
  return found;
}

}  // namespace lober::detail

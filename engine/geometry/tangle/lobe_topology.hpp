// The positions of the fixed points as seen from a lobe, and whether its arcs meet (private to tangle/).
//
// U[p-, q_k] meets neither arc of lobe k, nor does S[p+, q_k+1]; so p- lies in lobe k if and only if U comes to pip k
// from inside the lobe, which makes that corner reflex, and rho tells. Likewise p+ at pip k + 1.
#pragma once

#include "lober/tangle/tangle.hpp"

namespace lober::detail {

[[nodiscard]] inline bool holds_start_of_u(const Tangle& tangle, std::size_t lobe) {
  return tangle.lobes[lobe].orientation() == tangle.pips[lobe].rho;
}
[[nodiscard]] inline bool holds_start_of_s(const Tangle& tangle, std::size_t lobe) {
  return tangle.lobes[lobe].orientation() == -tangle.pips[lobe + 1].rho;
}

/// Sets `simple` of every lobe: false where U and S touch, or run along each other without crossing, within both its
/// arcs. O(nodes).
void mark_pinched_lobes(Tangle& tangle);

}  // namespace lober::detail

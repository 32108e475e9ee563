// Sums along both manifolds up to a crossing (private to tangle/).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/tangle/curves.hpp"
#include "lober/overlay/crossings.hpp"

namespace lober::detail {

struct SumsToNode {
  DD gap;                             ///< D, of smooth curves if the tangle is made of them
  double error_u = 0, error_s = 0;    ///< twice the estimated errors of areas along U and S
  double uncertainty = 0;             ///< twice the area that may hide at the crossing itself
  double length_u = 0, length_s = 0;  ///< in the caller's units
};

/// The sums at nodes of U and S, which ascend. Like gaps_at, and O(N + M).
[[nodiscard]] std::vector<SumsToNode> sums_to_nodes(const TangleCurves& curves, const Crossings& crossings,
                                                    std::span<const std::uint32_t> nodes);

}  // namespace lober::detail

// The images of lobes under the map (private to tangle/).
#pragma once

#include "lober/tangle/tangle.hpp"

namespace lober::detail {

/// Fills in `images`. A period fits if signed areas repeat with it to `repeat_tolerance` of their mean; the smallest
/// even one that fits is taken (an orientation-preserving map takes pips of one rho to pips of the same).
inline constexpr double repeat_tolerance = 0.05;
[[nodiscard]] Images find_images(const Tangle& tangle, std::uint32_t given_period);

}  // namespace lober::detail

#include "engine/geometry/regions/edge_chains.hpp"

namespace lober::detail {

std::uint32_t EdgeChains::next(std::uint32_t number) const {
  const CurveView& on = curve(curve_of(number));
  const std::uint32_t begin = first_of(curve_of(number)), end = begin + count_of(on);
  for (std::uint32_t k = number;;) {
    k = k + 1 == end ? begin : k + 1;
    const auto [a, b] = segment(k);
    if (!(a == b) || k == number) return k;
  }
}

std::uint32_t EdgeChains::previous(std::uint32_t number) const {
  const CurveView& on = curve(curve_of(number));
  const std::uint32_t begin = first_of(curve_of(number)), end = begin + count_of(on);
  for (std::uint32_t k = number;;) {
    k = k == begin ? end - 1 : k - 1;
    const auto [a, b] = segment(k);
    if (!(a == b) || k == number) return k;
  }
}

}  // namespace lober::detail

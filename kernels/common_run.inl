// Body of common_vertices (kernels/all.inl).
#pragma once

#include <cstdint>

#include "kernels/common_run.hpp"
#include "kernels/eight.hpp"

namespace lober::detail {
namespace {

// Both curves come from far away in memory as a rule.
LOBER_INLINE void fetch_distant(const Point* from, std::ptrdiff_t points) {
  __builtin_prefetch(reinterpret_cast<const void*>(reinterpret_cast<std::intptr_t>(from) +
                                                   points * static_cast<std::ptrdiff_t>(sizeof(Point))));
}

inline std::size_t count_common(const Point* a, const Point* b, int direction, std::size_t count) {
  constexpr std::size_t points = widest / 2;
  constexpr std::ptrdiff_t ahead = 512;
  constexpr unsigned all = (1U << widest) - 1, x_bits = 0x55U;
  std::size_t n = 0;
  for (; n + points <= count; n += points) {
    const auto step = static_cast<std::ptrdiff_t>(n);
    const Widest before = load_widest(&a[step].x), here = load_widest(&a[step + 1].x);
    const Widest other = direction > 0 ? load_widest(&b[step + 1].x)
                                       : pairs_reversed(load_widest(&b[-step - static_cast<std::ptrdiff_t>(points)].x));
    fetch_distant(a + n, ahead);
    fetch_distant(b, direction * (step + ahead));
    const unsigned stays = mask_bits(equal(here, before));
    if (mask_bits(equal(here, other)) != all || (stays & stays >> 1U & x_bits) != 0) break;
  }
  return n;
}

}  // namespace
}  // namespace lober::detail

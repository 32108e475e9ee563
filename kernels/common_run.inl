// Body of common_vertices (kernels/all.inl).
#pragma once

#include <cstddef>

#include "kernels/common_run.hpp"
#include "kernels/eight.hpp"
#include "kernels/fetch.hpp"

namespace lober::detail {
namespace {

inline std::size_t count_common(const Point* a, const Point* b, int direction, std::size_t count) {
  constexpr std::size_t points = widest / 2;
  constexpr unsigned all = (1U << widest) - 1, x_bits = 0x55U;
  std::size_t n = 0;
  for (; n + points <= count; n += points) {
    const auto step = static_cast<std::ptrdiff_t>(n);
    const Widest before = load_widest(&a[step].x), here = load_widest(&a[step + 1].x);
    const Widest other = direction > 0 ? load_widest(&b[step + 1].x)
                                       : pairs_reversed(load_widest(&b[-step - static_cast<std::ptrdiff_t>(points)].x));
    fetch(a + step, bytes_ahead);
    fetch(b + direction * step, direction * bytes_ahead);
    const unsigned stays = mask_bits(equal(here, before));
    if (mask_bits(equal(here, other)) != all || (stays & stays >> 1U & x_bits) != 0) break;
  }
  return n;
}

}  // namespace
}  // namespace lober::detail

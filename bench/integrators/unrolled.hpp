// Loops that are written out by the compiler, so that zeros of a table cost nothing.
#pragma once

#include <type_traits>
#include <utility>

#include "kernels/inline.hpp"

namespace lober::bench {

/// f(0), f(1), ..., f(count - 1), each argument a constant of its own type.
template <int count, typename F>
LOBER_INLINE void unrolled(const F& f) {
  [&]<int... k>(std::integer_sequence<int, k...>) __attribute__((always_inline)) {
    (f(std::integral_constant<int, k>{}), ...);
  }
  (std::make_integer_sequence<int, count>{});
}

}  // namespace lober::bench

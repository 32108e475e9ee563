// Sine and cosine of any kind of number (kernels/wide.hpp), with the same bits on every instruction set.
//
// Cody & Waite reduction by multiples of pi in three parts, then a minimax polynomial of degree 17 (relative
// error 3.4e-19 times x^2), without a branch. kernels/sine.hpp has the error that tests find.
#pragma once

#include "kernels/wide.hpp"

namespace lober::detail {

/// Adding it rounds to an integer, whose last bit is then that of the sum.
inline constexpr double rounding_shift = 0x1.8p52;
inline constexpr double one_over_pi = 0.31830988618379067;

/// sin(x - turns * pi).
template <typename V>
LOBER_INLINE V sine_less_turns(V x, V turns) {
  constexpr double pi_high = 0x1.921fb54p+1, pi_middle = 0x1.10b461p-29, pi_low = 0x1.a62633145c06ep-57;
  const V r = ((x - turns * pi_high) - turns * pi_middle) - turns * pi_low;
  const V u = r * r;
  V sum = 2.731428986122616e-15;
  sum = sum * u - 7.643969031052769e-13;
  sum = sum * u + 1.6058977272815506e-10;
  sum = sum * u - 2.5052107616384595e-08;
  sum = sum * u + 2.755731921915843e-06;
  sum = sum * u - 0.00019841269841254955;
  sum = sum * u + 0.008333333333333316;
  sum = sum * u - 0.16666666666666666;
  return r + r * (u * sum);
}

template <typename V>
LOBER_INLINE V sine(V x) {
  const V rounded = x * one_over_pi + rounding_shift;
  return negated_if_odd(sine_less_turns(x, rounded - rounding_shift), rounded);
}

template <typename V>
LOBER_INLINE V cosine(V x) {
  const V rounded = (x * one_over_pi - 0.5) + rounding_shift;
  return -negated_if_odd(sine_less_turns(x, (rounded - rounding_shift) + 0.5), rounded);
}

}  // namespace lober::detail

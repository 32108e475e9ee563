// Compiled once for every machine and once for AVX2 (kernels/inline.hpp).

namespace {

inline double sine(double x) {
  // Adding 1.5 2^52 rounds to an integer, whose last bit is then that of the sum.
  constexpr double shift = 0x1.8p52;
  constexpr double one_over_pi = 0.31830988618379067;
  constexpr double pi_high = 0x1.921fb54p+1, pi_middle = 0x1.10b461p-29, pi_low = 0x1.a62633145c06ep-57;
  const double rounded = x * one_over_pi + shift;
  const double turns = rounded - shift;
  const double r = ((x - turns * pi_high) - turns * pi_middle) - turns * pi_low;
  const double u = r * r;
  double sum = 2.731428986122616e-15;
  sum = sum * u - 7.643969031052769e-13;
  sum = sum * u + 1.6058977272815506e-10;
  sum = sum * u - 2.5052107616384595e-08;
  sum = sum * u + 2.755731921915843e-06;
  sum = sum * u - 0.00019841269841254955;
  sum = sum * u + 0.008333333333333316;
  sum = sum * u - 0.16666666666666666;
  const double value = r + r * (u * sum);
  const std::uint64_t sign = __builtin_bit_cast(std::uint64_t, rounded) << 63U;
  return __builtin_bit_cast(double, __builtin_bit_cast(std::uint64_t, value) ^ sign);
}

inline void add(double* __restrict y, const double* __restrict x, double factor, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) y[k] += factor * sine(x[k]);
}

}  // namespace

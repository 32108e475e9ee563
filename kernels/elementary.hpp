// Elementary functions with the same bits on every machine.
//
// The functions of the C library are chosen at run time by what the processor has, and versions of the library differ
// in last digits. Results of flows and manifolds must not. Each function here is a fixed sequence of additions,
// multiplications, divisions and square roots, which IEEE 754 rounds in one way only; nothing is fused
// (-ffp-contract=off). Errors are bounded by tests/kernels/elementary_test.cpp against 80 digits.
#pragma once

namespace lober::detail::elementary {

/// Errors below 1 ulp; infinite above 709.78, zero below -745.2.
[[nodiscard]] double exp(double x);
/// exp(x) - 1, below 3.5 ulp, also for small x.
[[nodiscard]] double expm1(double x);
/// Below 1 ulp; -inf at 0, NaN below.
[[nodiscard]] double log(double x);
/// log(1 + x), below 2 ulp, also for small x.
[[nodiscard]] double log1p(double x);
[[nodiscard]] double log10(double x);  ///< below 2 ulp
/// x^n by repeated squaring: below n ulp.
[[nodiscard]] double power(double x, int n);
/// x^y for x > 0: exp(y log x), with a relative error of 2^-52 (1 + |y log x|); x^n if y is a whole number below 1024.
[[nodiscard]] double power(double x, double y);
[[nodiscard]] double cbrt(double x);  ///< below 1 ulp

/// Below 2.5 ulp for |x| < 1e8 (kernels/trigonometric.hpp).
[[nodiscard]] double sin(double x);
[[nodiscard]] double cos(double x);
/// Below 1.5 ulp, for all quadrants and zeros as the function of that name in C.
[[nodiscard]] double atan2(double y, double x);
[[nodiscard]] double atan(double x);
[[nodiscard]] double asin(double x);  ///< below 3 ulp

/// The modified Bessel function I_n, n >= 0, by its power series: below 20 ulp for |x| < 30, n < 30.
[[nodiscard]] double bessel_i(int n, double x);

}  // namespace lober::detail::elementary

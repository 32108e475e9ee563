#include "kernels/elementary.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include "kernels/trigonometric.hpp"

namespace lober::detail::elementary {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double ln2_high = 0x1.62e42feep-1, ln2_low = 0x1.a39ef35793c76p-33;

// (exp(r) - 1 - r) / r^2 for |r| < 0.35: Taylor's series, off by 2e-19.
double exp_tail(double r) {
  double sum = 1.0 / 1307674368000.0;
  for (const double inverse :
       {1.0 / 87178291200.0, 1.0 / 6227020800.0, 1.0 / 479001600.0, 1.0 / 39916800.0, 1.0 / 3628800.0, 1.0 / 362880.0,
        1.0 / 40320.0, 1.0 / 5040.0, 1.0 / 720.0, 1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 1.0 / 2.0})
    sum = sum * r + inverse;
  return sum;
}

// x = turns ln 2 + high + low.
struct Reduced {
  int turns;
  double high, low;
};
Reduced reduced(double x) {
  const double turns = (x * 1.4426950408889634 + rounding_shift) - rounding_shift;
  const double rest = x - turns * ln2_high, away = turns * ln2_low;
  const double high = rest - away;
  return {static_cast<int>(turns), high, (rest - high) - away};
}

// 2 artanh(s) - 2 s for |s| < 0.172, divided by s: in s^2, off by 1e-19.
double artanh_tail(double s) {
  const double z = s * s;
  double sum = 2.0 / 23;
  for (const double odd : {21.0, 19.0, 17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0}) sum = sum * z + 2 / odd;
  return sum * z;
}

// log(1 + f) for 1 + f between sqrt(1/2) and sqrt(2), plus turns ln 2.
double log_near_one(double f, int turns) {
  // With s = f / (2 + f): log(1 + f) = 2 artanh(s) = f - s (f - tail), of which f is exact.
  const double s = f / (2 + f);
  const double rest = s * (artanh_tail(s) - f);
  const double k = turns;
  if (turns == 0) return f + rest;
  return k * ln2_high + ((rest + k * ln2_low) + f);
}

// atan(t) / t for |t| <= 7/16, in t^2: the best polynomial of degree 11, off by 4e-18.
double atan_near_zero(double t) {
  const double z = t * t;
  double sum = -0x1.08cc92775f023p-6;
  for (const double c : {0x1.2a2c6a72d4220p-5, -0x1.9731ddca75216p-5, 0x1.ddc0156c194e1p-5, -0x1.10d3874d7f1acp-4,
                         0x1.3b0edb6230582p-4, -0x1.745cd6bfd62fep-4, 0x1.c71c6fa269ce5p-4, -0x1.2492491f2c78dp-3,
                         0x1.999999998b832p-3, -0x1.55555555554e2p-2})
    sum = sum * z + c;
  return t + t * (z * sum);
}

// An angle in two parts.
struct Angle {
  double high, low;
};
constexpr Angle quarter{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54}, half{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

// atan(y / x) for 0 <= y, 0 < x, y <= x: from the nearest of three angles whose tangents are 0, 1/2 and 1.
double atan_of_ratio(double y, double x) {
  constexpr Angle of_half{0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56};
  constexpr Angle of_one{0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55};
  if (y < 0.4375 * x) return atan_near_zero(y / x);
  if (y < 0.6875 * x) return of_half.high + (atan_near_zero((2 * y - x) / (2 * x + y)) + of_half.low);
  return of_one.high + (atan_near_zero((y - x) / (x + y)) + of_one.low);
}

}  // namespace

double exp(double x) {
  if (std::isnan(x)) return x;
  if (x > 709.8) return infinity;
  if (x < -745.2) return 0;
  const Reduced r = reduced(x);
  // exp(high + low), low below an ulp of high.
  const double tail = r.high * r.high * exp_tail(r.high) + r.low * (1 + r.high);
  return std::ldexp(1 + (r.high + tail), r.turns);
}

double expm1(double x) {
  if (!(std::fabs(x) < 0.35)) return exp(x) - 1;
  return x + x * x * exp_tail(x);
}

double log(double x) {
  if (!(x > 0)) return x == 0 ? -infinity : std::numeric_limits<double>::quiet_NaN();
  if (std::isinf(x)) return x;
  int turns = 0;
  double part = std::frexp(x, &turns);
  if (part < 0.70710678118654752) {
    part *= 2;
    --turns;
  }
  return log_near_one(part - 1, turns);
}

double log1p(double x) {
  if (x > -0.29 && x < 0.41) return log_near_one(x, 0);
  const double sum = 1 + x;
  if (!(sum > 0) || std::isinf(sum)) return log(sum);
  return log(sum) + (x < 1 ? x - (sum - 1) : 1 - (sum - x)) / sum;
}

double log10(double x) {
  return log(x) * 0.43429448190325182765;
}

double power(double x, int n) {
  double result = 1;
  for (std::uint64_t rest = static_cast<std::uint64_t>(std::abs(static_cast<long long>(n))); rest != 0; rest >>= 1U) {
    if ((rest & 1U) != 0) result *= x;
    x *= x;
  }
  return n < 0 ? 1 / result : result;
}

double power(double x, double y) {
  if (std::fabs(y) < 1024 && y == std::floor(y)) return power(x, static_cast<int>(y));
  return exp(y * log(x));
}

double cbrt(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  double root = exp(log(std::fabs(x)) / 3);
  root -= (root - std::fabs(x) / (root * root)) / 3;
  return std::copysign(root, x);
}

double sin(double x) {
  return sine(x);
}

double cos(double x) {
  return cosine(x);
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
  double a = std::fabs(x), b = std::fabs(y);
  // Ratios of these do not leave the range of double, nor do sums.
  if (std::isinf(a) || std::isinf(b)) {
    a = std::isinf(a) ? 1 : 0;
    b = std::isinf(b) ? 1 : 0;
  } else if (a > 0x1p1000 || b > 0x1p1000) {
    a *= 0x1p-30;
    b *= 0x1p-30;
  } else if (a < 0x1p-900 && b < 0x1p-900) {
    a *= 0x1p100;
    b *= 0x1p100;
  }
  double angle = 0;
  if (b <= a) {
    if (b > 0) angle = atan_of_ratio(b, a);
    if (std::signbit(x)) angle = half.high - (angle - half.low);
  } else {
    const double rest = a > 0 ? atan_of_ratio(a, b) : 0;
    angle = std::signbit(x) ? quarter.high + (rest + quarter.low) : quarter.high - (rest - quarter.low);
  }
  return std::copysign(angle, y);
}

double atan(double x) {
  return atan2(x, 1);
}

double asin(double x) {
  return atan2(x, std::sqrt((1 - x) * (1 + x)));
}

double bessel_i(int n, double x) {
  const double square = 0.25 * x * x;
  double first = 1;
  for (int k = 1; k <= n; ++k) first *= 0.5 * x / k;
  double term = 1, sum = 1;
  for (int k = 1; term > 0x1p-60 * sum; ++k) {
    term *= square / (static_cast<double>(k) * (n + k));
    sum += term;
  }
  return first * sum;
}

}  // namespace lober::detail::elementary

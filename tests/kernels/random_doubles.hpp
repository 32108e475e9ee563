// Doubles and points on which numerics go wrong, and their exact values.
#pragma once

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <limits>
#include <string>

#include "kernels/double_double.hpp"
#include "kernels/point.hpp"
#include "tests/oracle/random.hpp"

namespace lober::test {
using namespace lober::detail;

using oracle::Random;

/// LOBER_SEED, or 1; recorded in the report of the running test.
inline std::uint64_t seed() {
  const char* text = std::getenv("LOBER_SEED");
  const std::uint64_t value = text != nullptr ? std::strtoull(text, nullptr, 10) : 1;
  ::testing::Test::RecordProperty("seed", std::to_string(value));
  return value;
}

/// Any finite double: every exponent is as likely as any other.
inline double any_finite(Random& random) {
  for (;;) {
    const auto value = std::bit_cast<double>(random.bits());
    if (std::isfinite(value)) return value;
  }
}

/// A random sign and mantissa, an exponent in [low, high].
inline double with_exponent(Random& random, int low, int high) {
  const double mantissa = random.uniform(1, 2) * (random.chance(0.5) ? 1 : -1);
  return std::ldexp(mantissa, random.integer(low, high));
}

/// The double `steps` places further up (down, if negative).
inline double neighbour(double value, int steps) {
  const double target = steps > 0 ? std::numeric_limits<double>::max() : -std::numeric_limits<double>::max();
  for (int k = 0; k < std::abs(steps); ++k) value = std::nextafter(value, target);
  return value;
}
inline Point neighbour(Random& random, Point point, int steps) {
  return {neighbour(point.x, random.integer(-steps, steps)), neighbour(point.y, random.integer(-steps, steps))};
}

/// value / 2^exponent, which must be an integer.
inline mpz_class integer_of(double value, int exponent) {
  if (value == 0) return 0;
  int binary = 0;
  const double mantissa = std::ldexp(std::frexp(value, &binary), 53);
  mpz_class result(mantissa);
  const int shift = binary - 53 - exponent;
  if (shift >= 0) return result << static_cast<mp_bitcnt_t>(shift);
  return result >> static_cast<mp_bitcnt_t>(-shift);  // only zeros go
}

/// Sign of |b - a, d - c| in integers.
inline int exact_cross_sign(Point a, Point b, Point c, Point d) {
  int exponent = 1024;
  for (const double value : {a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y}) {
    int binary = 0;
    std::frexp(value, &binary);
    if (value != 0) exponent = std::min(exponent, std::max(binary - 53, -1074));
  }
  const auto difference = [&](double to, double from) -> mpz_class {
    return integer_of(to, exponent) - integer_of(from, exponent);
  };
  const mpz_class left = difference(b.x, a.x) * difference(d.y, c.y);
  const mpz_class right = difference(b.y, a.y) * difference(d.x, c.x);
  return sgn(mpz_class(left - right));
}

/// The sign of |b - a, c - a| in integers.
inline int exact_orientation(Point a, Point b, Point c) {
  return exact_cross_sign(c, a, c, b);
}

/// 2^exponent.
inline mpq_class power_of_two(int exponent) {
  mpq_class result(1);
  if (exponent >= 0) {
    mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return result;
}

/// hi + lo.
inline mpq_class value_of(DD a) {
  return mpq_class(a.hi) + mpq_class(a.lo);
}

/// The vector between two points.
struct ExactVector {
  mpq_class x, y;
};
inline ExactVector exact_vector(Point from, Point to) {
  return {mpq_class(to.x) - mpq_class(from.x), mpq_class(to.y) - mpq_class(from.y)};
}

/// Whether |value - exact| <= 2^exponent |size|.
inline bool within(const mpq_class& value, const mpq_class& exact, int exponent, const mpq_class& size) {
  return abs(mpq_class(value - exact)) <= power_of_two(exponent) * abs(size);
}

}  // namespace lober::test

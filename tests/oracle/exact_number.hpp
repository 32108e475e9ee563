// Exact numbers for the oracles: GMP integers and rationals, and their way back to doubles.
#pragma once

#include <gmpxx.h>

#include <vector>

namespace lober::oracle {

using Integer = mpz_class;
using Rational = mpq_class;

/// The double nearest to `value`, ties to even; infinite beyond the largest one.
[[nodiscard]] double nearest_double(const Rational& value);

/// value * 2^exponent.
[[nodiscard]] Rational scaled(const Rational& value, int exponent);

/// The sum of all terms, taken as a balanced tree: denominators multiply, and a running sum would carry
/// the product of all of them through every step.
[[nodiscard]] Rational sum(std::vector<Rational> terms);

}  // namespace lober::oracle

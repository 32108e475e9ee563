#include "tests/oracle/exact_number.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

namespace lober::oracle {

double nearest_double(const Rational& value) {
  if (sgn(value) == 0) return 0;
  const Rational size = abs(value);
  // GMP truncates, so the nearest one is this or the next away from zero.
  const double below = size.get_d();
  if (std::isinf(below)) return sgn(value) > 0 ? below : -below;
  const double above = std::nextafter(below, std::numeric_limits<double>::infinity());
  double nearest = below;
  if (std::isfinite(above)) {
    const int middle = cmp(size + size, Rational(below) + Rational(above));
    std::uint64_t bits = 0;
    std::memcpy(&bits, &below, sizeof bits);
    if (middle > 0 || (middle == 0 && (bits & 1U) != 0)) nearest = above;
  }
  return sgn(value) > 0 ? nearest : -nearest;
}

Rational scaled(const Rational& value, int exponent) {
  Rational result;
  if (exponent >= 0) {
    mpq_mul_2exp(result.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(result.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return result;
}

Rational sum(std::vector<Rational> terms) {
  if (terms.empty()) return 0;
  for (std::size_t count = terms.size(); count > 1; count = (count + 1) / 2) {
    for (std::size_t k = 0; 2 * k < count; ++k) {
      if (2 * k + 1 < count) {
        terms[k] = terms[2 * k] + terms[2 * k + 1];
      } else {
        terms[k] = std::move(terms[2 * k]);
      }
    }
  }
  return terms.front();
}

}  // namespace lober::oracle

#include "engine/files/number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace lober::detail {
namespace {

/// Whether a literal out of the range of double is too small rather than too large: true when its first digit other
/// than zero stands for a power of ten below 1.
bool too_small(std::string_view literal) {
  const std::size_t exponent_mark = literal.find_first_of("eE");
  const std::string_view digits = literal.substr(0, exponent_mark);
  const auto point = static_cast<std::ptrdiff_t>(std::min(digits.find('.'), digits.size()));
  const auto first = static_cast<std::ptrdiff_t>(digits.find_first_of("123456789"));
  const std::ptrdiff_t power = first < point ? point - first - 1 : point - first;
  if (exponent_mark == std::string_view::npos) return power < 0;

  std::string_view text = literal.substr(exponent_mark + 1);
  if (text.front() == '+') text.remove_prefix(1);
  std::ptrdiff_t exponent = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
  // An exponent beyond 64 bits outweighs any number of digits that memory can hold.
  if (error == std::errc::result_out_of_range) return text.front() == '-';
  return exponent < -power;
}

}  // namespace

NumberKind parse_number(std::string_view token, double& value) {
  const bool plus = !token.empty() && token.front() == '+';
  if (plus) token.remove_prefix(1);
  if (token.empty() || (plus && token.front() == '-')) return NumberKind::not_a_number;

  std::string with_e;
  if (const std::size_t mark = token.find_first_of("dD"); mark != std::string_view::npos) {
    with_e = token;
    with_e[mark] = 'e';
    token = with_e;
  }
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return NumberKind::not_a_number;
  if (error == std::errc::result_out_of_range) {
    if (!too_small(token)) return NumberKind::not_finite;
    value = token.front() == '-' ? -0.0 : 0.0;
  }
  return std::isfinite(value) ? NumberKind::finite : NumberKind::not_finite;
}

}  // namespace lober::detail

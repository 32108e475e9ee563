#include "cli/picture/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lober::cli {
namespace {

// Extended precision: ranges may be those of all doubles, and 10^-320 has to have its digits.
using Real = long double;

Real power_of_ten(int exponent) {
  return powl(10, static_cast<Real>(exponent));
}

// digits * 10^exponent without an exponent: "-0.025".
std::string decimal_text(long long digits, int exponent) {
  std::string text = std::to_string(std::llabs(digits));
  if (exponent >= 0) {
    if (digits != 0) text.append(static_cast<std::size_t>(exponent), '0');
  } else {
    const auto decimals = static_cast<std::size_t>(-exponent);
    if (text.size() <= decimals) text.insert(0, decimals + 1 - text.size(), '0');
    text.insert(text.size() - decimals, ".");
  }
  return (digits < 0 ? "\u2212" : "") + text;
}

// Without zeros at the end of decimals.
std::string without_end_zeros(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

Ticks ticks_between(double low, double high, int max_count, bool whole_numbers) {
  Ticks ticks;
  const Real from = low, to = high, range = to - from;
  if (!(range > 0) || !std::isfinite(low) || !std::isfinite(high)) return ticks;
  // A step of factor * 10^exponent.
  int exponent = static_cast<int>(std::floor(log10l(range / std::max(1, max_count))));
  int factor = 0;
  for (; factor == 0; factor == 0 ? ++exponent : exponent) {
    for (const int candidate : {1, 2, 5}) {
      if (range / (candidate * power_of_ten(exponent)) <= max_count && factor == 0) factor = candidate;
    }
    if (factor != 0) break;
  }
  if (whole_numbers && exponent < 0) factor = 1, exponent = 0;
  // Numbers are counted in units of 10^exponent; where there are too many of them, from an offset.
  const Real unit = power_of_ten(exponent);
  Real offset = 0;
  if (std::max(fabsl(from), fabsl(to)) / unit >= 1e6L) {
    const Real round = power_of_ten(static_cast<int>(std::ceil(log10l(range))));
    offset = floorl((from + to) / 2 / round) * round;
    const int round_exponent = static_cast<int>(std::ceil(log10l(range)));
    const Real digits = floorl((from + to) / 2 / round);
    if (fabsl(digits) < 1e18L) {
      std::string text = without_end_zeros(decimal_text(std::llabs(static_cast<long long>(digits)), round_exponent));
      // Long rows of zeros read better as a power.
      if (const std::size_t end = text.find_last_not_of('0'); text.size() > 12 && end + 6 < text.size()) {
        const std::string factor_text = text.substr(0, end + 1);
        text =
            (factor_text == "1" ? "" : factor_text + "\u00b7") + "10^{" + std::to_string(text.size() - end - 1) + "}";
      }
      ticks.offset = (digits < 0 ? "+ " : "\u2212 ") + text;
    }
  }
  const auto first = static_cast<long long>(ceill((from - offset) / unit / factor - 1e-9L));
  const auto last = static_cast<long long>(floorl((to - offset) / unit / factor + 1e-9L));
  const long long largest = std::max(std::llabs(first), std::llabs(last)) * factor;
  // The power of ten of the largest one.
  const int leading = exponent + static_cast<int>(std::to_string(largest).size()) - 1;
  if (leading >= 5 || leading <= -4) ticks.power = leading;
  for (long long k = first; k <= last; ++k) {
    const Real value = offset + static_cast<Real>(k * factor) * unit;
    ticks.list.push_back(
        {static_cast<double>((value - from) / range), decimal_text(k * factor, exponent - ticks.power)});
  }
  return ticks;
}

}  // namespace lober::cli

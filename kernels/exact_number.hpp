// Exact arithmetic for the rare cases where floating point cannot tell: integers times a power of two.
//
// Every finite double is one, and so is every sum and product of such numbers. The digits are kept on the stack, only
// as many as there are, so that ordinary coordinates cost a handful of words and the extremes (2^-1074 against 2^1024)
// still fit. There is no rounding, no overflow and no underflow anywhere.
#pragma once

#include <array>
#include <cstdint>

#include "kernels/double_double.hpp"

namespace lober::detail {

/// Value = sign * sum digit[k] 2^(64 (k + exponent)). Holds any polynomial of degree 4 in differences of doubles: a
/// difference spans at most 2099 bits, a product of four 8396, hence 132 words, and a few for carries and alignment.
class ExactNumber {
 public:
  static constexpr int capacity = 140;

  ExactNumber() = default;
  explicit ExactNumber(double value);

  [[nodiscard]] int sign() const { return sign_; }
  friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b) { return sum(a, b, b.sign_); }
  friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) { return sum(a, b, -b.sign_); }
  friend ExactNumber operator*(const ExactNumber& a, const ExactNumber& b);

  /// The number as scaled * 2^exponent with 1 <= |scaled| < 2 (0 for zero), scaled rounded to double-double: relative
  /// error at most 2^-100. The exponent is apart so that nothing can overflow.
  struct Scaled {
    DD scaled;
    int exponent = 0;
  };
  [[nodiscard]] Scaled rounded() const;

 private:
  static ExactNumber sum(const ExactNumber& a, const ExactNumber& b, int sign_of_b);
  static int compare_magnitude(const ExactNumber& a, const ExactNumber& b);
  [[nodiscard]] std::uint64_t digit_at(int position) const {  // position counted in words from 2^0
    const int k = position - exponent_;
    return k < 0 || k >= size_ ? 0 : digits_[static_cast<std::size_t>(k)];
  }
  void trim();

  int sign_ = 0;
  int size_ = 0;
  int exponent_ = 0;
  std::array<std::uint64_t, capacity> digits_;  // the first size_ are valid
};

/// a - b exactly.
inline ExactNumber exact_difference(double a, double b) {
  return ExactNumber(a) - ExactNumber(b);
}

/// a / b in double-double, relative error at most 2^-98. b must not be zero; the quotient must be in double range.
[[nodiscard]] DD exact_ratio(const ExactNumber& a, const ExactNumber& b);

}  // namespace lober::detail

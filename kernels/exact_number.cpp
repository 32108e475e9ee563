#include "kernels/exact_number.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lober::detail {

__extension__ typedef unsigned __int128 Wide;

ExactNumber::ExactNumber(double value) {
  if (value == 0) return;
  int binary_exponent = 0;
  const double fraction = std::frexp(std::fabs(value), &binary_exponent);
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  binary_exponent -= 53;
  exponent_ = binary_exponent >= 0 ? binary_exponent / 64 : -((63 - binary_exponent) / 64);
  const Wide shifted = static_cast<Wide>(mantissa) << (binary_exponent - 64 * exponent_);
  digits_[0] = static_cast<std::uint64_t>(shifted);
  digits_[1] = static_cast<std::uint64_t>(shifted >> 64);
  size_ = 2;
  sign_ = value < 0 ? -1 : 1;
  trim();
}

void ExactNumber::trim() {
  while (size_ > 0 && digits_[static_cast<std::size_t>(size_ - 1)] == 0) --size_;
  if (size_ == 0) {
    sign_ = 0;
    exponent_ = 0;
    return;
  }
  int zeros = 0;
  while (digits_[static_cast<std::size_t>(zeros)] == 0) ++zeros;
  if (zeros > 0) {
    std::copy(digits_.begin() + zeros, digits_.begin() + size_, digits_.begin());
    size_ -= zeros;
    exponent_ += zeros;
  }
}

int ExactNumber::compare_magnitude(const ExactNumber& a, const ExactNumber& b) {
  const int top = std::max(a.exponent_ + a.size_, b.exponent_ + b.size_);
  const int bottom = std::min(a.exponent_, b.exponent_);
  for (int position = top - 1; position >= bottom; --position) {
    const std::uint64_t from_a = a.digit_at(position), from_b = b.digit_at(position);
    if (from_a != from_b) return from_a < from_b ? -1 : 1;
  }
  return 0;
}

ExactNumber ExactNumber::sum(const ExactNumber& a, const ExactNumber& b, int sign_of_b) {
  ExactNumber result;
  if (b.sign_ == 0) return a;
  if (a.sign_ == 0) {
    result = b;
    result.sign_ = sign_of_b;
    return result;
  }
  const ExactNumber* large = &a;
  const ExactNumber* small = &b;
  result.sign_ = a.sign_;
  const bool subtract = a.sign_ != sign_of_b;
  if (subtract && compare_magnitude(a, b) < 0) {
    std::swap(large, small);
    result.sign_ = sign_of_b;
  }
  result.exponent_ = std::min(a.exponent_, b.exponent_);
  const int top = std::max(a.exponent_ + a.size_, b.exponent_ + b.size_);
  result.size_ = top - result.exponent_;
  std::uint64_t* digits = result.digits_.data();
  std::fill_n(digits, result.size_ + 1, 0);
  std::copy_n(large->digits_.data(), large->size_, digits + (large->exponent_ - result.exponent_));
  const std::uint64_t* from = small->digits_.data();
  std::uint64_t* to = digits + (small->exponent_ - result.exponent_);
  std::uint64_t carry = 0;
  int k = 0;
  for (; k < small->size_ || carry != 0; ++k) {
    const std::uint64_t digit = k < small->size_ ? from[k] : 0;
    const Wide changed = subtract ? static_cast<Wide>(to[k]) - digit - carry : static_cast<Wide>(to[k]) + digit + carry;
    to[k] = static_cast<std::uint64_t>(changed);
    carry = static_cast<std::uint64_t>(changed >> 64) & 1;
  }
  if (digits[result.size_] != 0) ++result.size_;
  result.trim();
  return result;
}

ExactNumber operator*(const ExactNumber& a, const ExactNumber& b) {
  ExactNumber result;
  if (a.sign_ == 0 || b.sign_ == 0) return result;
  result.sign_ = a.sign_ * b.sign_;
  result.exponent_ = a.exponent_ + b.exponent_;
  result.size_ = a.size_ + b.size_;
  std::fill_n(result.digits_.begin(), result.size_, 0);
  for (int i = 0; i < a.size_; ++i) {
    std::uint64_t carry = 0;
    for (int j = 0; j < b.size_; ++j) {
      std::uint64_t& digit = result.digits_[static_cast<std::size_t>(i) + static_cast<std::size_t>(j)];
      const Wide term =
          static_cast<Wide>(a.digits_[static_cast<std::size_t>(i)]) * b.digits_[static_cast<std::size_t>(j)] + digit +
          carry;
      digit = static_cast<std::uint64_t>(term);
      carry = static_cast<std::uint64_t>(term >> 64);
    }
    result.digits_[static_cast<std::size_t>(i) + static_cast<std::size_t>(b.size_)] = carry;
  }
  result.trim();
  return result;
}

ExactNumber::Scaled ExactNumber::rounded() const {
  if (sign_ == 0) return {};
  // The three highest words hold at least 129 bits; dropping the rest costs less than 2^-128.
  const int top = exponent_ + size_ - 1;
  const int width = 64 - std::countl_zero(digit_at(top));  // width of the highest word
  const int exponent = 64 * top + width - 1;
  DD value;
  for (int position = top; position > top - 3; --position) {
    const std::uint64_t word = digit_at(position);
    const int shift = 64 * position - exponent;
    value += {std::ldexp(static_cast<double>(word >> 32), shift + 32), 0};
    value += {std::ldexp(static_cast<double>(word & 0xffffffffU), shift), 0};
  }
  return {sign_ < 0 ? -value : value, exponent};
}

DD exact_ratio(const ExactNumber& a, const ExactNumber& b) {
  const ExactNumber::Scaled above = a.rounded(), below = b.rounded();
  const DD quotient = above.scaled / below.scaled;
  const int exponent = above.exponent - below.exponent;
  return {std::ldexp(quotient.hi, exponent), std::ldexp(quotient.lo, exponent)};
}

}  // namespace lober::detail

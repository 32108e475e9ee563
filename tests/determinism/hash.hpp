// One number for all bits of a result.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>
#include <span>

#include "kernels/double_double.hpp"
#include "kernels/point.hpp"

namespace lober::detail {

/// Numbers one after the other, by bits: -0 is not 0. Not cryptographic: one changed bit changes the value, two changes
/// hide each other once in 2^64.
class Hash {
 public:
  void add(std::integral auto number) { word(static_cast<std::uint64_t>(number)); }
  void add(double number) { word(std::bit_cast<std::uint64_t>(number)); }
  void add(Point point) {
    add(point.x);
    add(point.y);
  }
  void add(DD number) {
    add(number.hi);
    add(number.lo);
  }
  /// Numbers or points, and how many there are.
  template <typename Range>
  void add_all(const Range& range) {
    add(std::size(range));
    for (const auto& one : range) add(one);
  }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  // Multiplication by an odd number and x ^ x >> 32 are bijections.
  void word(std::uint64_t bits) {
    state_ = (std::rotl(state_, 23) ^ bits) * 0x9e3779b97f4a7c15U;
    state_ ^= state_ >> 32U;
  }
  std::uint64_t state_ = 1;
};

}  // namespace lober::detail

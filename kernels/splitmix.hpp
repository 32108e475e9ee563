// Random numbers that are functions of a counter, so that they do not depend on threads or on order.
#pragma once

#include <cstdint>

namespace lober::detail {

/// The finaliser of splitmix64 (Steele, Lea & Flood 2014).
[[nodiscard]] inline std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

/// A number in [0, 1), from the upper 53 bits.
[[nodiscard]] inline double unit(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace lober::detail

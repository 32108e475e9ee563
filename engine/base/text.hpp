// Numbers and points in messages.
#pragma once

#include <array>
#include <charconv>
#include <string>

#include "kernels/point.hpp"

namespace lober::detail {

/// The shortest form that reads back to the same bits.
[[nodiscard]] inline std::string format_number(double value) {
  std::array<char, 32> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

/// A few significant digits, for estimates.
[[nodiscard]] inline std::string format_rounded(double value, int digits = 2) {
  std::array<char, 32> buffer;
  return {buffer.data(),
          std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits).ptr};
}

/// "(x, y)".
[[nodiscard]] inline std::string format_point(Point point) {
  return "(" + format_number(point.x) + ", " + format_number(point.y) + ")";
}

}  // namespace lober::detail

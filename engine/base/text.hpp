// Numbers and places in messages.
#pragma once

#include <array>
#include <charconv>
#include <string>

#include "kernels/point.hpp"

namespace lober {

/// The shortest form that reads back to the same bits.
[[nodiscard]] inline std::string shortest(double value) {
  std::array<char, 32> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

/// "(x, y)".
[[nodiscard]] inline std::string place_text(Point point) {
  return "(" + shortest(point.x) + ", " + shortest(point.y) + ")";
}

}  // namespace lober

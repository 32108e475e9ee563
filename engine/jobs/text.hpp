// Small pieces of text (private to jobs/).
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <string_view>

namespace lober {

/// The shortest form that reads back to the same bits.
inline std::string shortest(double value) {
  std::array<char, 32> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

/// A quoted JSON string; bytes that are not printable ASCII or UTF-8 come through as they are.
inline std::string json_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += {'\\', c};
    } else if (static_cast<unsigned char>(c) < 0x20) {
      constexpr std::string_view digits = "0123456789abcdef";
      quoted += "\\u00";
      quoted += {digits[static_cast<unsigned char>(c) >> 4], digits[static_cast<unsigned char>(c) & 15]};
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

}  // namespace lober

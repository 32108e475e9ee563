// Texts and numbers as JSON writes them.
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "engine/base/text.hpp"

namespace lober::detail {

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

/// The digits that give the number back, with a point or an exponent; null for one that is not finite.
inline std::string json_number(double value) {
  if (!std::isfinite(value)) return "null";
  std::string text = format_number(value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

}  // namespace lober::detail

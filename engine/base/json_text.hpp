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
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
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
inline void append_json_number(std::string& text, double value) {
  if (!std::isfinite(value)) {
    text += "null";
    return;
  }
  const std::size_t begin = text.size();
  text += format_number(value);
  if (text.find_first_of(".e", begin) == std::string::npos) text += ".0";
}

}  // namespace lober::detail

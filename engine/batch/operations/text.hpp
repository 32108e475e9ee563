// Small pieces of text (private to engine/batch).
#pragma once

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

}  // namespace lober::detail

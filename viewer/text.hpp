// Numbers and texts appended to a text.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

#include "engine/base/text.hpp"

namespace lober::viewer {

inline void append(std::string& text, double value) {
  text += detail::format_number(value);
}
inline void append(std::string& text, std::integral auto value) {
  text += std::to_string(value);
}
inline void append(std::string& text, std::string_view value) {
  text += value;
}

/// Appends each of the values; numbers read back to the same bits.
template <typename... Values>
void append_all(std::string& text, const Values&... values) {
  (append(text, values), ...);
}

}  // namespace lober::viewer

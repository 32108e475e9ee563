// Numbers and texts appended to a text.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <string>
#include <string_view>

namespace lober::detail {

/// The shortest form that reads back to the same bits.
inline void append(std::string& text, double value) {
  std::array<char, 32> buffer;
  text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

inline void append(std::string& text, std::integral auto value) {
  std::array<char, 24> buffer;
  text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

inline void append(std::string& text, std::string_view value) {
  text += value;
}

/// Appends each of the values: literals and numbers.
template <typename... Values>
void append_all(std::string& text, const Values&... values) {
  (append(text, values), ...);
}

}  // namespace lober::detail

// Numbers in files of either byte order.
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>

namespace lober::detail {

template <typename Unsigned>
[[nodiscard]] constexpr Unsigned reversed_bytes(Unsigned value) {
  Unsigned result = 0;
  for (std::size_t i = 0; i < sizeof value; ++i) {
    result = static_cast<Unsigned>(result << 8) | (value & 0xFF);
    value = static_cast<Unsigned>(value >> 8);
  }
  return result;
}

/// A number at any address; `Unsigned` is as large as `Number`.
template <typename Number, typename Unsigned>
[[nodiscard]] double load_number(const std::byte* from, bool swap) {
  Unsigned bits = 0;
  std::memcpy(&bits, from, sizeof bits);
  return static_cast<double>(std::bit_cast<Number>(swap ? reversed_bytes(bits) : bits));
}

}  // namespace lober::detail

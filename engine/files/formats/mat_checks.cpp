#include "engine/files/formats/mat_checks.hpp"

#include <array>
#include <cstdint>
#include <cstring>

#include "engine/files/byte_order.hpp"
#include "engine/files/formats/arrays.hpp"
#include "engine/files/formats/mat_lists.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {

// Each variable is five words (type, rows, columns, whether it is complex, length of its name), its name and its
// numbers.
void require_sound_version4(std::span<const std::byte> bytes, const std::string& path) {
  constexpr std::size_t head = 20, max_name = 64;
  constexpr std::array<std::size_t, 6> sizes{8, 4, 4, 2, 2, 1};  // bytes of a number, by the tens of the type
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return std::size_t{value};
  };
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t left = bytes.size() - at;
    const bool has_head = left >= head;
    const std::size_t type = has_head ? word(at) / 10 % 10 : sizes.size();
    const std::size_t name = has_head ? word(at + 16) : 0, rows = has_head ? word(at + 4) : 0;
    const std::size_t numbers =
        ArrayInfo{{}, {rows, has_head ? word(at + 8) : 0, has_head && word(at + 12) != 0 ? 2U : 1U}}.size();
    if (type >= sizes.size() || name > max_name || name > left - head || numbers > (left - head - name) / sizes[type]) {
      throw DataError(path + ": is a MAT file of version 4 that is damaged or cut off at byte " + std::to_string(at));
    }
    at += head + name + numbers * sizes[type];
  }
}

// Behind a head of 128 bytes elements, each with its type and its length, and padded to eight bytes unless it is
// compressed.
void require_sound_version5(std::span<const std::byte> bytes, const std::string& path) {
  constexpr std::size_t head = 128, order_at = 126, tag = 8;
  constexpr std::uint32_t compressed = 15;
  const auto fail = [&](std::size_t at) {
    throw DataError(path + ": is a MAT file that is damaged or cut off at byte " + std::to_string(at));
  };
  if (bytes.size() < head) fail(bytes.size());
  const bool swap = bytes[order_at] == std::byte{'M'};  // "MI", and "IM" in the order of this machine
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return swap ? reversed_bytes(value) : value;
  };
  for (std::size_t at = head; at < bytes.size();) {
    if (bytes.size() - at < tag) fail(at);
    const std::size_t length = word(at + 4), padding = word(at) == compressed ? 0 : (8 - length % 8) % 8;
    if (length + padding > bytes.size() - at - tag) fail(at);
    if (!is_sound_list(word(at), bytes.subspan(at + tag, length), swap)) fail(at);
    at += tag + length + padding;
  }
}

}  // namespace lober::detail

// An order of pairs in which few numbers occur for many pairs (private to engine/batch).
#pragma once

#include <cstdint>

namespace lober::detail {

/// The position of a pair on a Z-order curve: the bits of both numbers in turns.
[[nodiscard]] inline std::uint64_t z_order(std::uint32_t first, std::uint32_t second) {
  const auto spread = [](std::uint64_t bits) {  // at the even positions
    bits = (bits | bits << 16) & 0x0000ffff0000ffff;
    bits = (bits | bits << 8) & 0x00ff00ff00ff00ff;
    bits = (bits | bits << 4) & 0x0f0f0f0f0f0f0f0f;
    bits = (bits | bits << 2) & 0x3333333333333333;
    return (bits | bits << 1) & 0x5555555555555555;
  };
  return spread(first) << 1 | spread(second);
}

}  // namespace lober::detail

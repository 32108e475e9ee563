// SHA-256 as bytes, for those that keep it (private to the engine).
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace lober::detail {

/// The hash that lober::sha256 writes in hexadecimal.
[[nodiscard]] std::array<std::byte, 32> sha256_bytes(std::span<const std::byte> bytes);

}  // namespace lober::detail

// The format of a file, from its first bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace lober::detail {

enum class Content : std::uint8_t { text, npy, raw };

/// NPY by its magic string; text when the first few KiB have no control characters and are ASCII, well-formed
/// UTF-8 or mostly ASCII (a title in some other encoding), or begin with a Tecplot keyword; raw otherwise.
/// Native float64 pairs hold a control character in nearly every point: each of their low bytes is one in one
/// case of nine, and numbers of few digits end in zero bytes.
[[nodiscard]] Content sniff(std::span<const std::byte> bytes);

/// Length of the UTF-8 byte order mark at the beginning: 3 or 0.
[[nodiscard]] std::size_t byte_order_mark(std::span<const std::byte> bytes);

}  // namespace lober::detail

// Cells and structures of MAT files: matio believes how many elements they have, and makes room for them when it lists
// the variables of a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace lober::detail {

/// One element of a MAT file of versions 5 to 7, behind its tag: whether it is what matio can list in memory in
/// proportion to the file. True for all that are no lists. `type` is that of the tag, `swap` whether the bytes of words
/// are in the other order. A compressed list is expanded whole for that. O(elements of lists).
[[nodiscard]] bool is_sound_list(std::uint32_t type, std::span<const std::byte> content, bool swap);

}  // namespace lober::detail

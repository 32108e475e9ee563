// Formats that are not read, known by their first bytes, and how to make of them one that is.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace lober::detail {

/// The kind of the file and how to convert it, as the end of a message ("a PNG picture, ..."); empty when the bytes are
/// of no format known here. Looks at the first bytes, and at the last one. O(1).
[[nodiscard]] std::string foreign_format(std::span<const std::byte> bytes);

/// The same for text: XML.
[[nodiscard]] std::string foreign_text(std::span<const std::byte> text);

}  // namespace lober::detail

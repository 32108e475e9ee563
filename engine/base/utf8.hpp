// Whether bytes are text.
#pragma once

#include <string>
#include <string_view>

namespace lober::detail {

/// Whether the bytes are UTF-8: no byte too many or too few, no code point in two ways, no surrogates.
[[nodiscard]] bool is_utf8(std::string_view text);

/// The text itself where it is UTF-8; otherwise each byte as the character of Latin-1 that it is.
[[nodiscard]] std::string as_utf8(std::string_view text);

}  // namespace lober::detail

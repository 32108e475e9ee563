// Whether bytes are text.
#pragma once

#include <string_view>

namespace lober::detail {

/// Whether the bytes are UTF-8: no byte too many or too few, no code point in two ways, no surrogates.
[[nodiscard]] bool is_utf8(std::string_view text);

}  // namespace lober::detail

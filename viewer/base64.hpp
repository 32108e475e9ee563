// Base64 (RFC 4648), in which bytes stand in pages.
#pragma once

#include <string>
#include <string_view>

namespace lober::viewer {

/// The text of the bytes, padded by '='. O(N).
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace lober::viewer

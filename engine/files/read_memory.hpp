// Reading a file that is already in memory: what the file readers do after reading the bytes, and what the fuzzers
// call.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "lober/curve/files.hpp"

namespace lober::detail {

/// Small enough that a chunk and its points stay in the cache of a core, large enough that handing it over
/// costs nothing.
inline constexpr std::size_t default_chunk_size = std::size_t{1} << 18;

/// Like `read_curve_file`, with `name` instead of the path and `sha256` left empty. The result does not
/// depend on `chunk_size`; tests cut text into tiny chunks with it.
[[nodiscard]] CurveFile read_curve_bytes(std::string name, std::span<const std::byte> bytes,
                                         std::size_t chunk_size = default_chunk_size, std::string_view columns = {});

}  // namespace lober::detail

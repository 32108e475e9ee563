// A whole text file: its chunks joined in order, its header lines understood.
#pragma once

#include <cstddef>
#include <string_view>

#include "lober/curve/files.hpp"

namespace lober::detail {

/// Reads `text` into `file.zones` and sets `file.format` to tecplot or text; `file.path` begins every
/// message. The text is cut at line ends into chunks of at least `chunk_size` bytes that are parsed in
/// parallel; the result does not depend on it.
void read_text(std::string_view text, std::size_t chunk_size, CurveFile& file);

}  // namespace lober::detail

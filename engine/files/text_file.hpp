// A whole text file: its chunks joined in order, its header lines understood.
#pragma once

#include <cstddef>
#include <string_view>

#include "lober/curve/files.hpp"

namespace lober::detail {

/// Reads `text` into `file.zones` and sets `file.format` to tecplot or text; `file.path` begins every
/// message. The text is cut at line ends into chunks of at least `chunk_size` bytes that are parsed in
/// parallel; the result does not depend on it. `columns` is a choice of columns (text_columns.hpp).
///
/// Lines that begin with '>' (GMT; the rest is the title), rows of NaN and blank lines part the curves of a table;
/// blank lines do not if there is one behind each point.
void read_text(std::string_view text, std::string_view columns, std::size_t chunk_size, CurveFile& file);

}  // namespace lober::detail

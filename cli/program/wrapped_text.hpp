// Text for a terminal, broken into lines.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lober::cli {

/// The width of help texts: COLUMNS, or that of the terminal, but from 80 to 120; 100 where standard output is not a
/// terminal.
[[nodiscard]] std::size_t text_width();

/// The words of the text in lines of at most `width` characters, the second and further lines behind `indent` blanks,
/// the first behind `used` characters that stand there already. A longer word has a line of its own. Without a line
/// feed at the end.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::size_t indent = 0,
                                  std::size_t used = 0);

/// "  label   text", where the text begins at `column`, one line lower behind a longer label, with a line feed.
[[nodiscard]] std::string list_entry(std::string_view label, std::string_view text, std::size_t column,
                                     std::size_t width);

}  // namespace lober::cli

// A line of a table, cut into its cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lober::detail {

/// The separator of the columns of a table. Where blanks part columns, so do single commas and semicolons.
enum class Separator : std::uint8_t { blanks, tab, comma, semicolon };

[[nodiscard]] constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

[[nodiscard]] std::string_view without_blanks(std::string_view text);

/// Replaces `cells` by those of the line, without the blanks around them and with their quotes. In quotes separators
/// and '#' are characters like others, and a doubled quote is one quote.
///
/// Separator::blanks: cells end at blanks, or at a comma or semicolon with any blanks around it, which at the end or
/// two in a row leave an empty cell; a '#' ends the line. Others: every separator ends a cell, which may be empty; a
/// '#' behind a blank ends the line where a number, a quoted text or nothing stands before it in the last column or
/// beyond. `count` is the number of columns, 1 where it is not known yet.
void cut_into_cells(std::string_view line, Separator separator, std::size_t count,
                    std::vector<std::string_view>& cells);
[[nodiscard]] std::vector<std::string_view> cells_of(std::string_view line, Separator separator, std::size_t count = 1);

/// The cell without its quotes, doubled ones inside as they are, and without blanks.
[[nodiscard]] std::string_view inside_quotes(std::string_view cell);
/// The text that a cell stands for.
[[nodiscard]] std::string text_of_cell(std::string_view cell);
/// Whether quotes begin and do not end.
[[nodiscard]] bool is_open(std::string_view cell);

/// Whether quotes begin, and there is more of the cell behind their end: another separator may part such lines.
[[nodiscard]] bool goes_on_behind_quotes(std::string_view cell);

/// The separator of a line that is looked at alone: the first of comma, semicolon and tab, outside of quotes and
/// comments, that parts a number from the rest, or else parts anything, tabs only where none of their cells is empty;
/// else blanks.
[[nodiscard]] Separator separator_of(std::string_view line);

/// Whether a cell of the line is a number (nan and inf included), or all of them are when blanks part them too: such a
/// line is never a header.
[[nodiscard]] bool has_number(std::string_view line);
[[nodiscard]] bool has_number(std::string_view line, Separator separator);

/// Text of a file for a message: quoted, shortened, without control characters.
[[nodiscard]] std::string quoted_text(std::string_view text);

}  // namespace lober::detail

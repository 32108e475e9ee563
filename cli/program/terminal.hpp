// The terminal that standard error may be, and the line at its bottom that is drawn again and again. No escape sequence
// is ever written: a line is wiped away by blanks, so that NO_COLOR and TERM=dumb have nothing to switch off.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace lober::cli {

/// Whether people read standard error while the program runs; and standard output.
[[nodiscard]] bool is_error_terminal();
[[nodiscard]] bool is_output_terminal();
/// The width of the terminal at standard error in characters; 80 where it is not known.
[[nodiscard]] std::size_t error_terminal_width();

/// The text without what a terminal would obey: each control character becomes '?'.
[[nodiscard]] std::string printable(std::string_view text);

/// Draws the line on standard error, in place of the one that is there. At most one thread at a time calls it.
void draw_status_line(const std::string& text);
/// Wipes it away, if there is one.
void wipe_status_line();
/// Calls write() with the line wiped away and nobody drawing; for all that is written to standard output or standard
/// error while a command works. Must not be nested.
void write_above_status_line(const std::function<void()>& write);

/// The characters that the line takes up, for the handler of a signal.
[[nodiscard]] std::size_t status_line_length();

}  // namespace lober::cli

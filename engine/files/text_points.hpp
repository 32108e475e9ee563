// The lines of a text file: points are read here, in parallel and fast; every other line is handed on.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/point.hpp"

namespace lober::detail {

/// A line that does not begin like a number and is neither blank nor a comment.
struct OtherLine {
  std::string_view text;
  std::size_t line = 0;           ///< counted from 0 at the beginning of the chunk
  std::size_t points_before = 0;  ///< how many points of the chunk precede it
};

struct LineError {
  std::size_t line = 0;  ///< counted from 0 at the beginning of the chunk
  std::string message;
};

/// The findings in a piece of a file that begins at a line start and ends at a line end.
struct TextChunk {
  std::string_view text;
  std::vector<Point> points;
  std::vector<OtherLine> others;
  std::size_t lines = 0;
  std::optional<LineError> error;  ///< reading stopped there
};

[[nodiscard]] constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

/// Fills the chunk from its `text`.
void parse_chunk(TextChunk& chunk);

/// Reads one line of any content as a point. Returns the fault of the line, or an empty string.
[[nodiscard]] std::string parse_point_line(std::string_view line, Point& point);

/// True when some field of the line is a number (nan and inf included): such a line is never a header.
[[nodiscard]] bool has_number(std::string_view line);

/// Text of a file for a message: quoted, shortened, without control characters.
[[nodiscard]] std::string quoted_text(std::string_view text);

}  // namespace lober::detail

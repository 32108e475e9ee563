// The lines of a text file: points are read here, in parallel and fast; every other line is handed on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/files/text_cells.hpp"
#include "kernels/point.hpp"

namespace lober::detail {

/// The columns of a text file that are read, counted from 0.
struct TextColumns {
  std::size_t x = 0, y = 1;
  std::size_t count = 2;                    ///< the number of columns that each line has
  std::optional<std::size_t> group;         ///< the column whose values say which curve a point belongs to
  Separator separator = Separator::blanks;  ///< that of lines with more columns than the two
  bool is_tecplot = false;                  ///< whether records begin with words, and quotes hold names, not numbers

  /// Whether each line is a point and nothing else.
  [[nodiscard]] bool are_all() const { return x == 0 && y == 1 && count == 2 && !group; }
};

/// A line without a point, or a change of the group. The first one stands for several blank lines in a row.
struct OtherLine {
  enum class Kind : std::uint8_t {
    text,   ///< does not begin like a number, and is neither blank nor a comment
    blank,  ///< no characters but blanks
    gap,    ///< both coordinates are NaN or empty
    group,  ///< `text` is the cell with the group of the points from here on
  };
  Kind kind = Kind::text;
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

/// Fills the chunk from its `text`.
void parse_chunk(TextChunk& chunk, const TextColumns& columns = {});

/// Reads one line of any content as a point, two numbers with any separator between them. Returns the fault of the
/// line, or an empty string.
[[nodiscard]] std::string parse_point_line(std::string_view line, Point& point);

}  // namespace lober::detail

// The header records of a Tecplot ASCII file, one line at a time.
//
//   TITLE = "..."
//   VARIABLES = "x", "y"        also "x""y", ''x''''y'' and x, y; may go on over the next lines
//   ZONE T="...", I=257         also N=, J=1, K=1, F=POINT, DATAPACKING=POINT; may go on over the next lines
//
// Keywords in either case. Attributes that say nothing about points on a line (C=RED, STRANDID=1, ...) are
// ignored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/files/source_location.hpp"

namespace lober::detail {

enum class TecplotRecord : std::uint8_t { none, title, variables, zone, ignored };

/// The record that begins on this line, if any. `line` begins with a character other than a blank.
[[nodiscard]] TecplotRecord tecplot_record(std::string_view line);

/// The names in a VARIABLES line, or in a line that continues one.
[[nodiscard]] std::vector<std::string> variable_names(std::string_view line, const SourceLocation& location);
/// Those of the first VARIABLES record before any points, over several lines.
[[nodiscard]] std::vector<std::string> first_variable_names(std::string_view text, const std::string& path);

/// The contents of a ZONE record.
struct TecplotZone {
  struct Count {
    std::string key;  ///< as in the file, in upper case
    std::size_t points = 0;
    std::size_t line = 0;  ///< line of the file, counted from 1
  };
  std::string title;
  std::vector<Count> counts;
};

/// Reads a ZONE line, or a line that continues one, into `zone`.
void read_zone_attributes(std::string_view line, const SourceLocation& location, TecplotZone& zone);

/// The title as a quoted string that the functions above read back.
[[nodiscard]] std::string tecplot_title(std::string_view title);

}  // namespace lober::detail

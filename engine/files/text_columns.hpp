// Which columns of a table are the coordinates: as asked for, or as the names of the first two say.
#pragma once

#include <string>
#include <string_view>

#include "engine/files/text_points.hpp"

namespace lober::detail {

/// The columns of a table that are read.
struct TableHead {
  TextColumns columns;
  std::string names;  ///< names of the two coordinates, "lon,lat"; empty where all columns are read, or have no names
  std::size_t skipped = 0;  ///< bytes of a first line that names the separator, as Excel has it: "sep=;"
};

/// Reads the first lines of `text`. A table has one separator, which the first line with numbers and the header decide:
/// the first of comma, semicolon and tab that parts both into the same number of cells; else the first that parts the
/// line with numbers; else blanks. Below the header a line of units may stand; it may have a name less than there are
/// columns, whose first one are names of rows then. `choice` is empty, or names two columns and perhaps the one that
/// groups rows: "lon,lat", "2,3" (counted from 1), "x,y,by=id"; names with commas are in quotes. Without it a table of
/// more columns than two is read only where the first two are named x and y, or longitude and latitude; so are the
/// variables of a Tecplot file. Throws DataError "path:line:
/// ..." with the names that there are. O(length of the first lines).
[[nodiscard]] TableHead read_table_head(std::string_view text, std::string_view choice, const std::string& path);

}  // namespace lober::detail

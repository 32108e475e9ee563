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
};

/// Reads the first lines of `text`. `choice` is empty, or names two columns and perhaps the one that groups rows:
/// "lon,lat", "2,3" (counted from 1), "x,y,by=id". Without it a table of more columns than two is read only where the
/// first two are named x and y, or longitude and latitude. Throws DataError "path:line: ..." with the names that there
/// are. O(length of the first lines).
[[nodiscard]] TableHead read_table_head(std::string_view text, std::string_view choice, const std::string& path);

}  // namespace lober::detail

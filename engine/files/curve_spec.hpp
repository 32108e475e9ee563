// The name of a curve on a command line: FILE, FILE:COLUMNS, and behind either #K or #TITLE.
#pragma once

#include <optional>
#include <string>

namespace lober::detail {

struct CurveSpec {
  std::string file;
  std::string columns = {};              ///< empty where they are not given
  std::optional<std::string> zone = {};  ///< by its number or its title
};

/// The parts of `spec`, cut at the last '#' and ':' that leave an existing file before them.
[[nodiscard]] CurveSpec split_spec(const std::string& spec);

/// The file alone.
[[nodiscard]] inline std::string file_of_curve(const std::string& spec) {
  return split_spec(spec).file;
}

}  // namespace lober::detail

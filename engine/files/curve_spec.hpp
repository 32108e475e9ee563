// The name of a curve on a command line: FILE, FILE#K or FILE#TITLE.
#pragma once

#include <string>
#include <utility>

namespace lober::detail {

/// The file and the zone that `spec` names, split at the last '#' that leaves an existing file before it; the zone is
/// empty when there is none.
[[nodiscard]] std::pair<std::string, std::string> split_spec(const std::string& spec);

/// The file alone.
[[nodiscard]] inline std::string file_of_curve(const std::string& spec) {
  return split_spec(spec).first;
}

}  // namespace lober::detail

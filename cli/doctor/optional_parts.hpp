// Parts that a build may leave out.
#pragma once

#include <string>
#include <vector>

namespace lober::cli {

struct OptionalPart {
  std::string name;
  bool available = false;
  std::string library = {};  ///< Debian's package of the library behind it; empty where there is none
};

/// All of them, in the order in which `lober doctor` lists them.
[[nodiscard]] std::vector<OptionalPart> optional_parts();

}  // namespace lober::cli

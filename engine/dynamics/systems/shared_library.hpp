// Systems from shared libraries (lober_system.h).
#pragma once

#include <string>
#include <string_view>

#include "engine/dynamics/systems/entries.hpp"

namespace lober::detail {

/// Loads the library and checks what it describes; it stays loaded as long as the entry or a system made of it lives.
/// Throws DataError with the path and the reason.
SystemEntry load_system(const std::string& path);

/// Whether the name of a system is the path of a library: it has a slash, or ends in .so.
[[nodiscard]] inline bool names_library(std::string_view name) {
  return name.find('/') != std::string_view::npos || name.ends_with(".so");
}

}  // namespace lober::detail

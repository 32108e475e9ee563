// Systems from shared libraries (lober_system.h).
#pragma once

#include <string>

#include "engine/dynamics/systems/entries.hpp"

namespace lober::detail {

/// Loads the library and checks its description; it stays loaded as long as the entry or a system made of it lives.
/// Throws DataError with the path and the reason.
SystemEntry load_system(const std::string& path);

}  // namespace lober::detail

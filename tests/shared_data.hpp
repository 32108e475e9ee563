// Real curves that are too large for the repository.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>

#include "tests/paths.hpp"

namespace lober {

/// Path of a file below `data/` of the shared folder, or nothing when it is not there. The folder is the
/// value of the environment variable LOBER_SHARED, by default the sibling `shared` of the source tree.
inline std::optional<std::filesystem::path> shared_data(std::string_view name) {
  const char* const chosen = std::getenv("LOBER_SHARED");
  const std::filesystem::path folder =
      chosen != nullptr ? std::filesystem::path(chosen) : std::filesystem::path(LOBER_SOURCE_DIR) / "../shared";
  std::filesystem::path file = folder / "data" / name;
  if (!std::filesystem::exists(file)) return std::nullopt;
  return file;
}

}  // namespace lober

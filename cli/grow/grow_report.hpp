// The work of `lober grow` in words.
#pragma once

#include <string>

#include "lober/operations.hpp"

namespace lober::cli {

/// Whether growing went as far as the options ask, and how it ended.
[[nodiscard]] bool ends_as_asked(const GrownManifold& manifold);
[[nodiscard]] std::string end_of_growth(const GrownManifold& manifold);

/// A few lines for people.
[[nodiscard]] std::string grow_summary(const System& system, const operations::SystemManifold& manifold);

}  // namespace lober::cli

// Curves of systems as a manifest writes them (private to engine/batch).
#pragma once

#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

#include <string>

#include "engine/batch/manifest/manifest.hpp"

namespace lober::detail {

/// `{ system = ..., manifold = ... }` or `{ system = ..., image_of = ... }`, see manifest.hpp. `key` is where it
/// stands. Throws UsageError with the line.
[[nodiscard]] LocatedText read_recipes(const Manifest& manifest, const toml::table& table, const std::string& key);

}  // namespace lober::detail

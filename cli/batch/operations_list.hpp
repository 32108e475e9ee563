// `lober batch operations` and `lober batch manifest`: what a manifest can ask for, and how it is written.
#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// Prints the operations, or with a name its options and results.
void show_operations(const std::vector<std::string>& arguments);

/// Prints the keys of a manifest.
void show_manifest_keys(const std::vector<std::string>& arguments);

}  // namespace lober::cli

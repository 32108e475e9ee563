// The commands in docs/reference.md.
#pragma once

#include <string>

namespace lober::cli {

/// A section "## lober overlay" for each command: its form, and a table of its options.
[[nodiscard]] std::string markdown_reference();

}  // namespace lober::cli

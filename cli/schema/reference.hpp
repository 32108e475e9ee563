// The table of operations as a document.
#pragma once

#include <string>

#include "lober/operations.hpp"

namespace lober::cli {

/// In Markdown: what an operation does, its inputs, its options and what its result consists of.
[[nodiscard]] std::string reference_text(const operations::Operation& operation);

}  // namespace lober::cli

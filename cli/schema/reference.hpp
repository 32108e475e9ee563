// The table of operations as a document.
#pragma once

#include <string>

#include "lober/operations.hpp"

namespace lober::cli {

/// The reference of an operation in Markdown: its summary, inputs, options and the parts of its result.
[[nodiscard]] std::string reference_text(const operations::Operation& operation);

}  // namespace lober::cli

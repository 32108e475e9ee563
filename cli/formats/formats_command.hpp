// The formats of curve files that this build reads and writes.
#pragma once

#include <string>
#include <vector>

namespace lober::cli {

void run_formats(const std::vector<std::string>& arguments);

/// The same as a table in Markdown, for the documents: without what is installed on this machine.
[[nodiscard]] std::string markdown_formats();

}  // namespace lober::cli

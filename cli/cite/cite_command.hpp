// `lober cite`: how to cite the program, and the article whose methods it implements.
#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// Prints text, or with --bibtex entries of BibTeX. Throws UsageError.
void run_cite(const std::vector<std::string>& arguments);

}  // namespace lober::cli

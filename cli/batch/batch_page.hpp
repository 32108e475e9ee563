#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// `lober batch page STORE -o FILE`: a page with the jobs of a store and heat maps of their numbers.
void run_batch_page(const std::vector<std::string>& arguments);

}  // namespace lober::cli

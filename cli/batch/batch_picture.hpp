#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// `lober batch picture STORE --picture FILE`: a heat map or a curve of a number of the jobs, or the overlaps of lobes.
void run_batch_picture(const std::vector<std::string>& arguments);

}  // namespace lober::cli

// `lober schema`: the members of the JSON of operations.
#pragma once

#include <string>
#include <vector>

namespace lober::cli {

void run_schema(const std::vector<std::string>& arguments);

}  // namespace lober::cli

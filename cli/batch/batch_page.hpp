#pragma once

#include <string>
#include <vector>

#include "lober/base/progress.hpp"
#include "lober/batch.hpp"

namespace lober::cli {

/// The export of a store as one JSON object: counts, and an array of jobs. Throws DataError.
[[nodiscard]] std::string jobs_json(const std::string& path, ExportCounts& counts,
                                    const lober::Progress& progress = {});

/// `lober batch page STORE -o FILE`: a page with the jobs of a store and heat maps of their numbers.
void run_batch_page(const std::vector<std::string>& arguments);

}  // namespace lober::cli

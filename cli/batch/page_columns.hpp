// The jobs of a store as the page of a batch reads them: columns, whose texts stand once each.
#pragma once

#include <string>

#include "lober/batch.hpp"

namespace lober::cli {

/// An object of JSON: `done`, `failed` and `missing`; `columns`, each with a name, a role ("given": curves, and options
/// that differ among the jobs; "result": numbers, those of spread lists among them, null where they are not finite;
/// "about"), and values in the order of the plan, or `texts` and for each job the number `at` of one; and `overlaps` of
/// lobes of each job, where there are any. `counts` are those of the jobs. Throws DataError, Cancelled.
[[nodiscard]] std::string jobs_json(const std::string& store, ExportCounts& counts);

}  // namespace lober::cli

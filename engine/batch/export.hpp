// Results as tables: the same bytes for the same results, whatever computed them in whatever order.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/batch/store.hpp"
#include "lober/batch.hpp"

namespace lober::detail {

/// Writes the jobs of the store's plan that have a result or have failed, in the order of the plan, numbers in the
/// shortest form that reads back to the same bits. A damaged result is left out, as one that is not there. CSV and NPY
/// hold one operation, which has to be named when the plan has several. The file appears when it is complete; "-" is
/// standard output. Throws DataError, UsageError.
ExportCounts export_results(const Store& store, const std::string& path, ExportFormat format,
                            const std::optional<std::string>& operation = {});

/// How far the plan of a store is. Reads and verifies all results.
struct StoreSurvey {
  ExportCounts counts;
  std::vector<std::string> failures;  ///< "FIRST SECOND: message" for each job of the plan that failed
};
[[nodiscard]] StoreSurvey survey(const Store& store);

/// "STORE: the result of job N (FIRST SECOND) is damaged and counts as missing".
[[nodiscard]] std::string damage_line(const Store& store, const Plan& plan, std::size_t job);

}  // namespace lober::detail

// Results as tables: the same bytes for the same results, whatever computed them in whatever order.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/batch/store.hpp"

namespace lober {

enum class ExportFormat : std::uint8_t {
  csv,         ///< a header line; lists are put into one field, separated by blanks; what is not known is empty
  json_lines,  ///< one object a line; numbers that are not finite are null
  npy,         ///< a structured array, texts as bytes; no lists; what is not known is NaN, a count -1
};
/// By the end of a file's name (.csv, .jsonl, .npy). Throws UsageError for others.
[[nodiscard]] ExportFormat export_format(const std::string& path);

struct ExportCounts {
  std::size_t done = 0, failed = 0, missing = 0;
  std::vector<std::string> damaged;  ///< a line for each job whose result is damaged; it counts as missing
};

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

}  // namespace lober

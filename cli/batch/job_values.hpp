// The jobs of a store as flat tables of values, and which of these vary or are results.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cli/report/json.hpp"
#include "lober/base/progress.hpp"

namespace lober::cli {

/// The jobs that are done, in the order of the plan.
class JobValues {
 public:
  /// Reads those of one operation, which has to be named where the store has several. Throws DataError, UsageError,
  /// Cancelled.
  JobValues(const std::string& store, const std::string& operation, const lober::Progress& progress);

  [[nodiscard]] std::size_t size() const { return jobs_.size(); }
  /// The value of a job under the name of a column, of an option, or of a parameter: "K" for "options.parameters.K";
  /// null where it has none.
  [[nodiscard]] const Json& value(std::size_t job, const std::string& name) const;
  /// The job with its lists.
  [[nodiscard]] const Json& job(std::size_t k) const { return jobs_[k]; }

  /// Options, parameters and curves that differ among the jobs, in the order of the export.
  [[nodiscard]] const std::vector<std::string>& varied() const { return varied_; }
  /// Numbers of the results.
  [[nodiscard]] const std::vector<std::string>& results() const { return results_; }

 private:
  std::vector<Json> jobs_;
  std::vector<std::string> varied_, results_;
};

}  // namespace lober::cli

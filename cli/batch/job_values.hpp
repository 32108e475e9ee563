// The jobs of a store as flat tables of values, and which of these vary or are results.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/report/json.hpp"
#include "engine/batch/manifest/plan.hpp"
#include "engine/batch/operations/result.hpp"
#include "lober/base/progress.hpp"

namespace lober::cli {

/// The name of an option in pictures and pages: "K" for "parameters.K".
[[nodiscard]] std::string short_option(const std::string& key);

/// The jobs of one operation that are done, in the order of the plan.
class JobValues {
 public:
  /// Reads those of one operation, which has to be named where the store has several. Throws DataError, UsageError,
  /// Cancelled.
  JobValues(const std::string& store, const std::string& operation, const lober::Progress& progress);

  [[nodiscard]] std::size_t size() const { return jobs_.size(); }
  /// The number of a job in the plan.
  [[nodiscard]] std::int64_t number(std::size_t job) const { return jobs_[job].job; }
  /// The value of a job under the name of a column, of an option, or of a parameter: "K" for "options.parameters.K";
  /// null where it has none, or one that is not finite.
  [[nodiscard]] Json value(std::size_t job, const std::string& name) const;
  /// The same of a column alone: some results are named like options (`points`).
  [[nodiscard]] Json result(std::size_t job, const std::string& name) const;
  /// A list of the result, empty where there is none.
  [[nodiscard]] std::span<const double> list(std::size_t job, std::string_view name) const;

  /// Options, parameters and curves that differ among the jobs, in the order of the export.
  [[nodiscard]] const std::vector<std::string>& varied() const { return varied_; }
  /// Numbers of the results.
  [[nodiscard]] const std::vector<std::string>& results() const { return results_; }

 private:
  [[nodiscard]] const detail::Job& job(std::size_t k) const { return plan_.jobs[jobs_[k].job]; }
  [[nodiscard]] Json option(std::size_t job, const std::string& name) const;
  void find_varied();
  void find_results();

  detail::Plan plan_;
  detail::Operation operation_;  ///< with the columns into which it spreads lists
  std::vector<detail::Result> jobs_;
  std::vector<std::string> varied_, results_;
};

}  // namespace lober::cli

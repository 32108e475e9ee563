// Results as tables: the same bytes for the same results, whatever computed them in whatever order.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/batch/store/store.hpp"
#include "lober/base/progress.hpp"
#include "lober/batch.hpp"

namespace lober::detail {

/// Writes the jobs of the store's plan that have a result or have failed, in the order of the plan, numbers in the
/// shortest form that reads back to the same bits. A damaged result is left out, as one that is not there. CSV and NPY
/// hold one operation, which has to be named when the plan has several. The file appears when it is complete; "-" is
/// standard output. Throws DataError, UsageError, Cancelled.
ExportCounts export_results(const Store& store, const std::string& path, ExportFormat format,
                            const std::optional<std::string>& operation = {}, const Progress& progress = {});

/// The plan of a store. Throws DataError where there is none.
[[nodiscard]] Plan plan_of(const Store& store);

/// Calls `found` for each result of a job of the plan, failures among them, in the order of the plan; of one operation,
/// if it is named. Those that are damaged are counted and left out. Throws Cancelled.
ExportCounts for_each_result(const Store& store, const Plan& plan, const std::optional<std::string>& operation,
                             const std::function<void(const Result&)>& found, const Progress& progress = {});

/// Goes through the results of jobs of a plan, in its order.
using EachResult = std::function<void(const std::function<void(const Result&)>&)>;

/// A table of fixed columns: those of the operation, and those into which it spreads the lists of any result.
struct SpreadTable {
  Operation operation;
  EachResult results;  ///< with the values of all columns; it refers to the operation that was given
};
/// Goes through the results once to learn the columns, if the operation spreads any.
[[nodiscard]] SpreadTable spread_table(const Operation& operation, const EachResult& results);

/// How far the plan of a store is. Reads and verifies all results.
struct StoreSurvey {
  ExportCounts counts;
  /// Jobs of the plan that failed with the same message.
  struct Failure {
    std::string message;
    std::string first;  ///< the first of them: "FIRST SECOND parameters.K=0.9", its curves and what a grid varies
    std::size_t jobs = 0;
  };
  std::vector<Failure> failures;  ///< in the order of the plan
};
[[nodiscard]] StoreSurvey survey(const Store& store, const Progress& progress = {});

/// "STORE: the result of job N (FIRST SECOND) is damaged and counts as missing".
[[nodiscard]] std::string damage_line(const Store& store, const Plan& plan, std::size_t job);

}  // namespace lober::detail

// The two parts that ranks play. Rank 0 owns the store, deals the jobs, and computes beside it; the others compute.
#pragma once

#include <atomic>
#include <string>

#include "engine/batch/batch.hpp"

namespace lober::cli {

/// The data that all ranks know.
struct SharedWork {
  detail::Plan plan;
  std::string manifest_path, store, output_root;
  QueueOptions queue;  ///< options of one rank
};

/// Runs until everything is done; the report sums up all ranks. When `progress` returns false, all ranks finish what
/// they are at. When this rank fails, or `broken` says that the store can no longer be written, what has come in is
/// committed as far as that goes and all ranks are ended (`abandon`).
[[nodiscard]] BatchReport coordinate(const SharedWork& work, detail::StoreSession& session, int ranks,
                                     const std::function<bool(const QueueProgress&)>& progress,
                                     const std::atomic<bool>& broken);

/// Asks rank 0 for jobs of the plan (Plan::encoded) and sends it results until there are no more. Ends all ranks when
/// this one fails.
void work_for_coordinator(SharedWork& work, const std::string& plan);

/// The line and the exit status for an exception.
struct Failure {
  std::string message;
  int status;
};
[[nodiscard]] Failure failure_of(const std::exception_ptr& thrown);

/// Adds the counts of one run to those of all.
void add(QueueReport& sum, const QueueReport& one);

}  // namespace lober::cli

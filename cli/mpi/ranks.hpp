// The two parts that ranks play. Rank 0 owns the store, deals the jobs, and computes beside it; the others compute.
#pragma once

#include <string>

#include "engine/jobs/batch.hpp"

namespace lober::cli {

/// What all ranks know.
struct SharedWork {
  Plan plan;
  std::string manifest_path;
  QueueOptions queue;  ///< of one rank
};

/// Runs until everything is done; the report sums up all ranks.
[[nodiscard]] BatchReport coordinate(const SharedWork& work, StoreSession& session, int ranks,
                                     const std::function<bool(const QueueProgress&)>& progress);

/// Asks rank 0 for jobs and sends it results until there are no more.
void work_for_coordinator(const SharedWork& work);

/// Adds the counts of one run to those of all.
void add(QueueReport& sum, const QueueReport& one);

}  // namespace lober::cli

// Who runs which job when (private to engine/batch).
//
// Each thread of the arena runs a *worker*, a task that takes one job after the other. Work inside a job is isolated,
// so that a thread which waits for a piece of it never starts another job in between. A worker that finds no job to
// start (memory is short, or what it needs is being read) ends and is started again when something changes; meanwhile,
// and when no job is left, its thread helps inside the jobs of the others.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/batch/queue/curve_cache.hpp"
#include "engine/batch/queue/schedule.hpp"

namespace lober::detail {

class JobRunner {
 public:
  JobRunner() = default;
  JobRunner(const JobRunner&) = delete;
  JobRunner& operator=(const JobRunner&) = delete;
  virtual ~JobRunner() = default;
  /// All curves of the job are in memory and stay there. Cancelled drops the job, anything else that it throws ends the
  /// run.
  virtual void run_job(std::uint32_t number, const Allowance& allowance) = 0;
};

/// Runs the jobs in this order, except that one which has to wait for memory or for a reading is overtaken by the next
/// few hundred. A job that does not fit at all runs alone. One that needs more memory than was booked for it gets that
/// if it is there or if the job is the only one; else it is put back and begun anew when there is more. Returns when
/// all are done, or after `stop` when those that run are. Throws what ended the run, after all other jobs that ran have
/// come to their end undisturbed: the books of the cache are right in any case.
void dispatch(std::vector<ScheduledJob> jobs, CurveCache& cache, bool digests, int threads,
              const std::atomic<bool>& stop, JobRunner& runner);

}  // namespace lober::detail

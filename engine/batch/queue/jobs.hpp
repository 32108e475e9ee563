// A queue of jobs on curves: many small pairs side by side, a huge pair inside itself, each curve read and indexed
// once.
//
//   JobQueue queue({.memory = std::size_t{4} << 30});
//   std::vector<CurveId> curves;
//   for (Curve& curve : mine) curves.push_back(queue.add(std::move(curve)));
//   const auto operation = find_operation("overlay");
//   const std::uint32_t group = queue.add({"", operation, {operation->options, no_settings}});
//   for (CurveId i : curves)
//     for (CurveId j : curves)
//       if (i < j) queue.submit({group, i, j});
//   queue.run([&](const Result& result) {
//     if (!result.failed()) use(result.job, result.values[0]);   // operation->columns says what they are
//   });
//
// An operation may be the caller's own (operation.hpp). The jobs of a manifest are run with a store behind them by
// batch.hpp.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/batch/operations/operation.hpp"
#include "engine/batch/queue/curve_cache.hpp"
#include "lober/batch.hpp"
#include "lober/curve/curve.hpp"

namespace lober::detail {

inline constexpr std::span<const OptionSetting> no_settings{};

struct JobQueueOptions {
  int threads = 0;          ///< 0: as many as the calling thread may use
  std::size_t memory = 0;   ///< bytes, as QueueOptions::memory
  bool digests = false;     ///< hash the curves that are read
  bool concurrent = false;  ///< `done` may be called from several threads at the same time
  /// Curves of earlier queues, for those with names (CurveUnit::names); may be null, has to outlive the queue.
  KeptCurves* kept = nullptr;
};

class JobQueue {
 public:
  explicit JobQueue(const JobQueueOptions& options = {});
  ~JobQueue();
  JobQueue(const JobQueue&) = delete;
  JobQueue& operator=(const JobQueue&) = delete;

  // While `run` works, `add`, `submit`, `reserve` and `run` throw UsageError, from `done` as from other threads.

  /// A curve in memory. It is prepared when a job needs it and stays until the queue goes.
  CurveId add(Curve curve);
  /// Curves that come from elsewhere, all at once; returns their numbers in order. See CurveUnit.
  std::vector<CurveId> add(CurveUnit unit);

  /// Returns the number by which jobs name the group.
  std::uint32_t add(JobGroup group);

  /// Returns the number of the job, counted from 0. Throws UsageError when the operation takes another number of
  /// curves.
  std::size_t submit(Job job);
  /// Makes room for that number of jobs more.
  void reserve(std::size_t jobs);

  /// Runs all jobs that wait, what costs most first as far as memory allows (schedule.hpp), and hands each result to
  /// `done`: one call at a time (unless JobQueueOptions::concurrent), from any thread, in no particular order. A job
  /// that throws a std::exception is a result with `error`. What `done` throws ends the run and is passed on, when the
  /// jobs that ran have ended; it is not called again then (but may be in other calls, if JobQueueOptions::concurrent),
  /// and those that wait are dropped. Results have the same bits for any number of threads, any memory and any order.
  /// May be called again after more was submitted, whatever became of the jobs before: none runs twice, curves stay in
  /// memory.
  QueueReport run(const std::function<void(Result&&)>& done);

  /// Starts no further job; those that run are finished, but for work that can be broken off (Allowance::check), those
  /// that wait are dropped. Between two runs: the next one does nothing. For any thread and for signal handlers.
  void stop();
  /// The same, and what runs is broken off within a fraction of a second: those jobs have no results. The queue runs
  /// nothing more afterwards. For any thread and for signal handlers.
  void cancel();

  /// May be asked from any thread while `run` works.
  [[nodiscard]] QueueProgress progress() const;

 private:
  class Run;
  class Running;
  void refuse_if_running(const char* what) const;
  JobQueueOptions options_;
  std::unique_ptr<CurveCache> cache_;
  std::vector<JobGroup> groups_;
  std::vector<Requirements> requirements_;  ///< by group
  std::vector<Job> jobs_;
  std::size_t first_waiting_ = 0;
  std::atomic<bool> stop_{false}, cancelled_{false}, running_{false};
  struct Counters {
    std::atomic<std::size_t> jobs{0}, done{0}, failed{0};
    std::atomic<double> cost{0}, cost_done{0};
    std::atomic<std::uint64_t> points{0};
  } counters_;
};

}  // namespace lober::detail

// The work between a manifest and a store: resume, run, note the results.
//
//   manifest -> plan     read_manifest reads groups of patterns, pairs and options; make_plan writes them out as curves
//                        (CurveSource), groups of jobs with typed options (JobGroup) and jobs (Job)
//   plan -> result       PlanRunner gives the jobs to a JobQueue, which reads each CurveSource as part of a CurveUnit,
//                        prepares it for all jobs (PreparedCurve), and makes a Result of each job
//   result -> store      StoreSession leaves out what the store has already and hands the rest to the ResultWriter; a
//                        Result is a row of the Store, and what exports read is a Result again
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/batch/plan_runner.hpp"
#include "engine/batch/store/result_writer.hpp"
#include "engine/batch/store/store.hpp"
#include "lober/batch.hpp"

namespace lober::detail {

/// One run on a store: knows the jobs that are left and takes their results.
class StoreSession {
 public:
  /// Opens or creates the store and notes the run. When there are results already, all inputs of the jobs are hashed,
  /// to see which results still hold. `broken` is called when the store can no longer be written.
  StoreSession(const std::string& store_path, const Plan& plan, const Manifest& manifest, Shard shard, int threads,
               std::function<void()> broken);
  ~StoreSession();
  StoreSession(const StoreSession&) = delete;
  StoreSession& operator=(const StoreSession&) = delete;

  /// Jobs of the shard without a result; those that failed before are among them.
  [[nodiscard]] const std::vector<std::uint32_t>& pending() const { return pending_; }
  [[nodiscard]] std::size_t finished_before() const { return finished_before_; }
  /// A line for each job of the shard whose result in the store was damaged: it is among the pending ones.
  [[nodiscard]] const std::vector<std::string>& damaged() const { return damaged_; }
  /// Results of the store that are not of this plan and the inputs as they are now.
  [[nodiscard]] std::size_t hidden() const { return hidden_; }
  /// After `finish`: results that another process had stored in the meantime.
  [[nodiscard]] std::size_t stored_meanwhile() const { return stored_meanwhile_; }

  /// One call at a time. Returns false when the result cannot be used because an input has changed.
  bool add(Result&& result);
  /// Commits and closes the store; throws DataError when it cannot be written. Returns the processor time that the
  /// writing thread took. Nothing may be added afterwards.
  double finish(const std::string& how);

 private:
  void skip_finished(std::vector<std::string> digests);
  void note(CurveId curve, std::string_view digest, bool& usable);

  const Plan& plan_;
  std::optional<Store> store_;
  std::vector<std::uint32_t> pending_;
  std::size_t finished_before_ = 0, hidden_ = 0, stored_meanwhile_ = 0;
  std::vector<std::string> damaged_;
  std::vector<std::string> digests_;  ///< digests of the plan's curves, as first seen in this run
  std::vector<char> seen_;
  std::unique_ptr<ResultWriter> writer_;
};

/// Like run_batch of lober/batch.hpp, for a manifest that is read already.
[[nodiscard]] BatchReport run_batch(const Manifest& manifest, const BatchOptions& options);

/// Calls `watch` about ten times a second on a thread of its own, until `finish` or until it throws.
class ProgressTimer {
 public:
  explicit ProgressTimer(std::function<void()> watch);
  ~ProgressTimer();
  ProgressTimer(const ProgressTimer&) = delete;
  ProgressTimer& operator=(const ProgressTimer&) = delete;
  /// Passes on what `watch` threw.
  void finish();

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  bool done_ = false;
  std::exception_ptr error_;
  std::thread thread_;
};

}  // namespace lober::detail

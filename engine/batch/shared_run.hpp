// A batch whose jobs other processes compute. One process plans, hands out portions of the plan and owns the store; the
// others turn a portion into results. How portions and results travel, and who is alive, is the business of whoever
// calls: the Python package does it with Dask (python/lober/_dask.py).
//
//   SharedRun run(read_manifest("job.toml"), options);
//   for (auto jobs = run.next_portion(8); !jobs.empty(); jobs = run.next_portion(8))
//     run.add(jobs, run_portion(run.encoded(jobs), {"job.toml"}).results);      // elsewhere, many at the same time
//   run.finish("complete");
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/batch/batch.hpp"
#include "engine/batch/work_queue.hpp"

namespace lober::detail {

class SharedRun {
 public:
  /// Plans, opens the store and notes the run, as run_batch does and with its exceptions. `options.queue` and
  /// `options.progress` are not used.
  SharedRun(Manifest manifest, const BatchOptions& options);
  ~SharedRun();

  [[nodiscard]] std::size_t pending() const { return session_->pending().size(); }
  /// Jobs and damaged results of before; what `add` and `fail` have counted. `queue.points`, `queue.threads` and
  /// `queue.warnings` are for the caller to fill in.
  [[nodiscard]] const BatchReport& report() const { return report_; }

  /// As WorkQueue::next_portion, of the pending jobs.
  [[nodiscard]] std::vector<std::uint32_t> next_portion(std::size_t processes) {
    return queue_->next_portion(processes);
  }
  /// A portion as bytes for `run_portion`: a plan of these jobs alone, with their curves. O(jobs).
  [[nodiscard]] std::string encoded(std::span<const std::uint32_t> jobs) const;
  /// The files that these jobs read, as the manifest spells them, each once.
  [[nodiscard]] std::vector<std::string> files(std::span<const std::uint32_t> jobs) const;
  /// Whether jobs write files.
  [[nodiscard]] bool has_outputs() const;

  /// Takes the results of a portion, as `run_portion` returned them. Those of inputs that were read with other contents
  /// before count as failed and are not stored. Throws DataError for bytes that are not the results of these jobs, and
  /// when the store cannot be written.
  void add(std::span<const std::uint32_t> jobs, std::string_view results);
  /// Notes a job that could not be computed, with a message.
  void fail(std::uint32_t job, const std::string& message);
  /// Commits and closes the store; throws DataError when it cannot be written. Nothing may be added afterwards.
  void finish(const std::string& how);

 private:
  void take(Result&& result);

  Manifest manifest_;
  Plan plan_;
  JobKeys keys_;
  std::atomic<bool> broken_{false};
  std::unique_ptr<StoreSession> session_;
  std::optional<WorkQueue> queue_;
  BatchReport report_;
};

/// Where a portion is computed.
struct PortionOptions {
  /// The path of the manifest there, relative to which files are named; the manifest itself need not exist.
  std::string manifest_path;
  /// Names absolute paths of the manifest below this folder; empty: as they are.
  std::string files_root = {};
  std::string output_root = {};  ///< as BatchOptions::output_root
  std::string store = {};        ///< the store of the batch, which no job may replace; may be empty
  QueueOptions queue = {};       ///< limits of threads and memory
  /// Replacements in messages, each text by the one beside it, the first that fits at each position: names of files as
  /// the manifest spells them.
  std::vector<std::pair<std::string, std::string>> names = {};
  /// Curves of the portions before, and of those that run at the same time; null: each portion reads its own.
  KeptCurves* kept = nullptr;
};

/// The results of a portion.
struct PortionResults {
  std::string results;  ///< for SharedRun::add
  QueueReport queue;    ///< counts, times and warnings
};

/// Computes the jobs of a portion. Bits do not depend on where. A job that fails is a result. Throws DataError for
/// bytes that are not a plan, UsageError for operations and options that this version does not have.
[[nodiscard]] PortionResults run_portion(std::string_view portion, const PortionOptions& options);

}  // namespace lober::detail

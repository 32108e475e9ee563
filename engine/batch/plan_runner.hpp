// Jobs of a plan on a queue.
#pragma once

#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "engine/batch/manifest/job_key.hpp"
#include "engine/batch/manifest/plan.hpp"
#include "engine/batch/operations/output_folder.hpp"
#include "engine/batch/queue/jobs.hpp"

namespace lober::detail {

class PlanRunner {
 public:
  /// `jobs`: all that this runner may be given. The plan, the folder, which may be null if no job writes a file, and
  /// the kept curves of other runners, which may be null, have to outlive it.
  PlanRunner(const Plan& plan, const std::string& manifest_path, std::span<const std::uint32_t> jobs,
             const QueueOptions& options, const OutputFolder* outputs = nullptr, KeptCurves* kept = nullptr);

  /// As JobQueue::run, with the numbers of the plan and with keys, `done` being called one at a time, and never again
  /// after it has thrown. May be called several times; curves stay in memory.
  QueueReport run(std::span<const std::uint32_t> jobs, const std::function<void(Result&&)>& done);
  void stop() { queue_.stop(); }
  void cancel() { queue_.cancel(); }
  [[nodiscard]] QueueProgress progress() const { return queue_.progress(); }

 private:
  const Plan& plan_;
  JobKeys keys_;
  JobQueue queue_;
  std::vector<CurveId> ids_;  ///< in the queue, of the plan's curves
  std::mutex done_;
  std::vector<std::uint32_t> submitted_;  ///< numbers in the plan, by number in the queue
};

}  // namespace lober::detail

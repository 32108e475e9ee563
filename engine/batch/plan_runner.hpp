// Jobs of a plan on a queue.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "engine/batch/job_key.hpp"
#include "engine/batch/jobs.hpp"
#include "engine/batch/plan.hpp"

namespace lober {

/// What became of a job of a plan, ready to be stored or sent.
struct PlanResult {
  std::uint32_t job = 0;
  JobKey key{};
  bool failed = false;
  double seconds = 0;
  std::string value;             ///< an encoded Record, or a message
  std::string digest1, digest2;  ///< of the inputs; empty if they could not be read
};

class PlanRunner {
 public:
  /// `jobs`: all that this runner may be given. The plan has to outlive it.
  PlanRunner(const Plan& plan, const std::string& manifest_path, std::span<const std::uint32_t> jobs,
             const QueueOptions& options);

  /// As JobQueue::run, `done` being called one at a time, and never again after it has thrown. May be called several
  /// times; curves stay in memory.
  QueueReport run(std::span<const std::uint32_t> jobs, const std::function<void(PlanResult)>& done);
  void stop() { queue_.stop(); }
  void cancel() { queue_.cancel(); }
  [[nodiscard]] QueueProgress progress() const { return queue_.progress(); }

 private:
  const Plan& plan_;
  JobKeys keys_;
  JobQueue queue_;
  std::vector<CurveId> ids_;  ///< in the queue, of the plan's curves
  std::vector<std::shared_ptr<const Options>> options_;
  std::mutex done_;
  std::vector<std::uint32_t> submitted_;  ///< numbers in the plan, by number in the queue
};

}  // namespace lober

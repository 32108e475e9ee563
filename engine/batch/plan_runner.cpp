#include "engine/batch/plan_runner.hpp"

#include "engine/base/parallel/parallel.hpp"

namespace lober::detail {
PlanRunner::PlanRunner(const Plan& plan, const std::string& manifest_path, std::span<const std::uint32_t> jobs,
                       const QueueOptions& options, const OutputFolder* outputs, KeptCurves* kept)
    : plan_(plan),
      keys_(plan),
      // Keys are made of digests, by all threads.
      queue_({.threads = options.threads, .memory = options.memory, .digests = true, .concurrent = true, .kept = kept}),
      ids_(plan.curves.size(), no_curve) {
  const std::vector<std::vector<CurveId>> units = units_of(plan, jobs);
  std::vector<CurveUnit> made(units.size());  // in parallel: each opens its file to see how long it is
  for_each_block(units.size(), 1, [&](std::size_t k, std::size_t) {
    made[k] = unit_of(sources_of(plan, units[k]), manifest_path, kept);
  });
  for (std::size_t k = 0; k < units.size(); ++k) {
    const std::vector<CurveId> ids = queue_.add(std::move(made[k]));
    for (std::size_t i = 0; i < ids.size(); ++i) ids_[units[k][i]] = ids[i];
  }
  for (JobGroup group : plan.groups) {  // numbered as in the plan
    group.outputs = outputs;
    queue_.add(std::move(group));
  }
}

QueueReport PlanRunner::run(std::span<const std::uint32_t> jobs, const std::function<void(Result&&)>& done) {
  const auto in_queue = [&](CurveId id) { return id == no_curve ? no_curve : ids_[id]; };
  queue_.reserve(jobs.size());
  submitted_.reserve(submitted_.size() + jobs.size());
  for (const std::uint32_t number : jobs) {
    const Job& job = plan_.jobs[number];
    queue_.submit({job.group, in_queue(job.first), in_queue(job.second)});
    submitted_.push_back(number);
  }
  bool thrown = false;
  return queue_.run([&](Result&& result) {
    result.job = submitted_[result.job];
    result.key = keys_(plan_.jobs[result.job], result.digests[0], result.digests[1]);
    const std::lock_guard lock(done_);
    if (thrown) return;
    thrown = true;  // unless what follows returns
    done(std::move(result));
    thrown = false;
  });
}

}  // namespace lober::detail

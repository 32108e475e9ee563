#include "engine/batch/plan_runner.hpp"

#include "engine/base/parallel/parallel.hpp"

namespace lober {
namespace {

// So that keys are made and results encoded by all threads.
QueueOptions concurrently(QueueOptions options) {
  options.concurrent = true;
  return options;
}

}  // namespace

PlanRunner::PlanRunner(const Plan& plan, const std::string& manifest_path, std::span<const std::uint32_t> jobs,
                       const QueueOptions& options)
    : plan_(plan), keys_(plan), queue_(concurrently(options)), ids_(plan.curves.size(), no_curve) {
  const std::vector<PlannedUnit> units = units_of(plan, jobs);
  std::vector<CurveUnit> made(units.size());  // in parallel: each opens its file to see how long it is
  for_each_block(units.size(), 1,
                 [&](std::size_t k, std::size_t) { made[k] = make_unit(plan, units[k], manifest_path); });
  for (std::size_t k = 0; k < units.size(); ++k) {
    const std::vector<CurveId> ids = queue_.add(std::move(made[k]));
    for (std::size_t i = 0; i < ids.size(); ++i) ids_[units[k].curves[i]] = ids[i];
  }
  for (const PlannedGroup& group : plan.groups) options_.push_back(std::make_shared<const Options>(options_of(group)));
}

QueueReport PlanRunner::run(std::span<const std::uint32_t> jobs, const std::function<void(PlanResult)>& done) {
  const auto in_queue = [&](CurveId id) { return id == no_curve ? no_curve : ids_[id]; };
  for (const std::uint32_t number : jobs) {
    const PlannedJob& job = plan_.jobs[number];
    queue_.submit(
        {&operation_of(plan_.groups[job.group]), options_[job.group], in_queue(job.first), in_queue(job.second)});
    submitted_.push_back(number);
  }
  bool thrown = false;
  return queue_.run([&](JobResult result) {
    PlanResult planned;
    planned.job = submitted_[result.job];
    planned.key = keys_(plan_.jobs[planned.job], result.digest1, result.digest2);
    planned.failed = !result.error.empty();
    planned.seconds = result.seconds;
    planned.value = planned.failed ? std::move(result.error) : encode(result.record);
    planned.digest1 = std::move(result.digest1);
    planned.digest2 = std::move(result.digest2);
    const std::lock_guard lock(done_);
    if (thrown) return;
    thrown = true;  // unless what follows returns
    done(std::move(planned));
    thrown = false;
  });
}

}  // namespace lober

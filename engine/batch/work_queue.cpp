#include "engine/batch/work_queue.hpp"

#include <algorithm>
#include <numeric>

namespace lober::detail {

WorkQueue::WorkQueue(const Plan& plan, const std::string& manifest_path, std::span<const std::uint32_t> jobs,
                     std::size_t processes)
    : processes_(processes) {
  const std::vector<std::size_t> points = estimated_points(plan, manifest_path);
  const auto cost = [&](std::uint32_t number) {
    const Job& job = plan.jobs[number];
    std::size_t together = 0;
    for (const CurveId id : job.curves()) together += points[id];
    return plan.group_of(job).operation->cost(together);
  };
  std::vector<std::pair<double, std::uint32_t>> order;
  for (const std::uint32_t job : jobs) order.emplace_back(-cost(job), job);
  std::sort(order.begin(), order.end());
  for (const auto& [minus_cost, job] : order) {
    jobs_.push_back(job);
    costs_.push_back(-minus_cost);
  }
  left_ = std::accumulate(costs_.begin(), costs_.end(), 0.0);
}

std::vector<std::uint32_t> WorkQueue::next_portion() {
  constexpr double least = 2000;  // microseconds of work, so that messages cost nothing beside it
  const double share = std::max(left_ / (4 * static_cast<double>(processes_)), least);
  std::vector<std::uint32_t> portion;
  for (double dealt = 0; next_ < jobs_.size() && (portion.empty() || dealt + costs_[next_] <= share); ++next_) {
    portion.push_back(jobs_[next_]);
    dealt += costs_[next_];
    left_ -= costs_[next_];
  }
  return portion;
}

}  // namespace lober::detail

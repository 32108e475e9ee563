#include "engine/jobs/dealer.hpp"

#include <algorithm>
#include <numeric>

#include "engine/jobs/curve_set.hpp"
#include "engine/jobs/file_unit.hpp"

namespace lober {

Dealer::Dealer(const Plan& plan, const std::string& manifest_path, std::span<const std::uint32_t> jobs,
               std::size_t processes)
    : processes_(processes) {
  std::vector<std::size_t> points(plan.files.size()), curves(plan.files.size());
  for (const PlannedCurve& curve : plan.curves) ++curves[curve.file];
  for (std::size_t file = 0; file < points.size(); ++file) {
    points[file] = estimate_points(located(manifest_path, plan.files[file])) / std::max<std::size_t>(curves[file], 1);
  }
  const auto cost = [&](std::uint32_t number) {
    const PlannedJob& job = plan.jobs[number];
    const auto of = [&](CurveId id) { return id == no_curve ? 0 : points[plan.curves[id].file]; };
    return operation_of(plan.groups[job.group]).cost(of(job.first) + of(job.second));
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

std::vector<std::uint32_t> Dealer::deal() {
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

}  // namespace lober

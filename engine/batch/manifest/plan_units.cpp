// The units that a plan reads, and their size.

#include <numeric>
#include <unordered_map>

#include "engine/batch/manifest/pilots.hpp"
#include "engine/batch/manifest/plan.hpp"
#include "engine/batch/operations/operation.hpp"

namespace lober::detail {

namespace {

std::vector<std::vector<CurveId>> grouped(const Plan& plan, const std::vector<char>& used) {
  std::unordered_map<std::string, std::size_t> numbers;
  std::vector<std::vector<CurveId>> units;
  for (CurveId id = 0; id < plan.curves.size(); ++id) {
    if (used[id] == 0) continue;
    const auto [at, is_new] = numbers.try_emplace(plan.curves[id].unit(), units.size());
    if (is_new) units.emplace_back();
    units[at->second].push_back(id);
  }
  return units;
}

std::vector<std::vector<CurveId>> all_units(const Plan& plan) {
  return grouped(plan, std::vector<char>(plan.curves.size(), 1));
}

}  // namespace

std::vector<std::vector<CurveId>> units_of(const Plan& plan, std::span<const std::uint32_t> jobs) {
  std::vector<char> used(plan.curves.size(), 0);
  for (const std::uint32_t job : jobs) {
    for (const CurveId id : plan.jobs[job].curves()) used[id] = 1;
  }
  return grouped(plan, used);
}

std::vector<CurveSource> sources_of(const Plan& plan, std::span<const CurveId> unit) {
  std::vector<CurveSource> sources;
  for (const CurveId id : unit) sources.push_back(plan.curves[id]);
  return sources;
}

std::vector<std::size_t> estimated_points(const Plan& plan, const std::string& manifest_path) {
  std::vector<std::size_t> points(plan.curves.size());
  for (const std::vector<CurveId>& unit : all_units(plan)) {
    const std::size_t all = unit_of(sources_of(plan, unit), manifest_path).points;
    for (const CurveId id : unit) points[id] = all / unit.size();
  }
  return points;
}

Estimate estimate(const Plan& plan, const std::string& manifest_path) {
  constexpr double read_seconds_per_point = 20e-9;  // seconds for text; binary files take a tenth
  Estimate sum;
  sum.jobs = plan.jobs.size();
  sum.curves = plan.curves.size();
  for (const std::vector<CurveId>& unit : all_units(plan)) {
    (plan.curves[unit.front()].recipe ? sum.computed : sum.files) += 1;
  }
  const std::vector<std::size_t> points = estimated_points(plan, manifest_path);
  sum.points = std::accumulate(points.begin(), points.end(), std::uint64_t{0});
  sum.memory = sum.points * (sizeof(Point) + 5);
  sum.core_seconds = read_seconds_per_point * static_cast<double>(sum.points);
  for (const Job& job : plan.jobs) {
    std::size_t together = 0;
    for (const CurveId id : job.curves()) together += points[id];
    sum.points_in_jobs += together;
    const Operation& operation = *plan.group_of(job).operation;
    if (!operation.pilot) sum.core_seconds += 1e-6 * operation.cost(together);
  }
  const Piloted piloted = run_pilots(plan);
  sum.pilots = piloted.run;
  sum.core_seconds = std::accumulate(piloted.seconds.begin(), piloted.seconds.end(), sum.core_seconds);
  return sum;
}

}  // namespace lober::detail

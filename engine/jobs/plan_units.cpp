// What a plan reads, and how much that is.

#include <numeric>

#include "engine/jobs/curve_set.hpp"
#include "engine/jobs/file_unit.hpp"
#include "engine/jobs/plan.hpp"

namespace lober {

std::vector<PlannedUnit> units_of(const Plan& plan, std::span<const std::uint32_t> jobs) {
  std::vector<char> used(plan.curves.size(), 0);
  for (const std::uint32_t job : jobs) {
    used[plan.jobs[job].first] = 1;
    if (plan.jobs[job].second != no_curve) used[plan.jobs[job].second] = 1;
  }
  std::vector<std::vector<CurveId>> by_file(plan.files.size());
  for (CurveId id = 0; id < plan.curves.size(); ++id) {
    if (used[id] != 0) by_file[plan.curves[id].file].push_back(id);
  }
  std::vector<PlannedUnit> units;
  for (std::uint32_t file = 0; file < by_file.size(); ++file) {
    if (!by_file[file].empty()) units.push_back({file, std::move(by_file[file])});
  }
  return units;
}

CurveUnit make_unit(const Plan& plan, const PlannedUnit& unit, const std::string& manifest_path) {
  std::vector<FileZone> zones;
  for (const CurveId id : unit.curves) {
    const PlannedCurve& curve = plan.curves[id];
    std::optional<std::size_t> zone;
    if (curve.zone >= 0) zone = static_cast<std::size_t>(curve.zone);
    zones.push_back({zone, curve.closed, curve.name});
  }
  return file_unit(located(manifest_path, plan.files[unit.file]), std::move(zones));
}

std::vector<std::size_t> estimated_points(const Plan& plan, const std::string& manifest_path) {
  std::vector<std::size_t> curves(plan.files.size()), points(plan.curves.size());
  for (const PlannedCurve& curve : plan.curves) ++curves[curve.file];
  std::vector<std::size_t> of_file(plan.files.size());
  for (std::size_t file = 0; file < plan.files.size(); ++file) {
    of_file[file] = estimate_points(located(manifest_path, plan.files[file]));
  }
  for (CurveId id = 0; id < points.size(); ++id) {
    const std::uint32_t file = plan.curves[id].file;
    points[id] = of_file[file] / curves[file];
  }
  return points;
}

Estimate estimate(const Plan& plan, const std::string& manifest_path) {
  constexpr double read_seconds_per_point = 20e-9;  // of text; binary files take a tenth
  Estimate sum;
  sum.jobs = plan.jobs.size();
  sum.curves = plan.curves.size();
  sum.files = plan.files.size();
  const std::vector<std::size_t> points = estimated_points(plan, manifest_path);
  sum.points = std::accumulate(points.begin(), points.end(), std::uint64_t{0});
  sum.memory = sum.points * (sizeof(Point) + 5);
  sum.core_seconds = read_seconds_per_point * static_cast<double>(sum.points);
  for (const PlannedJob& job : plan.jobs) {
    const std::size_t both = points[job.first] + (job.second == no_curve ? 0 : points[job.second]);
    sum.points_in_jobs += both;
    sum.core_seconds += 1e-6 * operation_of(plan.groups[job.group]).cost(both);
  }
  return sum;
}

}  // namespace lober

// What a plan reads, and how much that is.

#include <numeric>

#include "engine/batch/curve_set.hpp"
#include "engine/batch/file_unit.hpp"
#include "engine/batch/plan.hpp"

namespace lober {

std::vector<PlannedUnit> units_of(const Plan& plan, std::span<const std::uint32_t> jobs) {
  std::vector<char> used(plan.curves.size(), 0);
  for (const std::uint32_t job : jobs) {
    for (const CurveId id : plan.jobs[job].curves()) used[id] = 1;
  }
  std::vector<std::vector<CurveId>> by_source(plan.sources.size());
  for (CurveId id = 0; id < plan.curves.size(); ++id) {
    if (used[id] != 0) by_source[plan.curves[id].source].push_back(id);
  }
  std::vector<PlannedUnit> units;
  for (std::uint32_t source = 0; source < by_source.size(); ++source) {
    if (!by_source[source].empty()) units.push_back({source, std::move(by_source[source])});
  }
  return units;
}

namespace {

FileZone zone_of(const PlannedCurve& curve, std::string name) {
  std::optional<std::size_t> zone;
  if (curve.zone >= 0) {
    zone = static_cast<std::size_t>(curve.zone);
    name += "#" + std::to_string(curve.zone);
  }
  return {zone, curve.closed, std::move(name)};
}

}  // namespace

CurveUnit make_unit(const Plan& plan, const PlannedUnit& unit, const std::string& manifest_path) {
  const PlannedSource& source = plan.sources[unit.source];
  if (source.file.empty()) return manifold_unit(*source.recipe);
  std::vector<FileZone> zones;
  for (const CurveId id : unit.curves) zones.push_back(zone_of(plan.curves[id], source.file));
  CurveUnit of_file = file_unit(located(manifest_path, source.file), std::move(zones));
  return source.recipe ? image_unit(*source.recipe, std::move(of_file)) : of_file;
}

std::vector<std::string> digests_of(const Plan& plan, const PlannedUnit& unit, const std::string& manifest_path) {
  const PlannedSource& source = plan.sources[unit.source];
  if (source.file.empty()) return {recipe_digest(*source.recipe)};
  const std::string sha256 = file_sha256(located(manifest_path, source.file));
  std::vector<std::string> digests;
  for (const CurveId id : unit.curves) {
    const std::string digest = zone_digest(sha256, zone_of(plan.curves[id], source.file));
    digests.push_back(source.recipe ? recipe_digest(*source.recipe, digest) : digest);
  }
  return digests;
}

std::vector<std::size_t> estimated_points(const Plan& plan, const std::string& manifest_path) {
  std::vector<PlannedUnit> units(plan.sources.size());
  for (std::uint32_t source = 0; source < units.size(); ++source) units[source].source = source;
  for (CurveId id = 0; id < plan.curves.size(); ++id) units[plan.curves[id].source].curves.push_back(id);
  std::vector<std::size_t> points(plan.curves.size());
  for (const PlannedUnit& unit : units) {
    const std::size_t all = make_unit(plan, unit, manifest_path).points;
    for (const CurveId id : unit.curves) points[id] = all / unit.curves.size();
  }
  return points;
}

Estimate estimate(const Plan& plan, const std::string& manifest_path) {
  constexpr double read_seconds_per_point = 20e-9;  // of text; binary files take a tenth
  Estimate sum;
  sum.jobs = plan.jobs.size();
  sum.curves = plan.curves.size();
  for (const PlannedSource& source : plan.sources) (source.recipe ? sum.computed : sum.files) += 1;
  const std::vector<std::size_t> points = estimated_points(plan, manifest_path);
  sum.points = std::accumulate(points.begin(), points.end(), std::uint64_t{0});
  sum.memory = sum.points * (sizeof(Point) + 5);
  sum.core_seconds = read_seconds_per_point * static_cast<double>(sum.points);
  for (const PlannedJob& job : plan.jobs) {
    std::size_t together = 0;
    for (const CurveId id : job.curves()) together += points[id];
    sum.points_in_jobs += together;
    sum.core_seconds += 1e-6 * operation_of(plan.groups[job.group]).cost(together);
  }
  return sum;
}

}  // namespace lober

#include "engine/batch/forecast.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>

#include "engine/base/stopwatch.hpp"
#include "engine/base/text.hpp"

namespace lober {
namespace {

constexpr std::size_t few_points = 20'000;
constexpr std::size_t max_read = 1'000'000;  // points of a file that are read in passing
constexpr double max_seconds = 5;

// So much that few points are enough for it, and for nothing more.
class SmallAllowance final : public Allowance {
 public:
  [[nodiscard]] std::size_t most() const override { return few_points * computed_bytes_per_point; }
};

// The first curve of a unit; null if it cannot be had.
std::shared_ptr<const Curve> first_curve(const Plan& plan, const PlannedUnit& unit, const std::string& manifest_path,
                                         const Allowance& allowance) {
  try {
    const LoadedCurve loaded = make_unit(plan, unit, manifest_path).load({false, allowance}).at(0);
    return loaded.error.empty() ? loaded.curve : nullptr;
  } catch (const std::exception&) {
    return nullptr;
  }
}

// Points after all iterates; 0 if nothing can be said.
double forecast_points(const Plan& plan, PlannedUnit unit, const std::string& manifest_path) {
  const SmallAllowance small;
  Plan part;
  part.sources.push_back(plan.sources[unit.source]);
  part.curves.push_back(plan.curves[unit.curves.front()]);
  part.curves[0].source = 0;
  unit = {0, {0}};
  CurveRecipe& recipe = *part.sources[0].recipe;
  const int all = recipe.iterates, direction = all < 0 ? -1 : 1;
  double before = 0, last = 0;
  for (int k = 1; k <= std::abs(all); ++k) {
    recipe.iterates = k * direction;
    const std::shared_ptr<const Curve> curve = first_curve(part, unit, manifest_path, small);
    if (!curve) {
      if (k == 1) return std::numeric_limits<double>::infinity();  // more than can be tried, or no image at all
      const double factor = std::max(before > 0 ? last / before : 2, 1.0);
      return last * std::pow(factor, std::abs(all) - k + 1);
    }
    before = last;
    last = static_cast<double>(curve->points.size());
  }
  return last;
}

// The sources that go furthest of their kind: a family "a:b" is judged by its end.
std::vector<std::uint32_t> furthest(const Plan& plan) {
  std::map<std::string, std::uint32_t> chosen;
  for (std::uint32_t k = 0; k < plan.sources.size(); ++k) {
    if (!plan.sources[k].recipe || plan.sources[k].recipe->iterates == -1) continue;
    CurveRecipe kind = *plan.sources[k].recipe;
    const int iterates = std::exchange(kind.iterates, kind.iterates < 0 ? -1 : 1);
    const auto [at, is_new] = chosen.try_emplace(kind.name(plan.sources[k].file), k);
    if (!is_new && std::abs(iterates) > std::abs(plan.sources[at->second].recipe->iterates)) at->second = k;
  }
  std::vector<std::uint32_t> sources;
  for (const auto& [kind, source] : chosen) sources.push_back(source);
  return sources;
}

}  // namespace

std::vector<std::string> forecast_shortage(const Plan& plan, const std::string& manifest_path, std::size_t memory) {
  const Stopwatch watch;
  const auto room = static_cast<double>(memory);
  const std::string too_much = ", for which there is no room in " + std::to_string(memory >> 20) + " MiB of memory";
  std::vector<std::string> lines;
  std::vector<CurveId> first_of_source(plan.sources.size(), no_curve);
  for (CurveId id = static_cast<CurveId>(plan.curves.size()); id-- > 0;) first_of_source[plan.curves[id].source] = id;
  for (const std::uint32_t source : furthest(plan)) {
    const CurveId curve = first_of_source[source];
    if (curve == no_curve || watch.seconds() > max_seconds) continue;
    const PlannedUnit unit{source, {curve}};
    if (make_unit(plan, unit, manifest_path).points /
            (1 + static_cast<std::size_t>(std::abs(plan.sources[source].recipe->iterates))) >
        max_read) {
      continue;
    }
    const double points = forecast_points(plan, unit, manifest_path);
    if (!(points * static_cast<double>(computed_bytes_per_point) > room)) continue;
    lines.push_back(plan.name(curve) + " may come to " +
                    (std::isfinite(points) ? "about " + format_number(std::round(points)) : "far too many") +
                    " points" + too_much);
  }
  std::set<std::uint32_t> judged;
  for (const PlannedJob& job : plan.jobs) {
    const PlannedGroup& group = plan.groups[job.group];
    const Operation& operation = operation_of(group);
    if (!operation.result_bytes || job.first == no_curve || watch.seconds() > max_seconds) continue;
    const PlannedUnit unit{plan.curves[job.first].source, {job.first}};
    if (plan.sources[unit.source].recipe || judged.contains(job.group)) continue;
    if (make_unit(plan, unit, manifest_path).points > max_read) continue;
    judged.insert(job.group);
    const std::shared_ptr<const Curve> curve = first_curve(plan, unit, manifest_path, Allowance());
    if (!curve) continue;
    if (operation.result_bytes(*curve, options_of(group)) > room) {
      lines.push_back(group.operation + " with " + group.to_string() + " asks for too many points of " +
                      plan.name(job.first) + too_much);
    }
  }
  return lines;
}

}  // namespace lober

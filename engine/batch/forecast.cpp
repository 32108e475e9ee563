#include "engine/batch/forecast.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>

#include "engine/base/stopwatch.hpp"
#include "engine/base/text.hpp"
#include "kernels/elementary.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t few_points = 20'000;
constexpr std::size_t max_read = 1'000'000;  // points of a file that are read in passing
constexpr double max_seconds = 5;

// So much that few points are enough for it, and for nothing more.
class SmallAllowance final : public Allowance {
 public:
  [[nodiscard]] std::size_t most() const override { return few_points * computed_bytes_per_point; }
};

// The curve of a source; null if it cannot be had.
std::shared_ptr<const Curve> curve_of(const CurveSource& source, const std::string& manifest_path,
                                      const Allowance& allowance) {
  try {
    const LoadedCurve loaded = unit_of({source}, manifest_path).load({false, allowance}).at(0);
    return loaded.error.empty() ? loaded.curve : nullptr;
  } catch (const std::exception&) {
    return nullptr;
  }
}

// Points after all iterates; 0 if nothing can be said.
double forecast_points(CurveSource source, const std::string& manifest_path) {
  const SmallAllowance small;
  CurveRecipe& recipe = *source.recipe;
  const int all = recipe.iterates, direction = all < 0 ? -1 : 1;
  double before = 0, last = 0;
  for (int k = 1; k <= std::abs(all); ++k) {
    recipe.iterates = k * direction;
    const std::shared_ptr<const Curve> curve = curve_of(source, manifest_path, small);
    if (!curve) {
      if (k == 1) return std::numeric_limits<double>::infinity();  // more than can be tried, or no image at all
      const double factor = std::max(before > 0 ? last / before : 2, 1.0);
      return last * elementary::power(factor, std::abs(all) - k + 1);
    }
    before = last;
    last = static_cast<double>(curve->points.size());
  }
  return last;
}

// The curves that go furthest of their kind: a family "a:b" is judged by its end, a file by the first of its zones.
std::vector<const CurveSource*> furthest(const Plan& plan) {
  std::map<std::string, const CurveSource*> chosen;
  for (const CurveSource& source : plan.curves) {
    if (!source.recipe || source.recipe->iterates == -1) continue;
    CurveRecipe kind = *source.recipe;
    const int iterates = std::exchange(kind.iterates, kind.iterates < 0 ? -1 : 1);
    const auto [at, is_new] = chosen.try_emplace(kind.name(source.file), &source);
    if (!is_new && std::abs(iterates) > std::abs(at->second->recipe->iterates)) at->second = &source;
  }
  std::vector<const CurveSource*> sources;
  sources.reserve(chosen.size());
  for (const auto& [kind, source] : chosen) sources.push_back(source);
  return sources;
}

}  // namespace

std::vector<std::string> forecast_shortage(const Plan& plan, const std::string& manifest_path, std::size_t memory) {
  const Stopwatch watch;
  const auto budget = static_cast<double>(memory);
  const std::string too_much = ", for which there is no room in " + std::to_string(memory >> 20) + " MiB of memory";
  std::vector<std::string> lines;
  for (const CurveSource* const source : furthest(plan)) {
    if (watch.seconds() > max_seconds) continue;
    const std::size_t images = 1 + static_cast<std::size_t>(std::abs(source->recipe->iterates));
    if (unit_of({*source}, manifest_path).points / images > max_read) continue;
    const double points = forecast_points(*source, manifest_path);
    if (!(points * static_cast<double>(computed_bytes_per_point) > budget)) continue;
    lines.push_back(source->name() + " may come to " +
                    (std::isfinite(points) ? "about " + format_number(std::round(points)) : "far too many") +
                    " points" + too_much);
  }
  std::set<std::uint32_t> judged;
  for (const Job& job : plan.jobs) {
    const JobGroup& group = plan.group_of(job);
    if (!group.operation->result_bytes || job.first == no_curve || watch.seconds() > max_seconds) continue;
    const CurveSource& source = plan.curves[job.first];
    if (source.recipe || judged.contains(job.group)) continue;
    if (unit_of({source}, manifest_path).points > max_read) continue;
    judged.insert(job.group);
    const std::shared_ptr<const Curve> curve = curve_of(source, manifest_path, Allowance());
    if (!curve) continue;
    if (group.operation->result_bytes(*curve, group.options) > budget) {
      lines.push_back(group.operation->name + " with " + group.options.to_string() + " asks for too many points of " +
                      source.name() + too_much);
    }
  }
  return lines;
}

}  // namespace lober::detail

// The table of `lober escape`, for people.

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "cli/escape_report.hpp"

namespace lober::cli {
namespace {

// As many digits as the error bar leaves, at most twelve.
std::string percent(double fraction, double error) {
  if (!(fraction == fraction)) return "torn";
  if (fraction == 0 && error == 0) return "0";
  const int digits = error > 0 ? std::clamp(static_cast<int>(-std::floor(std::log10(100 * error))), 0, 12) : 12;
  return fmt::format("{:.{}f} +- {:.0e}", 100 * fraction, digits, 100 * error);
}

const EscapeFraction* row(const Escape& result, std::size_t entry, std::size_t exit, int crossings,
                          std::size_t& number) {
  for (number = 0; number < result.table.size(); ++number) {
    const EscapeFraction& here = result.table[number];
    if (here.entry == entry && here.exit == exit && here.crossings == crossings) return &here;
  }
  return nullptr;
}

std::string orbits_text(const EscapeReport& report, const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Bottleneck& neck = report.result.bottlenecks[k];
    const PeriodicOrbit& orbit = neck.orbit;
    text += fmt::format(
        "bottleneck {:<6} saddle ({:.12g}, {:.12g}), energy {:.12g}\n"
        "  periodic orbit   period {:.15g}, action {:.15g}, multiplier {:.13g}{}\n"
        "  tubes            area {:.15g} by action; largest relative difference of the curves {:.0e}\n",
        names[k], orbit.saddle.at[0], orbit.saddle.at[1], orbit.saddle.energy, orbit.period, orbit.action,
        orbit.multiplier, orbit.brake ? ", at rest at both ends" : "", neck.area, neck.area_defect);
    for (const FlowState& turning : orbit.turning) {
      text += fmt::format("  turns at         ({:.15g}, {:.15g})\n", turning[0], turning[1]);
    }
  }
  return text;
}

}  // namespace

std::vector<std::string> bottleneck_names(const Escape& result) {
  const auto axis = static_cast<std::size_t>(result.section.coordinate);
  const auto& necks = result.bottlenecks;
  if (necks.size() == 2 && necks[0].orbit.saddle.at[axis] < result.section.value &&
      necks[1].orbit.saddle.at[axis] > result.section.value) {
    return {"left", "right"};
  }
  std::vector<std::string> names;
  for (std::size_t k = 0; k < necks.size(); ++k) names.push_back(std::to_string(k + 1));
  return names;
}

std::string escape_table(const EscapeReport& report) {
  const Escape& result = report.result;
  const std::vector<std::string> names = bottleneck_names(result);
  std::string text =
      fmt::format("{}, energy {:.15g}\n{}", report.system.name, result.energy, orbits_text(report, names));
  if (result.table.empty()) return text;
  constexpr int column = 26;
  for (std::size_t exit = 0; exit < names.size(); ++exit) {
    text += fmt::format("\nexit {:<7} after crossing", names[exit]);
    for (const std::string& entrance : names) text += fmt::format("  {:>{}}", "entrance " + entrance + ", %", column);
    text += '\n';
    for (int n = 1; n <= report.options.crossings; ++n) {
      text += fmt::format("{:>25} ", n);
      std::string counted = fmt::format("{:>26}", "counted");
      for (std::size_t entry = 0; entry < names.size(); ++entry) {
        std::size_t number = 0;
        const EscapeFraction* const found = row(result, entry, exit, n, number);
        text += fmt::format("  {:>{}}", found ? percent(found->fraction, found->error) : "-", column);
        if (!report.check || !found) continue;
        const MonteCarloFraction& check = report.check->table[number];
        counted += fmt::format("  {:>{}}", percent(check.fraction, check.standard_error), column);
      }
      text += '\n';
      if (report.check) text += counted + '\n';
    }
  }
  for (std::size_t entry = 0; entry < names.size(); ++entry) {
    text += fmt::format("\nentrance {}: still inside after crossing", names[entry]);
    for (const Survival& step : survival(result, entry)) {
      text += fmt::format("  {}: {} %", step.crossings, fmt::format("{:.10g}", 100 * step.remains));
    }
  }
  text += fmt::format("\nlargest difference between two splits of one fraction: {:.0e} %\n",
                      100 * result.largest_split_difference);
  if (report.check) {
    text += fmt::format("{} trajectories from each entrance, {} lost: largest deviation {:.2f} standard errors\n",
                        report.check->trajectories, report.check->lost, report.check->largest_deviation);
  }
  return text;
}

}  // namespace lober::cli

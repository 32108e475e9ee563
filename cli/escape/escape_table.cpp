// The table of `lober escape`, for people: what is known first is printed first.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "cli/escape/escape_report.hpp"
#include "cli/report/table.hpp"

namespace lober::cli {
namespace {

// As many digits as the error bar leaves, at most twelve.
std::string percent(double fraction, double error) {
  if (!(fraction == fraction)) return "not known";
  if (fraction == 0 && error == 0) return "0";
  const int digits = error > 0 ? std::clamp(static_cast<int>(-std::floor(std::log10(100 * error))), 0, 12) : 12;
  return fmt::format("{:.{}f} +- {:.0e}", 100 * fraction, digits, 100 * error);
}

Table crossings_table(const char* last) {
  return Table({{"n", 4, Align::right, 0}, {"entrance", 10, Align::left, 2}, {"exit", 10, Align::left}, {last, 28}});
}

std::string orbits_text(const Escape& result, const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Bottleneck& bottleneck = result.bottlenecks[k];
    const PeriodicOrbit& orbit = bottleneck.orbit;
    text += fmt::format(
        "bottleneck {:<6} saddle ({:.12g}, {:.12g}), energy {:.12g}\n"
        "  periodic orbit   period {:.15g}, action {:.15g}, multiplier {:.13g}{}\n"
        "  tubes            area {:.15g} by action; largest relative difference of the curves {:.0e}\n",
        names[k], orbit.saddle.at[0], orbit.saddle.at[1], orbit.saddle.energy, orbit.period, orbit.action,
        orbit.multiplier, orbit.brake ? ", at rest at both ends" : "", bottleneck.area, bottleneck.area_defect);
    for (const FlowState& turning : orbit.turning) {
      text += fmt::format("  turns at         ({:.15g}, {:.15g})\n", turning[0], turning[1]);
    }
  }
  for (const SaddlePoint& saddle : result.also_open) {
    text += fmt::format("also open         saddle ({:.12g}, {:.12g}), energy {:.12g}: what leaves there is not known\n",
                        saddle.at[0], saddle.at[1], saddle.energy);
  }
  return text;
}

}  // namespace

std::string escape_heading(const std::string& system, const Escape& result) {
  return fmt::format("{}, energy {:.15g}\n{}", system, result.energy, orbits_text(result, bottleneck_names(result)));
}

std::string escape_rows(const Escape& result, int n) {
  const std::vector<std::string> names = bottleneck_names(result);
  std::string text;
  const Table table = crossings_table("leaves after crossing n, %");
  if (n == 1) text += "\n" + table.head();
  for (const EscapeFraction& row : result.table) {
    if (std::max(row.crossings, 1) != n) continue;
    text +=
        table.row({std::to_string(row.crossings), names[row.entry], names[row.exit], percent(row.fraction, row.error)},
                  row.cut ? "  of cut curves" : "");
  }
  return text;
}

std::string escape_summary(const EscapeReport& report) {
  const operations::SystemEscape& result = report.result();
  const std::vector<std::string> names = bottleneck_names(result);
  if (report.crossings_asked() == 0) return {};
  std::string text;
  if (result.stop != EscapeStop::done) text += "\n" + stop_text(report) + "\n";
  for (std::size_t entry = 0; entry < names.size(); ++entry) {
    const std::vector<Survival> steps = survival(result, entry);
    if (steps.empty()) continue;
    text += fmt::format("\nentrance {}: {} after crossing", names[entry],
                        result.also_open.empty() ? "still inside" : "not left by these bottlenecks");
    for (const Survival& step : steps) {
      text += fmt::format("  {}: {} %", step.crossings, percent(step.remains, step.error));
    }
  }
  const bool split = std::any_of(result.table.begin(), result.table.end(),
                                 [](const EscapeFraction& row) { return row.other == row.other; });
  if (split) {
    text += fmt::format("\nlargest difference between two splits of one fraction: {:.0e} %\n",
                        100 * result.largest_split_difference);
  }
  if (!result.counted) return text;
  const Table table = crossings_table("counted, %");
  if (report.lists_counts) text += "\n" + table.head();
  for (std::size_t k = 0; report.lists_counts && k < result.table.size(); ++k) {
    const EscapeFraction& row = result.table[k];
    const MonteCarloFraction& counted = result.counted->table[k];
    text += table.row({std::to_string(row.crossings), names[row.entry], names[row.exit],
                       percent(counted.fraction, counted.standard_error)});
  }
  text +=
      fmt::format("{} trajectories from each entrance, {} {}: largest deviation {:.2f} standard errors\n",
                  result.counted->trajectories, result.counted->lost,
                  result.also_open.empty() ? "lost" : "lost or left by other ways", result.counted->largest_deviation);
  return text;
}

std::string stop_text(const EscapeReport& report) {
  const operations::SystemEscape& result = report.result();
  std::string how_far = result.crossings == 0
                            ? fmt::format("no n of {}", report.crossings_asked())
                            : fmt::format("n = 1..{} of {}", result.crossings, report.crossings_asked());
  switch (result.stop) {
    case EscapeStop::done:
      return how_far;
    case EscapeStop::points:
      return fmt::format("{}: the next image needs {:.1g} points (--max-points {})", how_far, result.points_ahead,
                         report.options.whole("max_points"));
    case EscapeStop::work:
      if (result.work_ahead == 0) {
        return how_far +
               ": images were broken off that take more work than is done unasked (--budget SECONDS allows more)";
      }
      return fmt::format(
          "{}: the next images need about {:.2g} times the work so far, which is more than is done unasked (--budget "
          "SECONDS allows more)",
          how_far, result.work_ahead / result.work_spent);
    case EscapeStop::budget:
      if (result.seconds_ahead == 0) {
        return fmt::format(
            "{}: the next images were broken off after {:.3g} s in all; --budget {:.15g}, a larger one "
            "allows more",
            how_far, result.seconds_spent, report.options.real("budget"));
      }
      return fmt::format("{}: the next images need about {:.2g} s after the {:.2g} s so far (--budget {:.15g})",
                         how_far, result.seconds_ahead, result.seconds_spent, report.options.real("budget"));
    case EscapeStop::lost:
      return how_far + ": trajectories next to a bottleneck cannot be followed further";
    case EscapeStop::cancelled:
      return how_far + ": interrupted";
  }
  return how_far;
}

}  // namespace lober::cli

// `escape`: the table of escape from a potential well. No curves.
#include <algorithm>
#include <cmath>

#include "engine/base/text.hpp"
#include "engine/batch/operations/of_table.hpp"
#include "engine/batch/operations/table.hpp"
#include "kernels/elementary.hpp"

namespace lober::detail {
namespace {

struct FractionNames {
  std::string name, meaning, error, meaning_of_error;
};

FractionNames names_of(std::size_t bottlenecks, std::size_t entrance, std::size_t exit, double n) {
  const std::string from = std::to_string(entrance), to = std::to_string(exit), crossing = format_number(n);
  const bool several = bottlenecks > 1;
  FractionNames names;
  names.name = "fraction_" + (several ? from + "_" + to + "_" : "") + crossing;
  const std::string who = several ? " entering by bottleneck " + from + " that leave by bottleneck " + to
                                  : std::string(" entering that leave");
  names.meaning = "fraction of those" + who + " at crossing " + crossing;
  names.error = names.name + "_error";
  names.meaning_of_error = "error of " + names.name;
  return names;
}

// The table goes by entrance, then by exit, then by crossing: a crossing that is not the one after the last begins the
// next exit. Entrances and exits are the same bottlenecks, in the same order.
std::vector<std::pair<Column, double>> fractions(const Result& result) {
  const std::vector<double>&n = result.lists.at(0), &fraction = result.lists.at(1), &error = result.lists.at(2);
  std::vector<std::size_t> block(n.size());
  for (std::size_t k = 1; k < n.size(); ++k) block[k] = block[k - 1] + (n[k] > n[k - 1] ? 0 : 1);
  const std::size_t blocks = n.empty() ? 0 : block.back() + 1;
  const auto bottlenecks = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(blocks))));
  if (bottlenecks * bottlenecks != blocks || fraction.size() != n.size() || error.size() != n.size()) return {};
  std::vector<std::pair<Column, double>> columns;
  for (std::size_t k = 0; k < n.size(); ++k) {
    const FractionNames names = names_of(bottlenecks, block[k] / bottlenecks + 1, block[k] % bottlenecks + 1, n[k]);
    columns.push_back({{names.name, Column::Kind::real, "", names.meaning}, fraction[k]});
    columns.push_back({{names.error, Column::Kind::real, "", names.meaning_of_error}, error[k]});
  }
  return columns;
}

// Seconds that following a trajectory over a crossing takes, of one core; those of a table whose work is at its limit,
// for each evaluation of the vector field that the limit allows.
constexpr double trajectory_seconds = 1.8e-6, work_seconds = 1.2e-8;

// Curves of a larger tolerance, and no trajectories. Points, and with them time, grow about as the inverse cube root of
// the tolerance. Where that tolerance does not get as far as was asked for, images wind so much that the table itself
// will end at its limit.
Pilot pilot_of(std::span<const OptionSpec> specs, std::size_t known, const Options& options) {
  constexpr double coarser = 100, coarse = 1e-4;
  const double tolerance = options.real("tolerance"),
               pilot_tolerance = std::max(tolerance, std::min(coarser * tolerance, coarse));
  const auto crossings = static_cast<double>(options.whole("crossings"));
  const auto trajectories = crossings * static_cast<double>(options.whole("monte_carlo"));
  const OptionValue* const budget = options.find("budget");
  const double limit = budget != nullptr ? std::get<double>(*budget) : work_seconds * options.real("max_work");
  std::vector<OptionSetting> settings(options.settings().begin(), options.settings().end());
  settings.push_back({"tolerance", pilot_tolerance});
  settings.push_back({"monte_carlo", std::int64_t{0}});
  const double factor = crossings > 0 ? elementary::power(pilot_tolerance / tolerance, 1.0 / 3) : 1;
  return {Options(specs, settings), [=](double seconds, const Result& result) {
            const bool whole = !result.failed() && result.values[known] >= crossings;
            return (whole ? std::min(factor * seconds, limit) : limit) + trajectory_seconds * trajectories;
          }};
}

}  // namespace

Operation escape_operation() {
  TableJob job{"escapes",
               {{"total_energy", "energy"}, {"known_crossings", "crossings"}},
               {{"n", "table.crossings"}, {"fraction", "table.fraction"}, {"fraction_error", "table.error"}}};
  job.needs_tangle = false;
  job.microseconds = 5e5;
  job.memory = std::size_t{256} << 20;
  Operation operation = operation_of(operations::named("escape"), job);
  operation.spread = fractions;
  const auto known =
      static_cast<std::size_t>(std::find_if(operation.columns.begin(), operation.columns.end(),
                                            [](const Column& column) { return column.name == "known_crossings"; }) -
                               operation.columns.begin());
  operation.pilot = [specs = operation.options, known](const Options& options) {
    return pilot_of(specs, known, options);
  };
  return operation;
}

}  // namespace lober::detail

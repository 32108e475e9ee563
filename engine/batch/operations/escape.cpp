// `escape`: the table of escape from a potential well. No curves.
#include <cmath>

#include "engine/base/text.hpp"
#include "engine/batch/operations/of_table.hpp"
#include "engine/batch/operations/table.hpp"

namespace lober::detail {
namespace {

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
    const std::string entrance = std::to_string(block[k] / bottlenecks + 1),
                      exit = std::to_string(block[k] % bottlenecks + 1), crossing = format_number(n[k]),
                      name = "fraction_" + (bottlenecks > 1 ? entrance + "_" + exit + "_" : "") + crossing;
    const std::string who = bottlenecks > 1
                                ? " entering by bottleneck " + entrance + " that leave by bottleneck " + exit
                                : std::string(" entering that leave");
    columns.push_back(
        {{name, Column::Kind::real, "", "fraction of those" + who + " at crossing " + crossing}, fraction[k]});
    columns.push_back({{name + "_error", Column::Kind::real, "", "error of " + name}, error[k]});
  }
  return columns;
}

}  // namespace

Operation escape_operation() {
  TableJob job{"escapes",
               {{"total_energy", "energy"}, {"known_crossings", "crossings"}},
               {{"n", "table.crossings"}, {"fraction", "table.fraction"}, {"fraction_error", "table.error"}}};
  job.needs_tangle = false;
  job.microseconds = 5e6;
  job.memory = std::size_t{256} << 20;
  Operation operation = operation_of(operations::named("escape"), job);
  operation.spread = fractions;
  return operation;
}

}  // namespace lober::detail

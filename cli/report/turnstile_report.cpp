#include "cli/report/turnstile_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <limits>

#include "cli/report/report.hpp"

namespace lober::cli {
std::vector<TurnstileLobe> turnstile_lobes(const ManifoldTangle& manifolds) {
  std::vector<TurnstileLobe> lobes;
  for (std::size_t k = 0; k < manifolds.period(); ++k) {
    TurnstileLobe lobe;
    lobe.number = manifolds.image_of_bip(-1) + k;
    lobe.area = manifolds.tangle.lobes[lobe.number].area;
    lobe.error = manifolds.tangle.lobes[lobe.number].smooth_error;
    lobe.action =
        manifolds.areas_by_action.empty() ? std::numeric_limits<double>::quiet_NaN() : manifolds.areas_by_action[k];
    lobe.action_error = manifolds.areas_by_action.empty() ? lobe.action : manifolds.action_errors[k];
    lobe.difference = std::fabs(lobe.area - lobe.action);
    lobes.push_back(lobe);
  }
  return lobes;
}

std::string saddles_text(const ManifoldTangle& manifolds) {
  std::string text;
  for (const bool unstable : {true, false}) {
    const LocalManifold& local = unstable ? manifolds.local_u : manifolds.local_s;
    text += fmt::format("{}          saddle ({:.15g}, {:.15g}), multiplier {:.15g}, {} points\n", unstable ? "U" : "S",
                        local.saddle.x, local.saddle.y, local.multiplier,
                        (unstable ? manifolds.u : manifolds.s).points.size());
  }
  return text;
}

std::string turnstile_text(const ManifoldTangle& manifolds) {
  const Point first = manifolds.orbits.front().at, bip = manifolds.orbits.back().at;
  std::string text = fmt::format("pips       {} from ({:.12g}, {:.12g}) to the bip ({:.12g}, {:.12g})\n",
                                 counted(manifolds.period(), "lobe", "lobes"), first.x, first.y, bip.x, bip.y);
  const bool with_action = !manifolds.areas_by_action.empty();
  Table table({{"lobe", 6, Align::right, 0},
               {"label", 7, Align::left, 2},
               {"area by geometry", 21, Align::right, 0},
               {"+-", 9}});
  if (with_action) {
    table.add({"area by action", 22, Align::right, 0});
    table.add({"+-", 9});
    table.add({"difference", 11});
  }
  text += "\n" + table.head();
  for (const TurnstileLobe& lobe : turnstile_lobes(manifolds)) {
    std::vector<std::string> cells{std::to_string(lobe.number),
                                   lober::text(manifolds.tangle.images.labels[lobe.number]),
                                   fmt::format("{:.15g}", lobe.area), fmt::format("{:.1e}", lobe.error)};
    if (with_action) {
      cells.push_back(fmt::format("{:.15g}", lobe.action));
      cells.push_back(fmt::format("{:.1e}", lobe.action_error));
      cells.push_back(fmt::format("{:.1e}", lobe.difference));
    }
    text += table.row(cells);
  }
  if (!with_action) text += "        (no area by action: the map does not preserve area, or its action is not known)\n";
  return text;
}

}  // namespace lober::cli

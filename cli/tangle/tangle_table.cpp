// The table of `lober tangle` for people.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "cli/report/agreement_report.hpp"
#include "cli/report/turnstile_report.hpp"
#include "cli/tangle/tangle_report.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_table_lobes = 24;  // those around the bip

std::string manifolds_text(const TangleReport& report) {
  const std::array<std::string, 2> specs{spec_of(report.inputs[0]), spec_of(report.inputs[1])};
  const std::size_t width = std::max(specs[0].size(), specs[1].size());
  std::string text;
  for (std::size_t k = 0; k < 2; ++k) {
    text += fmt::format("{}  {:<{}}  {:>9} points{}\n", k == 0 ? "U" : "S", specs[k], width,
                        report.inputs[k].curve.points.size(), report.reversed[k] ? "  reversed" : "");
  }
  return text + report.lift;
}

void add_boundary(std::string& text, const TangleReport& report) {
  const operations::CurveTangle& result = report.result();
  if (!result.boundary) return;
  const Boundary& boundary = *result.boundary;
  const Point bip = result.pips[boundary.bip].at;
  text +=
      fmt::format("boundary   area {:.16g} +- {:.1e} rounding{}, bip {} at ({:.8g}, {:.8g})\n", boundary.area,
                  result.rounding(boundary.area),
                  result.smooth ? fmt::format(", {:.1e} {}", boundary.smooth_error,
                                              report.origin ? "growth and integration" : "against the smooth curves")
                                : std::string(),
                  boundary.bip, bip.x, bip.y);
  if (boundary.crosses_itself) {
    text += "           the path that closes it meets the manifolds: inside is where it winds\n";
    if (boundary.of_polygons)
      text += "           its area is that of the polygon, and the bar contains the difference\n";
  }
}

void add_turnstile(std::string& text, const Images& images) {
  if (images.period == 0) {
    text += fmt::format("turnstile  not known, {}\n", images.reason);
    return;
  }
  if (images.turnstile_begin < images.turnstile_end) {
    text += fmt::format("turnstile  lobes {} to {}: L12 {:.16g}, L21 {:.16g}\n", images.turnstile_begin,
                        images.turnstile_end - 1, images.lobe_area12, images.lobe_area21);
  } else {
    text += fmt::format("turnstile  its first pips, {} before the bip, are not there\n", images.period);
  }
  text += fmt::format("images     {} pips further ({}); ", images.period, images.given ? "given" : "inferred");
  if (images.compared > 0) {
    text += fmt::format("area changes by {:.2g} at most ({}), ", images.area_change,
                        counted(images.compared, "pair", "pairs"));
  }
  text += fmt::format("turnstile sum {:.2g}, of the mean lobe\n", images.turnstile_sum);
}

// Where a branch returns to itself only after two iterates, images are those of the second iterate.
std::string reflection_text(const ManifoldTangle& manifolds) {
  if (!(manifolds.local_u.multiplier < 0)) return {};
  return fmt::format("reflection both multipliers are negative: images, the turnstile and n are those of f^{}\n",
                     std::abs(manifolds.local_u.image().steps));
}

void add_lobes(std::string& text, const TangleReport& report) {
  const operations::CurveTangle& result = report.result();
  const std::size_t count = result.lobes.size();
  if (count == 0) return;
  const Table table({{"lobe", 6, Align::right, 0},
                     {"label", 8, Align::left, 2},
                     {"signed area", 23},
                     {"inside", 12},
                     {"outside", 12},
                     {"perimeter", 11},
                     {"width", 11}});
  text += "\n" + table.head();
  const std::size_t bip = result.boundary->bip, most = std::min(max_table_lobes, count);
  const std::size_t first = std::min(bip > most / 2 ? bip - most / 2 : 0, count - most);
  if (first > 0) text += table.row({"..."}, fmt::format("  {} before", first));
  for (std::size_t k = first; k < first + most; ++k) {
    const Lobe& lobe = result.lobes[k];
    const LobeShape& shape = result.shapes[k];
    const std::string label = lober::text(result.images.labels[k]);
    text += table.row({std::to_string(k), label.empty() ? "-" : label, fmt::format("{:.16g}", lobe.area),
                       fmt::format("{:.6g}", lobe.inside), fmt::format("{:.6g}", lobe.outside),
                       fmt::format("{:.5g}", shape.perimeter), fmt::format("{:.5g}", shape.width)},
                      lobe.simple ? "" : "  not simple");
  }
  if (first + most < count) text += table.row({"..."}, fmt::format("  {} more", count - first - most));
  const auto worst = [&](const char* of) {
    return operations::NumberPath(report.operation().result, of).first(report.outcome.value.get());
  };
  text +=
      fmt::format("        +- {:.1e} rounding, {:.1e} {} at most\n", worst("error.rounding.lobe"),
                  worst("error.discretisation.lobe"), result.smooth ? "against the smooth curves" : "discretisation");
}

void add_overlaps(std::string& text, const TangleReport& report) {
  if (!report.result().overlaps) return;
  const std::vector<LobeOverlap>& all = *report.result().overlaps;
  text += fmt::format("\n{} of lobes overlap\n", counted(all.size(), "pair", "pairs"));
  if (all.empty()) return;
  const Table table({{"lobe", 6, Align::right, 0}, {"lobe", 6}, {"area", 23}});
  text += table.head();
  std::vector<double> areas;
  areas.reserve(all.size());
  for (const LobeOverlap& both : all) areas.push_back(both.area);
  const std::vector<std::uint32_t> order = largest(areas);
  for (const std::uint32_t number : order) {
    text += table.row(
        {std::to_string(all[number].i), std::to_string(all[number].j), fmt::format("{:.16g}", all[number].area)});
  }
  if (all.size() > order.size()) text += fmt::format("{:>6} and {} more\n", "...", all.size() - order.size());
}

}  // namespace

std::string tangle_table(const TangleReport& report) {
  const operations::CurveTangle& result = report.result();
  std::string text = agreement_text(report.outcome.agreement);
  text += report.origin ? system_text(*report.origin->system) + "\n" + saddles_text(*report.manifolds())
                        : manifolds_text(report);
  text += fmt::format("\n{}; {}, {}\n", meetings_text(result.nodes), counted(result.pips.size(), "pip", "pips"),
                      counted(result.lobes.size(), "lobe", "lobes"));
  add_boundary(text, report);
  if (report.origin) text += reflection_text(*report.manifolds());
  if (!result.lobes.empty()) add_turnstile(text, result.images);
  if (report.origin) text += turnstile_text(*report.manifolds());
  add_lobes(text, report);
  add_overlaps(text, report);
  return text;
}

}  // namespace lober::cli

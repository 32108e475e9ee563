// The curves of an escape.

#include "cli/escape/escape_report.hpp"
#include "cli/report/curve_file.hpp"
#include "cli/report/text.hpp"
#include "lober/curve/files.hpp"

namespace lober::cli {
namespace {

void add_zones(std::vector<Zone>& zones, const std::string& title, const char* map,
               const std::vector<TubeCurve>& curves) {
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const TubeCurve& curve = curves[k];
    std::string full = title;
    if (k > 0) append_all(full, " ", map, k);
    if (curve.cut) full += " cut";
    if (!curve.image.closed || (!curve.complete && !curve.cut)) full += " open";
    zones.push_back({full, {curve.image.points.begin(), curve.image.points.end()}});
  }
}

// Points of the periodic orbit at equal times, in the two coordinates of position: it does not meet the section.
std::vector<Point> orbit_positions(const Flow& flow, const PeriodicOrbit& orbit) {
  constexpr std::size_t count = 256;
  const auto pairs = flow.conjugate_pairs();
  std::vector<Point> points;
  for (const FlowState& state : states_along(flow, orbit, count, {.tolerance = 1e-14})) {
    points.push_back({state[static_cast<std::size_t>(pairs[0].q)], state[static_cast<std::size_t>(pairs[1].q)]});
  }
  return points;
}

}  // namespace

void write_escape_curves(const std::string& path, const std::string& format, const EscapeReport& report) {
  const std::vector<std::string> names = bottleneck_names(report.result());
  std::vector<Zone> zones;
  for (std::size_t k = 0; k < names.size(); ++k) {
    zones.push_back({"orbit " + names[k], orbit_positions(*report.flow, report.result().bottlenecks[k].orbit)});
    add_zones(zones, "entrance " + names[k], "f^", report.result().bottlenecks[k].entry);
    add_zones(zones, "exit " + names[k], "f^-", report.result().bottlenecks[k].exit);
  }
  write_curve_file(path, zones,
                   {.format = format,
                    .notes = notes_of("escape", report.outcome, {}, report.system.name),
                    .zone_lines = ZoneLines::always});
}

}  // namespace lober::cli

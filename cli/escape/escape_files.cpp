// The curves of an escape.

#include "cli/escape/escape_report.hpp"
#include "cli/picture/system_figure.hpp"
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
    const bool closed = curve.image.closed && (curve.complete || curve.cut);
    if (!closed) full += " open";
    zones.push_back({full, {curve.image.points.begin(), curve.image.points.end()}});
    zones.back().closed = closed;
  }
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

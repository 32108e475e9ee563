// The files of lobes, boundary and pips.

#include "cli/report/curve_file.hpp"
#include "cli/report/text.hpp"
#include "cli/tangle/tangle_report.hpp"
#include "engine/base/parallel/parallel.hpp"

namespace lober::cli {
namespace {

CurveFileOptions options_of(const TangleReport& report, const std::string& format, bool closed) {
  const std::string system = report.origin ? system_note(*report.origin->system) : std::string();
  const std::vector<std::string> inputs = report.origin ? std::vector<std::string>{} : notes_on(report.inputs);
  return {.format = format, .closed = closed, .notes = notes_of("tangle", report.outcome, inputs, system)};
}

}  // namespace

void write_tangle_lobes(const std::string& path, const TangleReport& report, const std::string& format) {
  const Tangle& result = report.result();
  std::vector<Zone> zones(result.lobes.size());
  detail::for_each_block(zones.size(), 1, [&](std::size_t k, std::size_t) {
    append_all(zones[k].title, "lobe ", k);
    const std::string label = text(result.images.labels[k]);
    if (!label.empty()) append_all(zones[k].title, " ", label);
    append_all(zones[k].title, " area=", result.lobes[k].area);
    zones[k].points = lobe_outline(result, k);
    zones[k].numbers = {{"lobe", static_cast<double>(k)}, {"area", result.lobes[k].area}};
  });
  write_curve_file(path, zones, options_of(report, format, true));
}

void write_tangle_boundary(const std::string& path, const TangleReport& report, const std::string& format) {
  std::vector<Zone> zones;
  if (report.result().boundary) zones.push_back({"boundary", boundary_outline(report.result())});
  write_curve_file(path, zones, options_of(report, format, true));
}

void write_tangle_pips(const std::string& path, const TangleReport& report, const std::string& format) {
  std::vector<Zone> zones;
  if (!report.result().pips.empty()) zones.push_back({"pips", pips_of(report.result())});
  write_curve_file(path, zones, options_of(report, format, false));
}

}  // namespace lober::cli

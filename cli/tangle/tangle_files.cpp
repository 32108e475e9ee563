// The files of lobes, boundary and pips.

#include "cli/report/text.hpp"
#include "cli/tangle/tangle_report.hpp"
#include "engine/base/parallel/parallel.hpp"

namespace lober::cli {

void write_tangle_lobes(const std::string& path, const TangleReport& report) {
  const Tangle& result = report.result();
  std::vector<Zone> zones(result.lobes.size());
  detail::for_each_block(zones.size(), 1, [&](std::size_t k, std::size_t) {
    append_all(zones[k].title, "lobe ", k);
    const std::string label = text(result.images.labels[k]);
    if (!label.empty()) append_all(zones[k].title, " ", label);
    append_all(zones[k].title, " area=", result.lobes[k].area);
    zones[k].points = lobe_outline(result, k);
  });
  write_tecplot(path, zones);
}

void write_tangle_boundary(const std::string& path, const TangleReport& report) {
  std::vector<Zone> zones;
  if (report.result().boundary) zones.push_back({"boundary", boundary_outline(report.result())});
  write_tecplot(path, zones);
}

void write_tangle_pips(const std::string& path, const TangleReport& report) {
  std::vector<Zone> zones;
  if (!report.result().pips.empty()) zones.push_back({"pips", pips_of(report.result())});
  write_tecplot(path, zones);
}

}  // namespace lober::cli

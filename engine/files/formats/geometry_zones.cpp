#include "engine/files/formats/geometry_zones.hpp"

#include <algorithm>
#include <span>

#include "engine/base/finite.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {

void GeometryZones::name_from(std::size_t first, const std::string& name) {
  if (name.empty()) return;
  in_points_ = false;
  const std::span<Zone> named = std::span(file_.zones).subspan(first);
  const bool several = std::count_if(named.begin(), named.end(), [](const Zone& zone) { return !zone.hole; }) > 1;
  std::size_t curves = 0, holes = 0;
  for (Zone& zone : named) {
    holes = zone.hole ? holes + 1 : 0;
    curves += zone.hole ? 0 : 1;
    if (!zone.title.empty()) continue;
    zone.title = several ? name + " " + std::to_string(curves) : name;
    if (zone.hole) zone.title += ", hole " + std::to_string(holes);
  }
}

void GeometryZones::finish() {
  if (file_.zones.empty()) throw DataError(file_.path + ": no points");
  for (std::size_t k = 0; k < file_.zones.size(); ++k) {
    const std::vector<Point>& points = file_.zones[k].points;
    if (const std::size_t bad = first_not_finite(points); bad != points.size()) {
      throw DataError(file_.path + ": curve " + std::to_string(k) + ": point " + std::to_string(bad) +
                      " is not a finite number");
    }
  }
}

}  // namespace lober::detail

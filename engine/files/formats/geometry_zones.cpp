#include "engine/files/formats/geometry_zones.hpp"

#include "engine/base/finite.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {

void GeometryZones::name_from(std::size_t first, const std::string& name) {
  if (name.empty()) return;
  in_points_ = false;
  const bool several = file_.zones.size() > first + 1;
  for (std::size_t k = first; k < file_.zones.size(); ++k) {
    Zone& zone = file_.zones[k];
    if (zone.title.empty()) zone.title = several ? name + " " + std::to_string(k - first + 1) : name;
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

// The zones of formats that hold points, lines and polygons: GeoJSON, WKT, shapefiles.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "lober/curve/files.hpp"

namespace lober::detail {

/// Adds the lines and rings of geometries to a file, each as a zone. Single points that follow each other are one.
class GeometryZones {
 public:
  explicit GeometryZones(CurveFile& file) : file_(file) {}

  void add_line(std::vector<Point> points, bool hole = false) {
    in_points_ = false;
    if (points.empty()) return;
    file_.zones.push_back({{}, std::move(points)});
    file_.zones.back().hole = hole;
  }
  void add_point(Point point) {
    if (!in_points_) file_.zones.push_back({});
    in_points_ = true;
    file_.zones.back().points.push_back(point);
  }
  [[nodiscard]] std::size_t size() const { return file_.zones.size(); }
  /// Names the zones from `first` on that have no title yet: "NAME", and with several "NAME 1", "NAME 2"; their holes
  /// "NAME, hole 1".
  void name_from(std::size_t first, const std::string& name);

  /// Throws DataError where there are no points, or one is not finite.
  void finish();

 private:
  CurveFile& file_;
  bool in_points_ = false;
};

}  // namespace lober::detail

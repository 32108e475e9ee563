#include "cli/report/point_file.hpp"

#include "cli/program/output_names.hpp"
#include "lober/curve/files.hpp"

namespace lober::cli {

void write_points(const std::string& path, std::span<const Point> points) {
  switch (format_of(path)) {
    case PointFormat::npy:
      return write_npy(path, points);
    case PointFormat::csv:
      return write_text(path, points, ',');
    case PointFormat::text:
      return write_text(path, points);
    case PointFormat::raw:
      return write_raw(path, points);
    case PointFormat::tecplot:
      break;
  }
  const Zone zone{"", {points.begin(), points.end()}, 1};
  write_tecplot(path, {&zone, 1});
}

}  // namespace lober::cli

// The picture of fixed and periodic points: their types, and the directions of the manifolds of saddles.

#include "cli/fixed_points/fixed_points_report.hpp"
#include "cli/picture/fixed_point_layers.hpp"
#include "cli/picture/system_figure.hpp"

namespace lober::cli {

Figure fixed_points_figure(const FixedPointsReport& report, const PictureRequest& how) {
  const operations::SystemFixedPoints& found = report.result();
  Figure figure{.what = "Fixed and periodic points", .title = system_title(report.system.info)};
  name_axes(figure, report.system);
  figure.plane = !report.system.section.has_value();
  figure.guides = false;
  figure.window = with_margin(found.box);
  add_fixed_points(figure, found.points, found.box, how.labels_for(found.points.size()));
  if (found.points.empty()) figure.notes.push_back("no point of period " + std::to_string(found.period) + " was found");
  if (!found.settled) figure.notes.emplace_back("not settled: points may be missing");
  return figure;
}

}  // namespace lober::cli

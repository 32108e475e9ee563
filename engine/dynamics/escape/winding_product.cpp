#include "engine/dynamics/escape/winding_product.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "lober/overlay/regions.hpp"

namespace lober::detail {
namespace {

double product_of_polygons(const ClosedCurve& first, const ClosedCurve& second, std::uint64_t& nodes) {
  double sum = 0;
  const Regions both = regions(first, second);
  nodes += both.counts().nodes;
  for (const WindingArea& entry : both.table()) sum += entry.w1 * entry.w2 * entry.area;
  return std::fabs(sum);
}

ClosedCurve every_nth(const ClosedCurve& curve, std::size_t n, std::size_t first = 0) {
  std::vector<Point> points;
  for (std::size_t k = first; k < curve.size(); k += n) points.push_back(curve.points()[k]);
  return ClosedCurve(std::move(points));
}

// The area of polygons with all vertices, with either half of them and with every fourth: Richardson extrapolation; as
// error the whole difference, because curves that coarse do not quite obey h^2. One difference may be small by chance:
// where windings are missing from all, or where what corners cut off cancels. So that of the other half of the vertices
// counts too, and half of the one before.
CommonWindingArea extrapolated(double fine, double coarse, double other_coarse, double coarser) {
  const double error =
      std::max({std::fabs(fine - coarse), std::fabs(fine - other_coarse), 0.5 * std::fabs(coarse - coarser)});
  return {std::fabs(fine + (fine - coarse) / 3), error, 0};
}

}  // namespace

CommonWindingArea common_area_by_winding(const ClosedCurve& first, const ClosedCurve& second) {
  std::uint64_t nodes = 0;
  const double fine = product_of_polygons(first, second, nodes);
  const double coarse = product_of_polygons(every_nth(first, 2), every_nth(second, 2), nodes);
  const double other_coarse = product_of_polygons(every_nth(first, 2, 1), every_nth(second, 2, 1), nodes);
  const double coarser = product_of_polygons(every_nth(first, 4), every_nth(second, 4), nodes);
  CommonWindingArea common = extrapolated(fine, coarse, other_coarse, coarser);
  common.nodes = nodes;
  return common;
}

CommonWindingArea area_by_winding(const ClosedCurve& curve) {
  const auto area_of = [](const ClosedCurve& polygon) { return std::fabs(signed_area(polygon)); };
  return extrapolated(area_of(curve), area_of(every_nth(curve, 2)), area_of(every_nth(curve, 2, 1)),
                      area_of(every_nth(curve, 4)));
}

}  // namespace lober::detail

#include "engine/dynamics/escape/winding_product.hpp"

#include <cmath>

#include "lober/regions.hpp"

namespace lober::detail {
namespace {

double winding_product(const ClosedCurve& first, const ClosedCurve& second) {
  double sum = 0;
  const Regions both = regions(first, second);
  for (const WindingArea& entry : both.table()) sum += entry.w1 * entry.w2 * entry.area;
  return std::fabs(sum);
}

std::vector<Point> every_second(const ClosedCurve& curve) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < curve.size(); k += 2) points.push_back(curve.points()[k]);
  return points;
}

}  // namespace

CommonArea common_area_by_winding(const ClosedCurve& first, const ClosedCurve& second) {
  const double fine = winding_product(first, second);
  const double coarse = winding_product(ClosedCurve(every_second(first)), ClosedCurve(every_second(second)));
  // Richardson extrapolation; as error the whole difference, because curves that coarse do not quite obey h^2.
  return {std::fabs(fine + (fine - coarse) / 3), std::fabs(fine - coarse)};
}

}  // namespace lober::detail

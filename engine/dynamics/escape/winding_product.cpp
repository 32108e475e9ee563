#include "engine/dynamics/escape/winding_product.hpp"

#include <cmath>

#include "engine/geometry/regions/regions.hpp"

namespace lober {
namespace {

double winding_product(CurveView first, CurveView second) {
  double sum = 0;
  const Regions both = regions(first, second);
  for (const WindingArea& entry : both.table()) sum += entry.w1 * entry.w2 * entry.area;
  return std::fabs(sum);
}

std::vector<Point> every_second(CurveView curve) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < curve.points.size(); k += 2) points.push_back(curve.points[k]);
  return points;
}

}  // namespace

CommonArea common_area_by_winding(CurveView first, CurveView second) {
  const double fine = winding_product(first, second);
  const std::vector<Point> coarse1 = every_second(first), coarse2 = every_second(second);
  const double coarse = winding_product(CurveView{coarse1, true}, CurveView{coarse2, true});
  // Richardson extrapolation; as error the whole difference, because curves that coarse do not quite obey h^2.
  return {std::fabs(fine + (fine - coarse) / 3), std::fabs(fine - coarse)};
}

}  // namespace lober

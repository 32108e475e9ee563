#include "engine/escape/common_area.hpp"

#include <cmath>

#include "engine/error.hpp"
#include "engine/overlay/overlay.hpp"
#include "engine/regions/regions.hpp"
#include "engine/smooth/smooth.hpp"

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

CommonArea common_area(CurveView first, CurveView second) {
  try {
    OverlayOptions options;
    options.pieces = false;
    const SmoothAreas smooth = smooth_areas(overlay(first, second, options));
    return {smooth.areas.intersection, smooth.error.intersection};
  } catch (const NotSimpleError&) {
    const Areas areas = regions(first, second).areas(WindingRule::nonzero);
    const double doubt = std::fabs(areas.c1 - std::fabs(smooth_area(first).area)) +
                         std::fabs(areas.c2 - std::fabs(smooth_area(second).area));
    return {areas.intersection, doubt};
  }
}

}  // namespace lober

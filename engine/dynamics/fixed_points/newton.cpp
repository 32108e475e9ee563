#include "engine/dynamics/fixed_points/newton.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lober {

namespace {

/// Solves (D - 1) s = -gap.
Point newton_step(const Displacement& here) {
  const Matrix2 a{here.derivative.xx - 1, here.derivative.xy, here.derivative.yx, here.derivative.yy - 1};
  const double d = determinant(a);
  return {(a.xy * here.gap.y - a.yy * here.gap.x) / d, (a.yx * here.gap.x - a.xx * here.gap.y) / d};
}

/// Whether the map is defined all round z. At the edge of the chart of a section it has limits that look like fixed
/// points.
bool is_inside(const PlanarMap& map, Point z, int period) {
  const double h = 1e-6 * size_at(z);
  std::array<Point, 4> around{{{z.x + h, z.y}, {z.x - h, z.y}, {z.x, z.y + h}, {z.x, z.y - h}}};
  map.iterate(around, period);
  return std::all_of(around.begin(), around.end(), is_finite);
}

}  // namespace

Displacement displacement(const PlanarMap& map, Point z, int period, Point shift) {
  Displacement result;
  const Point image = map.iterate_with_derivative(z, period, result.derivative);
  result.gap = {image.x - z.x - shift.x, image.y - z.y - shift.y};
  return result;
}

NewtonEnd newton(const PlanarMap& map, Point z, const FixedPointOptions& options, double reach) {
  Displacement here = displacement(map, z, options.period, options.shift);
  double residual = length(here.gap);
  if (!is_finite(here.gap)) return {z, residual, false};
  for (int k = 0; k < 60; ++k) {
    Point step = newton_step(here);
    double longest = length(step);
    if (residual == 0) return {z, residual, is_inside(map, z, options.period)};
    if (!std::isfinite(longest)) return {z, residual, false};
    const bool close = longest <= 1e-8 * size_at(z);
    if (longest > reach) {
      step = {step.x * reach / longest, step.y * reach / longest};
      longest = reach;
    }
    bool better = false;
    for (int halvings = 0; halvings < 12 && !better; ++halvings) {
      const Point next{z.x + step.x, z.y + step.y};
      const Displacement there = displacement(map, next, options.period, options.shift);
      const double next_residual = length(there.gap);
      if (next_residual < residual) {
        z = next;
        here = there;
        residual = next_residual;
        better = true;
      } else if (close && std::isfinite(next_residual)) {
        // As near as rounding allows.
        return {z, residual, residual <= 1e-7 * size_at(z) && is_inside(map, z, options.period)};
      }
      step = {0.5 * step.x, 0.5 * step.y};
    }
    if (!better) return {z, residual, false};
  }
  return {z, residual, false};
}

}  // namespace lober

#include "engine/dynamics/fixed_points/newton.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lober::detail {

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

NewtonEnd newton(const PlanarMap& map, Point guess, const FixedPointOptions& options, double reach) {
  constexpr int max_rounds = 60, min_rounds = 8, max_halvings = 12;
  Displacement here = displacement(map, guess, options.period, options.shift);
  Point z = guess;
  NewtonEnd best{z, length(here.gap), false};
  for (int round = 1; round < max_rounds && best.residual > 0; ++round) {
    Point step = newton_step(here);
    const double size = length(step);
    if (!std::isfinite(size)) break;
    const bool close = size <= 1e-8 * size_at(z);
    if (size > reach) step = {step.x * reach / size, step.y * reach / size};
    // Far from the point each step has to bring it nearer. Close to it rounding decides, and the best of some is taken.
    for (int halvings = 0;; ++halvings) {
      const Point next{z.x + step.x, z.y + step.y};
      here = displacement(map, next, options.period, options.shift);
      if (close || length(here.gap) < best.residual) {
        z = next;
        break;
      }
      if (halvings == max_halvings) return best;
      step = {0.5 * step.x, 0.5 * step.y};
    }
    const double residual = length(here.gap);
    if (residual < best.residual) {
      best = {z, residual, false};
    } else if (!std::isfinite(residual) || round > min_rounds) {
      break;
    }
  }
  best.converged = best.residual <= 1e-7 * size_at(best.at) && is_inside(map, best.at, options.period);
  return best;
}

}  // namespace lober::detail

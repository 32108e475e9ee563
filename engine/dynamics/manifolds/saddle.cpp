#include "engine/dynamics/manifolds/saddle.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <string>

#include "engine/base/quantities.hpp"
#include "engine/base/text.hpp"
#include "engine/dynamics/fixed_points/classify.hpp"
#include "engine/dynamics/fixed_points/newton.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

// A point farther than this from a guess, in units of its size, is not the one that was meant.
constexpr double nearby = 0.5, everywhere = std::numeric_limits<double>::infinity();

std::optional<Point> refined_fixed_point(const PlanarMap& map, int steps, Point guess) {
  // Maps of small coordinates live in a few of their units.
  const double extent = map.unit() < 1 ? 10 * map.unit() : everywhere, reach = nearby * size_at(guess, extent);
  const NewtonEnd end = newton(map, guess, {.period = steps, .extent = extent}, reach);
  return end.converged && distance(end.at, guess) <= reach ? std::optional(end.at) : std::nullopt;
}

// The way on.
std::string others_by_search() {
  return std::string(quantity::search) + " lists the existing ones";
}

// The factor by which one iterate stretches at most.
double stretching_at(const PlanarMap& map, int steps, Point at) {
  Matrix2 a;
  if (!is_finite(map.iterate_with_derivative(at, steps, a))) return 0;
  return std::max({std::fabs(a.xx), std::fabs(a.xy), std::fabs(a.yx), std::fabs(a.yy)});
}

// The manifolds of one saddle have to agree to the bit on where it is, so the stable side asks the map itself too. Of
// the map and its inverse one may see it from where the other does not.
Point refined_saddle(const PlanarMap& map, int steps, Point guess) {
  const std::optional<Point> own = refined_fixed_point(map, steps, guess);
  const std::optional<Point> forward = steps > 0 ? own : refined_fixed_point(map, -steps, guess);
  if (!own && !forward) {
    throw DataError("no fixed point of the map was found near " + format_point(guess) +
                    unresolved(stretching_at(map, steps, guess)) + "; " + others_by_search());
  }
  if (!own) return *forward;
  const bool same = forward && distance(*forward, *own) <= 1e-8 * (map.unit() + length(*own));
  return same ? *forward : *own;
}

std::string kind_text(const FixedPoint& point) {
  const auto text = [](std::complex<double> value) {
    if (value.imag() == 0) return format_number(value.real());
    return format_number(value.real()) + (value.imag() < 0 ? " - " : " + ") + format_number(std::fabs(value.imag())) +
           " i";
  };
  return std::string(name(point.kind)) + " (multipliers " + text(point.multipliers[0]) + " and " +
         text(point.multipliers[1]) + ")";
}

}  // namespace

std::string unresolved(double factor) {
  constexpr double far = 1e8;
  if (!(factor > far)) return "";
  return "; one iterate stretches by " + format_rounded(factor) +
         " there, which is not resolved in double precision: try other parameters";
}

Saddle saddle_near(const PlanarMap& map, int steps, Point guess) {
  FixedPoint saddle;
  saddle.at = refined_saddle(map, steps, guess);
  if (!is_finite(map.iterate_with_derivative(saddle.at, steps, saddle.derivative))) {
    throw DataError("the map cannot be evaluated at its fixed point " + format_point(saddle.at) + "; " +
                    others_by_search());
  }
  classify(saddle);
  if (saddle.kind != FixedPointKind::saddle && saddle.kind != FixedPointKind::inverse_saddle &&
      saddle.kind != FixedPointKind::reversing_saddle) {
    throw DataError("the fixed point " + format_point(saddle.at) + ", found near " + format_point(guess) +
                    ", is not a saddle, but of the kind " + kind_text(saddle) +
                    "; only saddles have the manifolds that are wanted here, and " + others_by_search());
  }
  return {saddle.at, saddle.multipliers[0].real(), saddle.directions[0]};
}

void require_derivative_fits(const PlanarMap& map, int steps, Point at) {
  Matrix2 a;
  if (!is_finite(map.iterate_with_derivative(at, steps, a))) return;
  const double size = std::max({1.0, std::fabs(a.xx), std::fabs(a.xy), std::fabs(a.yx), std::fabs(a.yy)});
  if (size > 1e8) return;        // points so near to each other that their images are too are one point in doubles
  constexpr double fits = 1e-2;  // curvature and the error of integration are far below
  for (const bool along_x : {true, false}) {
    const Point given = along_x ? Point{a.xx, a.yx} : Point{a.xy, a.yy};
    Point difference;
    // Where the system is far smaller than 1, the first steps are too long for it.
    for (const double length : {1e-5, 1e-8, 1e-11}) {
      const double h = length * (map.unit() + std::hypot(at.x, at.y)) / size;
      const double dx = along_x ? h : 0, dy = along_x ? 0 : h;
      Point ends[2] = {{at.x + dx, at.y + dy}, {at.x - dx, at.y - dy}};
      map.iterate(ends, steps);
      const Point found{(ends[0].x - ends[1].x) / (2 * h), (ends[0].y - ends[1].y) / (2 * h)};
      if (!is_finite(found)) return;
      if (length == 1e-5 || distance(found, given) <= fits * size) difference = found;
    }
    if (distance(difference, given) <= fits * size) continue;
    throw DataError("the derivative that the system gives at " + format_point(at) + " does not fit its map: along " +
                    (along_x ? "x" : "y") + " it is " + format_point(given) + ", differences of the map say " +
                    format_point(difference));
  }
}

}  // namespace lober::detail

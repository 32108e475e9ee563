#include "engine/dynamics/fixed_points/degenerate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/dynamics/fixed_points/newton.hpp"
#include "engine/dynamics/fixed_points/uncertainty.hpp"
#include "engine/dynamics/maps/plane.hpp"

namespace lober::detail {
namespace {

struct Here {
  Point gap;
  Matrix2 a;  // D - 1
};

Here here_at(const PlanarMap& map, Point z, const FixedPointOptions& options) {
  Matrix2 derivative;
  const Point image = map.iterate_with_derivative(z, options.period, derivative);
  return {gap_between(z, image, options), less_1(derivative)};
}

// The step across the direction in which D - 1 vanishes that comes nearest to a zero.
Point across(const Here& here) {
  const double squares = norm_of(here.a) * norm_of(here.a);
  return {-(here.a.xx * here.gap.x + here.a.yx * here.gap.y) / squares,
          -(here.a.xy * here.gap.x + here.a.yy * here.gap.y) / squares};
}

// How far on along that direction the determinant is zero or least, by its values within `reach`.
std::optional<double> way_to_degeneracy(double before, double here, double after, double reach, double noise) {
  constexpr double clear = 10, above = 100;
  const double slope = 0.5 * (after - before), bend = 0.5 * (after + before) - here;
  if (std::abs(slope) > std::max(above * noise, clear * std::abs(bend))) return -here / slope * reach;
  if (std::abs(bend) > std::max(above * noise, clear * std::abs(slope))) return -0.5 * slope / bend * reach;
  return std::nullopt;
}

// That far on from z along a direction, on the floor of the valley of the displacement, which bends.
Point on_floor(const PlanarMap& map, Point z, double way, Point along, const FixedPointOptions& options) {
  constexpr int rounds = 2;
  Point place{z.x + way * along.x, z.y + way * along.y};
  for (int round = 0; round < rounds; ++round) place = place + across(here_at(map, place, options));
  return place;
}

std::optional<Point> sharper(const PlanarMap& map, Point z, double reach, const FixedPointOptions& options) {
  constexpr double rounding = 1e-15;
  const Here here = here_at(map, z, options);
  const Point along = null_direction(here.a);
  const auto determinant_at = [&](double way) {
    return determinant(here_at(map, on_floor(map, z, way, along, options), options).a);
  };
  const double norm = 1 + norm_of(here.a);
  const std::optional<double> way = way_to_degeneracy(determinant_at(-reach), determinant(here.a),
                                                      determinant_at(reach), reach, rounding * norm * norm);
  if (!way || !(std::abs(*way) < reach)) return std::nullopt;
  const Point there = on_floor(map, z, *way, along, options);
  const double most = noise_of(map) * size_at(z, options.extent) * norm;
  const double residual = length(here_at(map, there, options).gap);
  return residual <= std::max(length(here.gap), most) ? std::optional(there) : std::nullopt;
}

}  // namespace

void sharpen_degenerate(const PlanarMap& map, std::span<Point> at, const FixedPointOptions& options) {
  if (!by_formula(map)) return;  // derivatives of integrations are not known that well
  for (Point& z : at) {
    for (const double part : {1e-4, 1e-5, 1e-5}) {
      const std::optional<Point> better = sharper(map, z, part * size_at(z, options.extent), options);
      if (better) z = *better;
    }
  }
}

}  // namespace lober::detail

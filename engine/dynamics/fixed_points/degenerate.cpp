#include "engine/dynamics/fixed_points/degenerate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/dynamics/fixed_points/newton.hpp"
#include "engine/dynamics/fixed_points/uncertainty.hpp"
#include "engine/dynamics/maps/plane.hpp"

namespace lober::detail {
namespace {

// How far on along the direction in which D - 1 vanishes the determinant is zero or least, by its values within
// `reach`.
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
  for (int round = 0; round < rounds; ++round) {
    const Displacement here = displacement_at(map, place, options);
    place = place + shortest_step(less_1(here.derivative), here.gap);
  }
  return place;
}

std::optional<Point> sharper(const PlanarMap& map, Point z, double reach, const FixedPointOptions& options) {
  constexpr double rounding = 1e-15;
  const Displacement here = displacement_at(map, z, options);
  const Matrix2 a = less_1(here.derivative);
  const Point along = null_direction(a);
  const auto determinant_at = [&](double way) {
    return determinant(less_1(displacement_at(map, on_floor(map, z, way, along, options), options).derivative));
  };
  const double norm = 1 + norm_of(a);
  const std::optional<double> way =
      way_to_degeneracy(determinant_at(-reach), determinant(a), determinant_at(reach), reach, rounding * norm * norm);
  if (!way || !(std::abs(*way) < reach)) return std::nullopt;
  const Point there = on_floor(map, z, *way, along, options);
  const double most = noise_of(map) * size_at(z, options.extent) * norm;
  const double residual = length(displacement_at(map, there, options).gap);
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

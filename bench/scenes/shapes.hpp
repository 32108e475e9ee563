// Building blocks of the scenes.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "bench/scenes/scenes.hpp"

namespace lober::bench {

inline constexpr double full_turn = 2 * std::numbers::pi;

/// Points centre + radius(theta) (cos theta, sin theta) at theta = full_turn (k + phase) / points.
template <typename Radius>
Polygon radial_curve(std::size_t points, double phase, const Radius& radius, Point centre = {}) {
  Polygon polygon(points);
  for (std::size_t k = 0; k < points; ++k) {
    const double angle = full_turn * ((static_cast<double>(k) + phase) / static_cast<double>(points));
    const double r = radius(angle);
    polygon[k] = {centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)};
  }
  return polygon;
}

inline Polygon circle(std::size_t points, double phase, double radius, Point centre) {
  return radial_curve(
      points, phase, [radius](double) { return radius; }, centre);
}

/// Moves the first `shift` vertices to the end: the same closed curve, started elsewhere.
[[nodiscard]] Polygon started_at(const Polygon& polygon, std::size_t shift);

/// Appends `count` points of the segment from -> to: `from` and what follows at equal distances, without
/// `to`.
void append_line(Polygon& polygon, Point from, Point to, std::size_t count);

/// The areas of all four pairings from two areas and their overlap.
[[nodiscard]] std::array<double, 4> areas_from_overlap(double area1, double area2, double overlap);

/// Areas of two unit discs whose centres are `distance` < 2 apart.
[[nodiscard]] std::array<double, 4> areas_of_unit_discs(double distance);

/// Areas between two curves r1(theta) and r2(theta) around the origin whose order changes only at `cuts`
/// (ascending, last one full_turn after the first): Gauss-Legendre quadrature of (r1^2 - r2^2) / 2 between
/// the cuts.
using RadiusFunction = double (*)(double angle);
[[nodiscard]] std::array<double, 4> areas_between(RadiusFunction r1, RadiusFunction r2, std::span<const double> cuts);

}  // namespace lober::bench

// The Chirikov standard map, lifted, in radians.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/dynamics/maps/formula_map.hpp"
#include "engine/dynamics/systems/entries.hpp"
#include "kernels/elementary.hpp"
#include "kernels/sine.hpp"

namespace lober::detail {

namespace {

/// p' = p + K sin x, x' = x + p', in the plane (x, p).
struct StandardMap {
  double k;

  Point forward(Point z) const {
    add_sines(&z.y, &z.x, k, 1);
    return {z.x + z.y, z.y};
  }
  Point backward(Point z) const {
    z.x -= z.y;
    add_sines(&z.y, &z.x, -k, 1);
    return z;
  }
  void iterate(std::span<Point> points, int iterates) const {
    constexpr std::size_t most = 256;
    std::array<double, most> x, y;
    for (std::size_t first = 0; first < points.size(); first += most) {
      const std::span<Point> some = points.subspan(first, std::min(most, points.size() - first));
      const std::size_t count = some.size();
      for (std::size_t j = 0; j < count; ++j) {
        x[j] = some[j].x;
        y[j] = some[j].y;
      }
      for (int step = 0; step < iterates; ++step) {
        add_sines(y.data(), x.data(), k, count);
        for (std::size_t j = 0; j < count; ++j) x[j] += y[j];
      }
      for (int step = 0; step > iterates; --step) {
        for (std::size_t j = 0; j < count; ++j) x[j] -= y[j];
        add_sines(y.data(), x.data(), -k, count);
      }
      for (std::size_t j = 0; j < count; ++j) some[j] = {x[j], y[j]};
    }
  }
  Matrix2 derivative(Point z) const {
    const double c = k * elementary::cos(z.x);
    return {1 + c, 1, c, 1};
  }
  /// L(x, x') = (x' - x)^2 / 2 + |K| - K cos x, 0 at the saddle. The part of the potential is written as a square,
  /// which keeps its digits near the saddle.
  long double action(Point from, Point to) const {
    const long double step = static_cast<long double>(to.x) - static_cast<long double>(from.x);
    const long double half = 0.5L * static_cast<long double>(from.x);
    const long double root = k < 0 ? std::cos(half) : std::sin(half);
    return 0.5L * step * step + 2 * std::fabs(static_cast<long double>(k)) * root * root;
  }
};

}  // namespace

SystemEntry standard_map_entry() {
  return {{"standard",
           "Chirikov standard map p' = p + K sin x, x' = x + p', lifted, radians; plane (x, p)",
           {{"K", 1.2, "strength of the kicks"}}},
          [](std::span<const double> values, const IntegrationOptions&) {
            System system;
            system.window = window(-1, -3.2, 5.5, 3.2);
            system.lattice = {2 * std::numbers::pi, 0};
            // The upper separatrix, its pip on the axis x = pi, at about 2 sqrt(K) for small K and below pi for large
            // ones (the formula is off by less than 0.15 for all K); and the lower one, from right to left. The region
            // is the strip of the cylinder between both.
            const double k = std::abs(values[0]), pi = std::numbers::pi, width = 2 * pi;
            const double height = 2 * std::sqrt(k / (1 + 4 * k / (pi * pi)));
            // For K < 0 the map is that for -K, shifted by half a period.
            const double left = values[0] < 0 ? -pi : 0, right = left + width, middle = left + pi;
            if (values[0] != 0) {
              system.connection = Connection{{left, 0}, {1, 1}, {right, 0}, {-1, 1}, Point{middle, height}};
              system.further = {Connection{{right, 0}, {-1, -1}, {left, 0}, {1, -1}, Point{middle, -height}}};
              system.further_needed = true;
            } else {
              system.no_connection = "for K = 0 every circle p = const is invariant, and no fixed point is a saddle";
            }
            system.symmetries = {{{-1, 0, 0, -1}}, reversor({-1, 1, 0, 1})};
            system.map = std::make_shared<FormulaMap<StandardMap>>(StandardMap{values[0]});
            return system;
          }};
}

}  // namespace lober::detail

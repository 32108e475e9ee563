// The Chirikov standard map, lifted, in radians.
#include <cmath>
#include <numbers>

#include "engine/dynamics/formula_map.hpp"
#include "engine/dynamics/systems/entries.hpp"

namespace lober {

namespace {

/// p' = p + K sin x, x' = x + p', in the plane (x, p).
struct StandardMap {
  double k;

  Point forward(Point z) const {
    const double p = z.y + k * std::sin(z.x);
    return {z.x + p, p};
  }
  Point backward(Point z) const {
    const double x = z.x - z.y;
    return {x, z.y - k * std::sin(x)};
  }
  Matrix2 derivative(Point z) const {
    const double c = k * std::cos(z.x);
    return {1 + c, 1, c, 1};
  }
  /// L(x, x') = (x' - x)^2 / 2 + K (1 - cos x), 0 at the saddle. The part of the potential is written as a square,
  /// which keeps its digits near the saddle.
  long double action(Point from, Point to) const {
    const long double step = static_cast<long double>(to.x) - static_cast<long double>(from.x);
    const long double sine = std::sin(0.5L * static_cast<long double>(from.x));
    return 0.5L * step * step + 2 * static_cast<long double>(k) * sine * sine;
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
            // The upper separatrix; its pip on the axis x = pi.
            system.connection = Connection{{0, 0},
                                           {1, 1},
                                           {2 * std::numbers::pi, 0},
                                           {-1, 1},
                                           Point{std::numbers::pi, 1.7 * std::sqrt(std::abs(values[0]))}};
            system.map = std::make_shared<FormulaMap<StandardMap>>(StandardMap{values[0]});
            return system;
          }};
}

}  // namespace lober

// The area-preserving Henon map.
#include <cmath>

#include "engine/dynamics/maps/formula_map.hpp"
#include "engine/dynamics/systems/entries.hpp"

namespace lober::detail {

namespace {

/// (x, y) -> (x^2 - k - y, x).
struct HenonMap {
  double k;

  Point forward(Point z) const { return {z.x * z.x - k - z.y, z.x}; }
  Point backward(Point z) const { return {z.y, z.y * z.y - k - z.x}; }
  Matrix2 derivative(Point z) const { return {2 * z.x, -1, 1, 0}; }
  /// L(x, x') = x x' - x^3 / 3 + k x: dL/dx' = x = y', -dL/dx = x^2 - k - x' = y.
  long double action(Point from, Point to) const {
    const long double x = from.x;
    return x * static_cast<long double>(to.x) - x * x * x / 3 + static_cast<long double>(k) * x;
  }
};

}  // namespace

SystemEntry henon_map_entry() {
  return {{"henon",
           "Area-preserving Henon map (x, y) -> (x^2 - k - y, x)",
           {{"k", 0.5, "saddle at x = y = 1 + sqrt(1 + k)"}}},
          [](std::span<const double> values, const IntegrationOptions&) {
            System system;
            const double reach = 2 + std::sqrt(std::abs(1 + values[0]));
            system.window = window(-reach, -reach, reach, reach);
            // The pip on the axis of the reversor that follows from x_1 = x_-1, by interpolation in k.
            if (values[0] > -1) {
              const double saddle = 1 + std::sqrt(1 + values[0]);
              system.connection = Connection{{saddle, saddle},
                                             {-1, -1},
                                             {saddle, saddle},
                                             {-1, -1},
                                             Point{-1.154 - 0.757 * values[0], 0.666 + 0.518 * values[0]}};
            } else {
              system.no_connection = values[0] == -1
                                         ? "the saddle and the centre are one fixed point, (1, 1), for k = -1"
                                         : "the map has no fixed points for k < -1";
            }
            system.symmetries = {reversor({0, 1, 1, 0})};
            system.map = std::make_shared<FormulaMap<HenonMap>>(HenonMap{values[0]});
            return system;
          }};
}

}  // namespace lober::detail

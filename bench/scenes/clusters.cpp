// Points in clusters: what tracers that are dropped in bunches, or a solver with small steps, leave behind.
#include <cstddef>

#include "bench/scenes/shapes.hpp"

namespace lober::bench {
namespace {

// A wavy circle whose points crowd about `clusters` directions, where they are 1e6 times closer than between.
Polygon clustered(std::size_t points, std::size_t clusters, double phase, double waves) {
  Polygon polygon(points);
  for (std::size_t k = 0; k < points; ++k) {
    const double turn = static_cast<double>(k) / static_cast<double>(points) * static_cast<double>(clusters);
    const double whole = std::floor(turn), u = 2 * (turn - whole) - 1;
    const double crowded =
        u * (1e-6 + (1 - 1e-6) * std::pow(u * u, 3));  // rises by 1e-6 in the middle, by 7 at the ends
    const double angle = full_turn * ((whole + 0.5 + 0.5 * crowded) / static_cast<double>(clusters)) + phase;
    const double r = 1 + 0.02 * std::sin(waves * angle);
    polygon[k] = {r * std::cos(angle), r * std::sin(angle)};
  }
  return polygon;
}

}  // namespace

Scene make_clusters(std::size_t points) {
  const std::size_t clusters = points / 1000 + 5;
  return {clustered(points, clusters, 0, 40), clustered(points, clusters + 3, 0.2, 37), std::nullopt, std::nullopt};
}

}  // namespace lober::bench

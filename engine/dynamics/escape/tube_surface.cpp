#include "lober/dynamics/tube_surface.hpp"

#include <algorithm>
#include <cmath>

#include "lober/base/error.hpp"

namespace lober {
namespace {

// Points of a closed polygon at equal distances along it.
std::vector<Point> spread_along(std::span<const Point> polygon, std::size_t number) {
  std::vector<double> length{0};
  const auto vertex = [&](std::size_t k) { return polygon[k % polygon.size()]; };
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    length.push_back(length.back() + std::hypot(vertex(k + 1).x - vertex(k).x, vertex(k + 1).y - vertex(k).y));
  }
  std::vector<Point> points;
  std::size_t side = 0;
  for (std::size_t k = 0; k < number; ++k) {
    const double wanted = length.back() * static_cast<double>(k) / static_cast<double>(number);
    while (side + 1 < polygon.size() && length[side + 1] <= wanted) ++side;
    const double whole = length[side + 1] - length[side], t = whole > 0 ? (wanted - length[side]) / whole : 0;
    const Point a = vertex(side), b = vertex(side + 1);
    points.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
  }
  return points;
}

}  // namespace

TubeSurface tube_surface(const Flow& flow, const Section& section, double energy, std::span<const Point> curve,
                         const PeriodicOrbit& orbit, bool backward, const TubeSurfaceOptions& options) {
  if (curve.size() < 3 || options.around < 3) throw UsageError("the surface of a tube needs a curve of three points");
  TubeSurface surface;
  surface.around = options.around;
  std::vector<FlowState> ring;
  for (const Point& point : spread_along(curve, options.around)) {
    ring.push_back(flow.on_section(section, energy, point));
  }
  const auto across = static_cast<std::size_t>(section.coordinate);
  // The turning point of the orbit that the tube comes to first, and when it has closed in on it.
  const double first = std::fabs(orbit.turning[0][across] - section.value),
               second = std::fabs(orbit.turning[1][across] - section.value);
  const double near = std::min(first, second), close = near - 0.02 * near;
  const double step = (backward ? -1 : 1) * orbit.period / static_cast<double>(options.rings_a_period);
  const auto lost = [&](const FlowState& state) { return !std::isfinite(state[across]); };
  const auto there = [&](const FlowState& state) { return std::fabs(state[across] - section.value) >= close; };
  while (surface.rings() < options.max_rings) {
    if (std::any_of(ring.begin(), ring.end(), lost)) break;
    surface.states.insert(surface.states.end(), ring.begin(), ring.end());
    if (surface.rings() > 1 && std::all_of(ring.begin(), ring.end(), there)) break;
    flow.integrate(ring, 0, step, options.integration);
  }
  return surface;
}

}  // namespace lober

// Scenes whose curves share half of their boundary, exactly or to the last bit: the ordinary case for a
// boundary and its iterates.
#include <cstdint>
#include <limits>
#include <random>

#include "bench/scenes/shapes.hpp"

namespace lober::bench {
namespace {

constexpr double half_turn = std::numbers::pi;

double common_radius(double angle) {
  return 1 + 0.2 * std::sin(3 * angle) + 0.05 * std::cos(11 * angle);
}

// On the second half of the turn six half-waves about the common curve, hence five crossings beside the
// shared arc.
double other_radius(double angle) {
  const double wave = angle > half_turn ? 0.08 * std::sin(6 * (angle - half_turn)) : 0;
  return common_radius(angle) + wave;
}

Scene shared_half(std::size_t points) {
  std::array<double, 8> cuts{0};
  for (std::size_t k = 0; k < 7; ++k) cuts[k + 1] = half_turn * (1 + static_cast<double>(k) / 6);
  return {radial_curve(points, 0.25, common_radius), radial_curve(points, 0.25, other_radius),
          areas_between(common_radius, other_radius, cuts), std::nullopt};
}

}  // namespace

Scene make_shared_exact(std::size_t points) {
  Scene scene = shared_half(points);
  scene.second = started_at(scene.second, points / 5);
  return scene;
}

Scene make_shared_ulp(std::size_t points) {
  Scene scene = shared_half(points);
  // Each coordinate of the shared half keeps its value or moves by one ulp either way. Vertices are 10^8 ulps
  // apart even at 10^7 points, so the curve stays simple.
  std::mt19937_64 random(1);
  const auto nudged = [&](double value) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::uint64_t choice = random() % 3;
    return choice == 0 ? value : std::nextafter(value, choice == 1 ? infinity : -infinity);
  };
  for (std::size_t k = 0; k < points / 2; ++k) {
    Point& vertex = scene.second[k];
    vertex.x = nudged(vertex.x);
    vertex.y = nudged(vertex.y);
  }
  scene.second = started_at(scene.second, points / 5);
  return scene;
}

}  // namespace lober::bench

// Scenes in which one curve waves about the other.
#include <algorithm>

#include "bench/scenes/shapes.hpp"

namespace lober::bench {
namespace {

// Circle of radius 1 against r = 1 + a sin(k theta). With s = sin(k theta), half a turn in total has s > 0
// and the integral of s over it is 2, of s^2 pi / 2; the area between is 1/2 of the integral of 2 a s + a^2
// s^2.
Scene circle_and_wave(std::size_t points, double amplitude, std::size_t waves) {
  const double frequency = static_cast<double>(waves);
  const double wave_outside = 2 * amplitude + std::numbers::pi / 4 * amplitude * amplitude;
  const double wave_inside = 2 * amplitude - std::numbers::pi / 4 * amplitude * amplitude;
  const double area = std::numbers::pi;
  return {circle(points, 0.3, 1, {}),
          radial_curve(points, 0.6, [=](double angle) { return 1 + amplitude * std::sin(frequency * angle); }),
          std::array{wave_inside, wave_outside, area - wave_inside, area + wave_outside}, 2 * waves};
}

}  // namespace

Scene make_wavy16(std::size_t points) {
  return circle_and_wave(points, 0.1, 8);
}

Scene make_wavy_many(std::size_t points) {
  // Twenty points a wave, with a slope of 45 degrees where it crosses the circle.
  const std::size_t waves = points / 20;
  Scene scene = circle_and_wave(points, 1 / static_cast<double>(waves), waves);
  scene.smooth_areas.reset();  // a wave of twenty points is not smooth
  return scene;
}

Scene make_near_tangent(std::size_t points) {
  // Two polygons inscribed in one smooth curve, the vertices of one half-way between those of the other:
  // wherever the curve bends, each segment sticks out on both sides of a vertex of the other, which makes two
  // crossings a segment. The gap is curvature * spacing^2 / 8: a curvature of 200 gives 1e-9 at 10^6 points.
  const double frequency = std::min(200.0, static_cast<double>(points) / 50);
  const double amplitude = std::min(200 / (frequency * frequency), 0.3);
  const auto radius = [=](double angle) { return 1 + amplitude * std::sin(frequency * angle); };
  return {radial_curve(points, 0, radius), radial_curve(points, 0.5, radius), std::nullopt, std::nullopt};
}

Scene make_graze(std::size_t points) {
  // 1000 crossings at 10^6 points are as flat as 1e-6: slopes of 5e-7 against segments of 6e-6.
  const std::size_t waves = std::min<std::size_t>(500, points / 50);
  const double frequency = static_cast<double>(waves);
  return {circle(points, 0.3, 1, {}),
          radial_curve(points, 0.3, [=](double angle) { return 1 + 1e-9 * std::sin(frequency * angle); }), std::nullopt,
          std::nullopt};
}

}  // namespace lober::bench

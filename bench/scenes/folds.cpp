// Scenes of many thin fingers.
#include <utility>

#include "bench/scenes/shapes.hpp"

namespace lober::bench {
namespace {

// `parts` numbers as equal as can be with the sum `total`; this is the k-th of them.
std::size_t share(std::size_t total, std::size_t parts, std::size_t k) {
  return total * (k + 1) / parts - total * k / parts;
}

// A comb with its spine along [0, 1] x [-0.2, 0] and `teeth` teeth, as wide as the gaps between them, up to y
// = 1.
Polygon upright_comb(std::size_t points, std::size_t teeth) {
  const double width = 1 / static_cast<double>(2 * teeth - 1);
  const std::size_t on_spine = 2 + teeth;  // three corners, and the left foot of all teeth but the last
  const std::size_t on_teeth = points - on_spine;
  Polygon polygon;
  polygon.reserve(points);
  polygon.push_back({0, 0});
  polygon.push_back({0, -0.2});
  polygon.push_back({1, -0.2});
  for (std::size_t k = 0; k < teeth; ++k) {
    const double right = 1 - width * static_cast<double>(2 * k);
    const double left = k + 1 == teeth ? 0 : right - width;
    const std::size_t count = share(on_teeth, teeth, k);
    append_line(polygon, {right, 0}, {right, 1}, count / 2);
    append_line(polygon, {right, 1}, {left, 1}, 2);
    append_line(polygon, {left, 1}, {left, 0}, count - count / 2 - 2);
    if (k + 1 != teeth) polygon.push_back({left, 0});
  }
  return polygon;
}

std::size_t root(std::size_t points) {
  return static_cast<std::size_t>(std::sqrt(static_cast<double>(points)));
}

// A comb whose teeth are bent into nested arcs about the origin, of radius 1 to 2 and from angle `begin` to
// `end`. All have their vertices at the same angles, so that neighbours stay apart however thin they are.
Polygon nested_hairs(std::size_t points, std::size_t teeth, double begin, double end) {
  const std::size_t along_tooth = (points - 3) / (2 * teeth);
  const std::size_t spare = points - 2 * along_tooth * teeth;
  const double width = 1 / static_cast<double>(2 * teeth);
  const double step = (end - begin) / static_cast<double>(along_tooth);
  const auto at = [](double radius, double angle) -> Point {
    return {radius * std::cos(angle), radius * std::sin(angle)};
  };
  Polygon hairs;
  hairs.reserve(points);
  for (std::size_t k = 0; k < teeth; ++k) {
    const double outer = 2 - width * static_cast<double>(2 * k);
    const double inner = outer - width;
    for (std::size_t j = 1; j <= along_tooth; ++j) hairs.push_back(at(outer, begin + step * static_cast<double>(j)));
    for (std::size_t j = along_tooth; j > 0; --j) hairs.push_back(at(inner, begin + step * static_cast<double>(j)));
  }
  // The spine: from the innermost hair back to the outermost, below all of them.
  append_line(hairs, at(1 - width, begin - 0.01), at(2 + width, begin - 0.01), spare);
  return hairs;
}

// A band along a spiral of Archimedes, as wide as the gap between its turns.
Polygon spiral(std::size_t points, double turns, Point centre) {
  const double pitch = 1 / turns;
  const std::size_t outer = points / 2, inner = points - outer;
  const auto at = [&](double turn, double shift) -> Point {
    const double r = 0.1 + pitch * turn + shift, angle = full_turn * turn;
    return {centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)};
  };
  Polygon band;
  band.reserve(points);
  // The root spreads points evenly along its length.
  const auto turn_at = [&](std::size_t k, std::size_t count) {
    return turns * std::sqrt((static_cast<double>(k) + 0.5) / static_cast<double>(count));
  };
  for (std::size_t k = 0; k < inner; ++k) band.push_back(at(turn_at(k, inner), 0));
  for (std::size_t k = outer; k > 0; --k) band.push_back(at(turn_at(k - 1, outer), pitch / 2));
  return band;
}

Polygon turned_by(Polygon polygon, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Point& point : polygon) point = {c * point.x - s * point.y, s * point.x + c * point.y};
  return polygon;
}

}  // namespace

Scene make_spirals(std::size_t points) {
  const double turns = std::sqrt(static_cast<double>(points)) / 10;
  return {spiral(points, turns, {}), spiral(points, turns, {0.7, 0.1}), std::nullopt, std::nullopt};
}

Scene make_rings(std::size_t points) {
  // Rings that are open on one side, across rings about another centre.
  constexpr double begin = 0.1, end = 6.1;
  const std::size_t rings = root(points) / 4;
  Polygon second = nested_hairs(points, rings, begin, end);
  for (Point& point : second) point = {1.31 - 0.83 * point.y, 0.27 + 0.83 * point.x};
  return {nested_hairs(points, rings, begin, end), std::move(second), std::nullopt, std::nullopt};
}

Scene make_net(std::size_t points) {
  Scene scene = make_comb(points);
  for (Polygon* const polygon : {&scene.first, &scene.second}) *polygon = turned_by(std::move(*polygon), 0.6);
  return scene;
}

Scene make_comb(std::size_t points) {
  const auto teeth = static_cast<std::size_t>(std::sqrt(static_cast<double>(points)) / 10);
  Scene scene{upright_comb(points, teeth), upright_comb(points, teeth), std::nullopt, 4 * teeth * teeth};
  // Turned by a right angle, its teeth reach through all of the other's, its spine and their ends stay
  // outside.
  // The odd numbers keep vertices of one off the segments of the other.
  const double length = 1.20307;
  const double height = 0.90173;
  for (Point& point : scene.second) point = {1.10213 - length * point.y, 0.04129 + height * point.x};
  const double width = 1 / static_cast<double>(2 * teeth - 1);
  const double teeth_area = static_cast<double>(teeth) * width;
  const double area1 = 0.2 + teeth_area;
  scene.smooth_areas = areas_from_overlap(area1, length * height * area1, height * teeth_area * teeth_area);
  return scene;
}

Scene make_hairs(std::size_t points) {
  // A narrow ellipse across all of them, near the middle of each. Nothing runs along an axis.
  const double begin = 0.5;
  const double end = 0.61;
  const Point along{std::cos((begin + end) / 2), std::sin((begin + end) / 2)};
  Polygon ellipse = circle(points, 0.2, 1, {});
  for (Point& point : ellipse) {
    const double u = 1.5 + 0.6 * point.x;
    const double v = 0.03 * point.y;
    point = {along.x * u - along.y * v, along.y * u + along.x * v};
  }
  return {nested_hairs(points, root(points), begin, end), std::move(ellipse), std::nullopt, std::nullopt};
}

Scene make_long_hairs(std::size_t points) {
  return {nested_hairs(points, root(points), 0, std::numbers::pi), circle(points, 0.2, 0.6, {0.3, 1.4}), std::nullopt,
          std::nullopt};
}

}  // namespace lober::bench

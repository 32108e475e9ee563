// Scenes made of circles: where the answer is known in closed form.
#include "bench/scenes/shapes.hpp"

namespace lober::bench {
namespace {

// Angles from 0, on one side of it, whose spacing grows geometrically from `first` until they reach half a
// turn after `count` steps: first (q^k - 1) / (q - 1) with the growth q that fits.
struct Growth {
  double first, rate;  // q = e^rate
  [[nodiscard]] double angle(double k) const { return first * std::expm1(rate * k) / std::expm1(rate); }
};

Growth fitting_growth(double first, double count) {
  double low = 1e-12;
  double high = 1;
  for (int step = 0; step < 200; ++step) {
    const double middle = (low + high) / 2;
    (Growth{first, middle}.angle(count) < std::numbers::pi ? low : high) = middle;
  }
  return {first, low};
}

// A unit circle through the origin, densest there: on both sides of the origin the spacing begins with 1e-12.
// Written with half angles, so that points 1e-12 away from the origin keep all their digits.
Polygon geometric_circle(std::size_t points, double direction, Point shift) {
  const std::size_t half = points / 2;
  const Growth growth = fitting_growth(1e-12, static_cast<double>(half));
  const Point inward{std::cos(direction), std::sin(direction)};
  const auto at = [&](double angle) -> Point {
    const double sine = std::sin(angle / 2);
    const double along = 2 * sine * sine;
    const double across = -std::sin(angle);
    return {shift.x + inward.x * along - inward.y * across, shift.y + inward.y * along + inward.x * across};
  };
  Polygon polygon;
  polygon.reserve(points);
  for (std::size_t k = 0; k < half; ++k) polygon.push_back(at(growth.angle(static_cast<double>(k))));
  const double stretch = static_cast<double>(half) / static_cast<double>(points - half);  // 1, or less if odd
  for (std::size_t k = points - half; k > 0; --k) {
    polygon.push_back(at(-growth.angle((static_cast<double>(k) - 0.5) * stretch)));
  }
  return polygon;
}

}  // namespace

Scene make_lens(std::size_t points) {
  return {circle(points, 0.1, 1, {}), circle(points, 0.7, 1, {1, 0.3}), areas_of_unit_discs(std::hypot(1, 0.3)), 2};
}

Scene make_geometric(std::size_t points) {
  // Turned by one radian about the densest point, then moved by less than a nanometre on the scale of a
  // metre: the circles cross among points that are 1e-12 apart, at a good angle, and once more far away.
  const Point shift{3e-10, 1e-10};
  const double turn = 1;
  const double distance = std::hypot(std::cos(turn) - 1 + shift.x, std::sin(turn) + shift.y);
  return {geometric_circle(points, 0, {}), geometric_circle(points, turn, shift), areas_of_unit_discs(distance), 2};
}

Scene make_nested(std::size_t points) {
  const double area = std::numbers::pi;
  const double inner = std::numbers::pi * (0.9 * 0.9 + 0.05 * 0.05 / 2);
  return {circle(points, 0, 1, {}),
          radial_curve(points, 0.5, [](double angle) { return 0.9 + 0.05 * std::sin(7 * angle); }),
          std::array{area - inner, 0.0, inner, area}, 0};
}

Scene make_identical(std::size_t points) {
  const Polygon curve = radial_curve(points, 0, [](double angle) { return 1 + 0.3 * std::sin(5 * angle); });
  const double area = std::numbers::pi * (1 + 0.3 * 0.3 / 2);
  return {curve, started_at(curve, points / 3), std::array{0.0, 0.0, area, area}, 0};
}

Scene make_disjoint(std::size_t points) {
  const double area = std::numbers::pi;
  return {circle(points, 0, 1, {}), circle(points, 0, 1, {3, 0.5}), std::array{area, area, 0.0, 2 * area}, 0};
}

}  // namespace lober::bench

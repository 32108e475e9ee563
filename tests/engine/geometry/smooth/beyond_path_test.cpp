// Arcs of a circle beside paths of straight lines that its polygon has another side of.
#include "engine/geometry/smooth/beyond_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace lober::detail {
namespace {

constexpr double turn_of_arc = 0.1;

// Half the unit circle from (1, 0) on, counter-clockwise.
std::vector<Point> circle_points() {
  std::vector<Point> points;
  for (int k = 0; k * turn_of_arc < std::numbers::pi; ++k)
    points.push_back({std::cos(k * turn_of_arc), std::sin(k * turn_of_arc)});
  return points;
}

double twice_beyond(const std::vector<Point>& path) {
  const std::vector<Point> points = circle_points();
  return twice_beyond_path(SmoothCurve(CurveView{points, false}), path, points.size() - 1);
}

// From above, by that much at most: twice the area, which sums may count for and against.
void expect_twice_twice(double found, double area, double above) {
  EXPECT_GE(found, 4 * area);
  EXPECT_LE(found, 4 * area + above);
}

Point on_ray(double angle, double radius) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}
// The part of the unit disc beyond a line at this distance from its centre.
double beyond_line(double distance) {
  return std::acos(distance) - distance * std::sqrt(1 - distance * distance);
}

// A line across the ray of that angle, so long that it leaves the disc.
std::vector<Point> line_across(double angle, double distance) {
  const Point at = on_ray(angle, distance), along = on_ray(angle + std::numbers::pi / 2, 2);
  return {at - along, at + along};
}

TEST(BeyondPath, BetweenAChordAndItsArc) {
  const double middle = 10.5 * turn_of_arc, chord = std::cos(turn_of_arc / 2);
  for (const double part : {0.01, 0.5, 0.99}) {
    const double distance = chord + part * (1 - chord);
    expect_twice_twice(twice_beyond(line_across(middle, distance)), beyond_line(distance), 2e-7);
  }
  EXPECT_LE(twice_beyond(line_across(middle, 1 + 1e-5)), 1e-9);
  EXPECT_LE(twice_beyond(line_across(middle, chord - 1e-5)), 1e-9);  // crosses segments and arcs beside
}

// A spike that ends between a chord and its arc; one that ends on the chord's other side crosses both.
TEST(BeyondPath, ACornerOfThePath) {
  const double middle = 10.5 * turn_of_arc, apex = 1 - 0.4 * (1 - std::cos(turn_of_arc / 2)), width = 0.002;
  const Point along = on_ray(middle + std::numbers::pi / 2, width), out = on_ray(middle, apex + 0.1);
  const double depth = 1 - apex;
  const std::vector<Point> spike{out - along, on_ray(middle, apex), out + along};
  const double found = twice_beyond(spike), triangle = depth * depth * width / 0.1;
  EXPECT_NEAR(found, 4 * triangle, 0.2 * triangle);
  EXPECT_EQ(twice_beyond({out - along, on_ray(middle, 0.9), out + along}), 0);
}

// Both begin in the first point of the curve: the path between the arc and its chord, within the chord and outside.
TEST(BeyondPath, WhereTheCurveBegins) {
  const Point begin{1, 0};
  for (const double part : {0.2, 0.5, 0.8}) {
    // A line that leaves the disc again after this angle.
    const double angle = part * turn_of_arc;
    const Point end{1 - 3 * std::sin(angle / 2), 3 * std::cos(angle / 2)};
    for (const bool backward : {false, true}) {
      const std::vector<Point> path = backward ? std::vector{end, begin} : std::vector{begin, end};
      expect_twice_twice(twice_beyond(path), (angle - std::sin(angle)) / 2, 2e-5);
    }
  }
  EXPECT_LE(twice_beyond({begin, {1.5, 2}}), 1e-9);
  EXPECT_LE(twice_beyond({{0.2, 3}, {2, 2}, begin}), 1e-9);
  EXPECT_LE(twice_beyond({begin, {-1, 1}}), 1e-9);
}

TEST(BeyondPath, SegmentsThatAreLookedAt) {
  const std::vector<Point> points = circle_points();
  const std::vector<Point> path = line_across(10.5 * turn_of_arc, (1 + std::cos(turn_of_arc / 2)) / 2);
  const SmoothCurve curve(CurveView{points, false});
  EXPECT_EQ(twice_beyond_path(curve, path, 10), 0);
  EXPECT_GT(twice_beyond_path(curve, path, 11), 0);
}

}  // namespace
}  // namespace lober::detail

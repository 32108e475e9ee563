// Where the energy ends on a section.
#include "engine/operations/section_edge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lober/dynamics/systems.hpp"

namespace lober {
namespace {

// The section x = 0 of the ship has the area pi e R in (y, vy).
TEST(SectionEdge, BoundsTheSectionOfTheShip) {
  const System ship = make_system("capsize", {{"energy", 0.25307}});
  const auto edge = detail::section_edge(*ship.flow, *ship.section, 0.25307, Rectangle::of({-1, -1}, {1, 1}));
  ASSERT_EQ(edge.size(), 1U);
  EXPECT_TRUE(edge[0].closed);
  const std::vector<Point>& points = edge[0].points;
  double area = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Point a = points[k], b = points[(k + 1) % points.size()];
    area += 0.5 * (b.x * a.y - a.x * b.y);  // larger energies lie on the left: clockwise
  }
  EXPECT_NEAR(area, std::numbers::pi * 0.25307 * 1.6, 1e-3);
  for (const Point& at : points) {
    EXPECT_FALSE(ship.map->is_defined_at({1.001 * at.x, 1.001 * at.y}));
    EXPECT_TRUE(ship.map->is_defined_at({0.999 * at.x, 0.999 * at.y}));
  }
  // A flow of three dimensions has none.
  const System abc = make_system("abc");
  EXPECT_TRUE(detail::section_edge(*abc.flow, *abc.section, 0, Rectangle::of({-1, -1}, {1, 1})).empty());
}

}  // namespace
}  // namespace lober

// Orbits against the map itself, folding, and starting points.
#include "lober/dynamics/orbits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober::detail {
namespace {

std::vector<Point> orbits_of(const PlanarMap& map, std::span<const Point> starts, const OrbitOptions& options) {
  std::vector<Point> all;
  follow_orbits(map, starts, options, [&](std::size_t first, std::span<const Point> points) {
    EXPECT_EQ(first * (options.iterates + 1), all.size());
    all.insert(all.end(), points.begin(), points.end());
    return true;
  });
  return all;
}

TEST(Orbits, AreIteratesOfTheMap) {
  for (const char* name : {"henon", "duffing"}) {
    const System system = make_system(name);
    const Buffer<Point> starts = spread_points(Rectangle::of({-0.5, -0.5}, {0.5, 0.5}), 37);
    const std::vector<Point> found = orbits_of(*system.map, starts, {.iterates = 6});
    ASSERT_EQ(found.size(), 37U * 7U);
    for (std::size_t k = 0; k < starts.size(); ++k) {
      Point point = starts[k];
      for (std::size_t n = 0; n <= 6; ++n) {
        EXPECT_EQ(found[7 * k + n], point) << name << ' ' << k << ' ' << n;
        system.map->iterate({&point, 1}, 1);
      }
    }
    const auto again = with_threads(7, [&] { return orbits_of(*system.map, starts, {.iterates = 6}); });
    EXPECT_EQ(again, found);
  }
}

// Folded or lifted, the orbit is the same on the cylinder.
TEST(Orbits, AreFoldedIntoOneCell) {
  const System system = make_system("standard", {{"K", 0.6}});
  const Buffer<Point> starts = spread_points(system.window, 20);
  const OrbitOptions cylinder{.iterates = 30, .lattice = system.lattice, .origin = {-1, 0}};
  const std::vector<Point> found = orbits_of(*system.map, starts, cylinder);
  const std::vector<Point> lifted = orbits_of(*system.map, starts, {.iterates = 30});
  bool turned = false;
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_GE(found[k].x, -1 - 1e-12);
    EXPECT_LT(found[k].x, -1 + 2 * std::numbers::pi + 1e-12);
    EXPECT_NEAR(std::remainder(found[k].x - lifted[k].x, 2 * std::numbers::pi), 0, 1e-9);
    EXPECT_NEAR(found[k].y, lifted[k].y, 1e-9);
    turned = turned || std::fabs(found[k].x - lifted[k].x) > 20;
  }
  EXPECT_TRUE(turned);
  EXPECT_EQ(folded({7, 5}, {}, {1, 1}), (Point{7, 5}));
  const Point slanted = folded({7, 8}, {2, 2}, {0, 0});
  EXPECT_NEAR(slanted.x, 1, 1e-12);
  EXPECT_NEAR(slanted.y, 2, 1e-12);
}

// On the torus, of angles that wind both ways: (x, y) in the parallelogram of two slanted lattices as well.
TEST(Orbits, AreFoldedOnTheTorus) {
  using std::numbers::pi;
  const System system = make_system("abc");
  const Buffer<Point> starts = spread_points(Rectangle::of({-1, -3}, {1, 3}), 20);
  const OrbitOptions torus{
      .iterates = 30, .lattice = system.lattice, .origin = {-pi, -pi}, .second_lattice = system.second_lattice};
  const std::vector<Point> found = orbits_of(*system.map, starts, torus);
  const std::vector<Point> lifted = orbits_of(*system.map, starts, {.iterates = 30});
  bool turned = false;
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (std::isnan(found[k].x)) continue;
    EXPECT_LT(std::fabs(found[k].x), pi + 1e-12);
    EXPECT_LT(std::fabs(found[k].y), pi + 1e-12);
    turned = turned || std::fabs(lifted[k].y) > 20;
    // Chaotic orbits keep this to few iterates only.
    if (k % 31 > 3) continue;
    EXPECT_NEAR(std::remainder(found[k].x - lifted[k].x, 2 * pi), 0, 1e-7);
    EXPECT_NEAR(std::remainder(found[k].y - lifted[k].y, 2 * pi), 0, 1e-7);
  }
  EXPECT_TRUE(turned);
  EXPECT_EQ(folded({7, 5}, {}, {}, {1, 1}), (Point{7, 5}));
  EXPECT_EQ(folded({7, 5}, {}, {0, 2}, {0, 0}), (Point{7, 1}));
  EXPECT_EQ(folded({7, 5}, {2, 0}, {0, 2}, {0, 0}), (Point{1, 1}));
  EXPECT_EQ(folded({7.5, 5}, {2, 0}, {1, 2}, {0, 0}), (Point{1.5, 1}));
}

TEST(Orbits, EndWhereTheyAreLost) {
  const System system = make_system("henon");
  const std::vector<Point> starts{{0, 0}, {50, 50}};
  const std::vector<Point> found = orbits_of(*system.map, starts, {.iterates = 12});
  EXPECT_TRUE(std::isfinite(found[12].x));
  EXPECT_TRUE(std::isnan(found[25].x));
  EXPECT_THROW(follow_orbits(*system.map, starts, {.iterates = 3}, [](std::size_t, auto) { return false; }), Cancelled);
}

// Each sixteenth of the square holds about a sixteenth of the points.
TEST(SpreadPoints, AreEven) {
  const Rectangle box = Rectangle::of({1, 10}, {3, 14});
  const Buffer<Point> points = spread_points(box, 1600);
  std::vector<int> counts(16);
  for (const Point& point : points) {
    ASSERT_TRUE(point.x >= 1 && point.x <= 3 && point.y >= 10 && point.y <= 14);
    ++counts[static_cast<std::size_t>(std::floor(2 * (point.x - 1))) * 4 +
             static_cast<std::size_t>(std::floor(point.y - 10))];
  }
  for (const int count : counts) EXPECT_NEAR(count, 100, 6);
  EXPECT_EQ(spread_points(box, 10)[9], points[9]);
}

}  // namespace
}  // namespace lober::detail

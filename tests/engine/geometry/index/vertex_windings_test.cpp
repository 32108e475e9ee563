// Vertices of one curve located with respect to another all at once: the same as one by one, with all threads too.
#include "engine/geometry/index/vertex_windings.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "lober/overlay/index.hpp"
#include "tests/oracle/random.hpp"

namespace lober::detail {
namespace {

using oracle::Random;

// A closed curve that may cross itself: steps anywhere, or on a grid, where vertices share heights and lie on segments.
std::vector<Point> wandering(Random& random, std::size_t size, bool grid) {
  std::vector<Point> points;
  Point at{0, 0};
  for (std::size_t k = 0; k < size; ++k) {
    const auto step = [&] { return grid ? static_cast<double>(random.integer(-2, 2)) : random.uniform(-1, 1); };
    const double pull = grid ? 0 : 0.02;
    at = {at.x * (1 - pull) + step(), at.y * (1 - pull) + step()};
    if (grid && std::fabs(at.x) > 12) at.x = 0;
    if (grid && std::fabs(at.y) > 12) at.y = 0;
    points.push_back(at);
  }
  return points;
}

std::vector<std::uint32_t> some_numbers(Random& random, std::size_t size, double chance) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t k = 0; k < size; ++k) {
    if (random.chance(chance)) numbers.push_back(k);
  }
  return numbers;
}

TEST(VertexWindings, AreThoseOfTheRayFromEachVertex) {
  Random random(1);
  std::size_t on = 0, together = 0;
  for (int attempt = 0; attempt < 60; ++attempt) {
    const bool grid = random.chance(0.5);
    const std::vector<Point> first = wandering(random, static_cast<std::size_t>(random.integer(3, 9000)), grid);
    const std::vector<Point> second = wandering(random, static_cast<std::size_t>(random.integer(3, 9000)), grid);
    const IndexedCurve c1{CurveView{first}}, c2{CurveView{second}};
    const auto expected_of = [](const IndexedCurve& own, const IndexedCurve& other,
                                const std::vector<std::uint32_t>& vertices) {
      std::vector<RayCrossings> expected;
      for (const std::uint32_t vertex : vertices) {
        expected.push_back(ray_crossings(other.tree(), own.view().points[vertex]));
      }
      return expected;
    };
    const auto require_right = [&](const std::vector<std::uint32_t>& vertices,
                                   const std::vector<RayCrossings>& expected, const Buffer<RayCrossings>& found) {
      ASSERT_EQ(found.size(), vertices.size());
      for (std::size_t k = 0; k < vertices.size(); ++k) {
        ASSERT_EQ(found[k].on, expected[k].on) << "try " << attempt << ", vertex " << vertices[k];
        on += static_cast<std::size_t>(expected[k].on);
        if (!expected[k].on) {
          ASSERT_EQ(found[k].number, expected[k].number) << "try " << attempt << ", vertex " << vertices[k];
        }
      }
    };
    for (const double chance : {0.001, 0.02, 0.3, 1.0}) {
      const std::vector<std::uint32_t> vertices1 = some_numbers(random, first.size(), chance);
      const std::vector<std::uint32_t> vertices2 = some_numbers(random, second.size(), chance);
      const std::vector<RayCrossings> expected1 = expected_of(c1, c2, vertices1);
      const std::vector<RayCrossings> expected2 = expected_of(c2, c1, vertices2);
      together +=
          static_cast<std::size_t>(vertices1.size() + vertices2.size() >= c1.tree().leaves() + c2.tree().leaves());
      for (const int threads : {1, 2}) {
        std::array<Buffer<RayCrossings>, 2> found;
        with_threads(threads, [&] { found = vertex_windings(c1, c2, {vertices1, vertices2}); });
        ASSERT_NO_FATAL_FAILURE(require_right(vertices1, expected1, found[0]));
        ASSERT_NO_FATAL_FAILURE(require_right(vertices2, expected2, found[1]));
      }
    }
  }
  EXPECT_GT(on, 1000U);
  EXPECT_GT(together, 100U);
}

}  // namespace
}  // namespace lober::detail

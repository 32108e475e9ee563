// Where a leaf may meet itself: nothing is lost, and a fold with its two sides apart has nothing but its end.
#include "engine/geometry/index/leaf_turns.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "kernels/leaf.hpp"
#include "kernels/predicates.hpp"
#include "tests/engine/geometry/index/search_testing.hpp"
#include "tests/kernels/random_doubles.hpp"
#include "tests/shapes.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

Box box_of(const Points& points) {
  Box box = Box::of(points[0], points[1]);
  for (std::size_t k = 1; k < leaf_size; ++k) box = union_of(box, Box::of(points[k], points[k + 1]));
  return box;
}

// Out along a slanted line and back beside it, `apart` from there; the way back may be bent into the way out.
Points fold(Random& random, double apart) {
  const std::size_t turn = random.index(leaf_size + 1);
  const double direction = random.uniform(0, 7), x = std::cos(direction), y = std::sin(direction);
  Points points;
  for (std::size_t k = 0; k <= leaf_size; ++k) {
    const double u =
        k <= turn ? static_cast<double>(k) : 2.0 * static_cast<double>(turn) + 0.5 - static_cast<double>(k);
    const double v = k <= turn ? 0 : apart;
    points.push_back({u * x - v * y, u * y + v * x});
  }
  return points;
}

TEST(LeafTurns, LoseNothing) {
  Random random(seed());
  std::size_t common = 0;
  for (int k = 0; k < 20000; ++k) {
    Points points = fold(random, random.chance(0.5) ? 0 : random.log_uniform(1e-17, 1));
    const double rough = random.chance(0.7) ? random.log_uniform(1e-17, 1) : 0;
    for (Point& point : points) {
      if (random.chance(0.3))
        point = {point.x + rough * random.uniform(-1, 1), point.y + rough * random.uniform(-1, 1)};
    }
    if (random.chance(0.2)) std::fill(points.begin() + 20, points.end(), points[20]);
    const std::uint32_t wanted = segments_meeting_earlier(points.data(), box_of(points));
    for (std::uint32_t j = 2; j < leaf_size; ++j) {
      for (std::uint32_t i = 0; i + 1 < j; ++i) {
        if (points[i] == points[i + 1] || points[j] == points[j + 1]) continue;
        if (!have_common_point({points[i], points[i + 1]}, {points[j], points[j + 1]})) continue;
        bool is_joint = true;  // in the end of the one and the beginning of the other, which repeated points part
        for (std::uint32_t between = i + 1; between < j; ++between) {
          is_joint = is_joint && points[between] == points[between + 1];
        }
        if (is_joint) continue;
        ++common;
        ASSERT_TRUE(wanted >> j & 1) << "try " << k << ": " << i << ' ' << j;
      }
    }
    // Neighbours that lie on each other.
    for (std::uint32_t j = 1; j < leaf_size; ++j) {
      const Point before = points[j - 1], at = points[j], after = points[j + 1];
      if (at == after || before == at) continue;
      PredicateCounts counts;
      if (orient2d(before, at, after, counts) != 0) continue;
      if ((after.x - at.x) * (at.x - before.x) + (after.y - at.y) * (at.y - before.y) >= 0) continue;
      ASSERT_TRUE(wanted >> j & 1) << "try " << k << ": " << j;
    }
  }
  EXPECT_GT(common, 10000U);
}

TEST(LeafTurns, AreThoseOfAFold) {
  Random random(seed());
  for (int k = 0; k < 1000; ++k) {
    const Points points = fold(random, random.log_uniform(1e-6, 1e-1));
    EXPECT_LE(std::popcount(segments_meeting_earlier(points.data(), box_of(points))), 2);
  }
}

}  // namespace
}  // namespace lober::test

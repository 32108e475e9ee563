// Sums of first moments, many at once against one after the other.
#include <gtest/gtest.h>

#include <vector>

#include "kernels/moments.hpp"
#include "tests/oracle/random.hpp"

namespace lober::detail {
namespace {

void expect_near(DD found, DD expected, double scale) {
  EXPECT_NEAR((found - expected).hi, 0, scale * 0x1p-95);
}

TEST(Moments, ManySegmentsAddUpToTheirTerms) {
  oracle::Random random(1);
  for (const std::size_t count : {0U, 1U, 2U, 3U, 4U, 5U, 7U, 8U, 31U, 1000U, 1001U, 1002U, 1003U}) {
    for (const double factor : {1.0, 0x1p-3, 0x1p40}) {
      std::vector<Point> points(count + 1);
      for (Point& p : points) p = {random.uniform(-1, 1) + 1e3, random.uniform(-1, 1)};
      const Point origin{1e3 * factor, 0.25 * factor};
      Moments expected;
      for (std::size_t k = 0; k < count; ++k) {
        expected += moments_of_segment(points[k], points[k + 1], origin, factor);
      }
      const Moments found = moments_along(points.data(), count, origin, factor);
      const double size = factor * factor * static_cast<double>(count);
      expect_near(found.area, expected.area, size);
      expect_near(found.x, expected.x, factor * size);
      expect_near(found.y, expected.y, factor * size);
    }
  }
}

TEST(Moments, AreThoseOfATriangle) {
  // (0, 0), (6, 0), (0, 3): area 9, centroid (2, 1); the origin does not matter.
  const std::vector<Point> triangle{{0, 0}, {6, 0}, {0, 3}, {0, 0}};
  for (const Point origin : {Point{0, 0}, Point{5, -7}}) {
    const Moments moments = moments_along(triangle.data(), 3, origin, 1);
    EXPECT_EQ(moments.area.hi, 18);
    EXPECT_EQ(origin.x + moments.x.hi / (3 * moments.area.hi), 2);
    EXPECT_EQ(origin.y + moments.y.hi / (3 * moments.area.hi), 1);
  }
}

}  // namespace
}  // namespace lober::detail

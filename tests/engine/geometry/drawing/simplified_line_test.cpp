// Lines of a picture with fewer points.

#include "lober/curve/drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/distance.hpp"

namespace lober {
namespace {

bool same(Point a, Point b) {
  return a.x == b.x && a.y == b.y;
}

// Every point lies by the segment between the kept points around it.
void expect_close(const std::vector<Point>& line, double tolerance) {
  const std::vector<Point> kept = simplified_line(line, tolerance);
  ASSERT_GE(kept.size(), 2U);
  ASSERT_TRUE(same(kept.front(), line.front()) && same(kept.back(), line.back()));
  std::size_t segment = 0;
  for (const Point& p : line) {
    if (segment + 2 < kept.size() && same(p, kept[segment + 1])) ++segment;
    ASSERT_LE(distance_to_segment(p, kept[segment], kept[segment + 1]), tolerance * 1.4142136);
  }
}

TEST(SimplifiedLine, StaysWithinTheTolerance) {
  std::mt19937_64 generator(5);
  std::normal_distribution<double> normal;
  for (const double memory : {0.0, 0.9, 0.999}) {
    std::vector<Point> line{{0, 0}};
    Point step{0, 0};
    for (int k = 0; k < 20'000; ++k) {
      step = {memory * step.x + normal(generator), memory * step.y + normal(generator)};
      line.push_back({line.back().x + step.x, line.back().y + step.y});
    }
    for (const double tolerance : {0.1, 2.0, 50.0}) expect_close(line, tolerance);
  }
}

TEST(SimplifiedLine, LeavesOutWhatIsStraight) {
  std::vector<Point> line;
  for (int k = 0; k <= 1000; ++k) line.push_back({0.3 * k, 0.7 * k});
  EXPECT_EQ(simplified_line(line, 0.01).size(), 2U);
  for (int k = 1000; k-- > 0;) line.push_back({0.3 * k, 0.7 * k});  // and back
  EXPECT_LE(simplified_line(line, 0.01).size(), 4U);
  EXPECT_GE(simplified_line(line, 0.01).size(), 3U);
  EXPECT_EQ(simplified_line(std::vector<Point>(5, {1, 2}), 0.1).size(), 2U);
  EXPECT_TRUE(simplified_line({}, 0.1).empty());
}

TEST(SimplifiedLine, TakesFewPointsOfACircle) {
  std::vector<Point> line;
  for (int k = 0; k <= 100'000; ++k) line.push_back({500 * std::cos(6e-5 * k), 500 * std::sin(6e-5 * k)});
  EXPECT_LT(simplified_line(line, 0.1).size(), 200U);
  EXPECT_GT(simplified_line(line, 0.1).size(), 60U);
}

}  // namespace
}  // namespace lober

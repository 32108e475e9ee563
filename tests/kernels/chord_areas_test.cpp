#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

#include "kernels/cpu.hpp"
#include "kernels/sagitta.hpp"

namespace lober::detail {
namespace {

TEST(SagittaAreas, ManyAtOnceHaveTheBitsOfOneByOne) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> step(0, 1);
  for (const double scale : {1.0, 1e-150, 1e-170, 1e150}) {
    for (int round = 0; round < 50; ++round) {
      std::vector<Point> points(700);
      Point at{1, 2};
      double angle = 0;
      for (Point& point : points) {
        point = {scale * at.x, scale * at.y};
        angle += (round % 3 == 0 ? 2.0 : 0.1) * step(random);  // corners, or none
        const double length = random() % 20 == 0 ? 0 : 0.5 + 0.4 * std::sin(step(random));
        at = {at.x + length * std::cos(angle), at.y + length * std::sin(angle)};
      }
      const std::size_t count = points.size() - 3;
      std::vector<double> areas(count);
      twice_chord_areas(points.data(), count, areas.data());
      for (std::size_t k = 0; k < count; ++k) {
        const double one = twice_chord_area(points[k], points[k + 1], points[k + 2], points[k + 3]);
        ASSERT_EQ(std::bit_cast<std::uint64_t>(areas[k]), std::bit_cast<std::uint64_t>(one)) << scale << ' ' << k;
      }
    }
  }
}

// Sums over an arc of any number of segments, as both compiled copies have them and as one segment after the other has.
TEST(SagittaAreas, MeasuresOfArcsAreSumsOverSegments) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> step(0, 1);
  const Point origin{0.3, -0.2};
  for (const std::size_t count : {1U, 2U, 3U, 4U, 5U, 255U, 256U, 257U, 700U}) {
    std::vector<Point> points(count + 3);
    Point at{1, 2};
    for (Point& point : points) {
      point = at;
      at = {at.x + 0.1 * step(random), at.y + 0.1 * step(random)};
    }
    ArcMeasures expected;
    for (std::size_t k = 1; k <= count; ++k) {
      const Point a = points[k] - origin, b = points[k + 1] - origin;
      expected.twice_area += cross(a, b);
      expected.moment_x += cross(a, b) * (a.x + b.x);
      expected.moment_y += cross(a, b) * (a.y + b.y);
      expected.length += distance(points[k], points[k + 1]);
      expected.chord_area += std::fabs(twice_chord_area(points[k - 1], points[k], points[k + 1], points[k + 2]));
    }
    ArcMeasures found, baseline;
    add_arc_measures(points.data(), count, origin, found);
    const InstructionSet before = instruction_set();
    limit_instruction_set(InstructionSet::baseline);
    add_arc_measures(points.data(), count, origin, baseline);
    limit_instruction_set(before);
    EXPECT_EQ(std::memcmp(&found, &baseline, sizeof found), 0) << count;
    const double size = 1e-13 * static_cast<double>(count);
    EXPECT_NEAR(found.twice_area, expected.twice_area, 10 * size);
    EXPECT_NEAR(found.moment_x, expected.moment_x, 100 * size);
    EXPECT_NEAR(found.moment_y, expected.moment_y, 100 * size);
    EXPECT_NEAR(found.length, expected.length, size);
    EXPECT_NEAR(found.chord_area, expected.chord_area, size);
  }
}

// Two arcs of circles that meet in corners, as the manifolds of a boundary do in a pip: polygons lose what lies between
// the arcs and their chords, and nothing at the corners, however little these turn.
TEST(SagittaAreas, CornersAmongDensePointsHaveNone) {
  for (const double turn : {1e-3, 0.02, 0.1, 0.35, 0.7, 1.2}) {
    for (const double uneven : {1.0, 3.0}) {
      constexpr int segments = 200;
      const double half = 0.5;  // angle that each arc turns by
      std::vector<Point> points;
      for (const int side : {0, 1}) {
        const double direction = side == 0 ? 0 : half + turn;
        const Point begin = points.empty() ? Point{0, 0} : points.back();
        for (int k = side; k <= segments; ++k) {
          const double t = (k + (k % 2 == 1 ? 0.5 - 0.5 / uneven : 0)) / segments, angle = half * t;
          points.push_back({begin.x + std::sin(direction + angle) - std::sin(direction),
                            begin.y - std::cos(direction + angle) + std::cos(direction)});
        }
      }
      double lost = 0, estimate = 0;
      for (std::size_t k = 1; k + 2 < points.size(); ++k) {
        const double chord = distance(points[k], points[k + 1]), angle = 2 * std::asin(chord / 2);
        lost += angle - std::sin(angle);
        estimate += twice_chord_area(points[k - 1], points[k], points[k + 1], points[k + 2]);
      }
      EXPECT_NEAR(estimate / lost, 1, 0.02) << turn << ' ' << uneven;
    }
  }
}

}  // namespace
}  // namespace lober::detail

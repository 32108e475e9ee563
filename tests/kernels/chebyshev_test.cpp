#include "kernels/chebyshev.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <random>
#include <vector>

#include "kernels/cpu.hpp"

namespace lober::detail {
namespace {

// Clenshaw's recurrence, one parameter at a time.
Point one_point(const std::vector<Point>& coefficients, double centre, double half_width, double parameter) {
  const double x = (parameter - centre) / half_width;
  Point latest, later;
  for (std::size_t j = coefficients.size(); j-- > 1;) {
    const Point c = coefficients[j];
    const Point next{2 * x * latest.x + (c.x - later.x), 2 * x * latest.y + (c.y - later.y)};
    later = latest;
    latest = next;
  }
  const Point c = coefficients.empty() ? Point{} : coefficients[0];
  return {x * latest.x + (c.x - later.x), x * latest.y + (c.y - later.y)};
}

TEST(Chebyshev, ManyAtOnceHaveTheBitsOfOneByOneOnEveryInstructionSet) {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const auto set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    limit_instruction_set(set);
    for (const std::size_t degrees : {0U, 1U, 2U, 3U, 41U}) {
      std::vector<Point> coefficients(degrees);
      for (Point& c : coefficients) c = {number(random), number(random)};
      for (std::size_t size = 0; size < 80; ++size) {
        std::vector<double> parameters(size);
        for (double& s : parameters) s = 0.5 + 2 * number(random);
        std::vector<Point> points(size + 1, Point{7, 8});
        chebyshev_points(coefficients, 0.5, 2, parameters, std::span(points).first(size));
        for (std::size_t k = 0; k < size; ++k) {
          const Point one = one_point(coefficients, 0.5, 2, parameters[k]);
          ASSERT_EQ(points[k].x, one.x) << degrees << ' ' << size << ' ' << k;
          ASSERT_EQ(points[k].y, one.y) << degrees << ' ' << size << ' ' << k;
        }
        ASSERT_EQ(points[size], (Point{7, 8}));
      }
    }
  }
  limit_instruction_set(InstructionSet::avx512);
}

TEST(Chebyshev, CoefficientsGiveTheirPointsBack) {
  constexpr std::size_t count = 17;
  std::array<double, count> nodes;
  std::array<Point, count> given, coefficients, points;
  for (std::size_t k = 0; k < count; ++k) {
    nodes[k] = chebyshev_node(k, count);
    given[k] = {std::exp(nodes[k]), std::sin(3 * nodes[k])};
  }
  chebyshev_coefficients(given, coefficients);
  chebyshev_points(coefficients, 0, 1, nodes, points);
  for (std::size_t k = 0; k < count; ++k) {
    EXPECT_NEAR(points[k].x, given[k].x, 1e-14);
    EXPECT_NEAR(points[k].y, given[k].y, 1e-14);
  }
}

TEST(Chebyshev, RoundingsBehindTheLastLargeCoefficientGo) {
  const auto size = [](std::initializer_list<Point> coefficients) {
    const std::vector<Point> all(coefficients);
    const std::span<const Point> left = without_roundings(all);
    EXPECT_TRUE(left.empty() || left.data() == all.data());
    return left.size();
  };
  EXPECT_EQ(size({}), 0U);
  EXPECT_EQ(size({{0, 0}, {0, 0}}), 1U);
  EXPECT_EQ(size({{1, 1}, {1e-17, 0}, {0, 1e-17}}), 1U);
  EXPECT_EQ(size({{1, 1}, {1e-17, 0}, {0, 3e-16}, {1e-17, 0}}), 3U);
  EXPECT_EQ(size({{1, 1e-9}, {1e-17, 0}, {0, 1e-17}}), 3U);  // each coordinate has a size of its own
  EXPECT_EQ(size({{1, 1}, {0, std::numeric_limits<double>::quiet_NaN()}}), 2U);
}

}  // namespace
}  // namespace lober::detail

#include "kernels/turning.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace lober::detail {
namespace {

// The definition, one vertex at a time, and with the operations of the kernel.
struct VertexCurvature {
  double defined, computed;
};
VertexCurvature vertex_curvature(Point a, Point b, Point c, double ab, double bc) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - b.x, vy = c.y - b.y;
  const double sine = std::fabs(ux * vy - uy * vx);    // times both lengths, as is
  const double below = ab * bc + (ux * vx + uy * vy);  // 1 + cosine
  const bool is_soft = 2 * sine < 4 * below;
  const double angle = is_soft ? 2 * sine / below : ab * bc > 0 ? 4.0 : 0.0;
  const double once = is_soft ? 4 * sine / (below * (ab + bc)) : 8 / (ab + bc);
  return {angle > 0 ? 2 * angle / (ab + bc) : 0.0, angle > 0 ? once : 0.0};
}

std::vector<Point> polyline(std::uint64_t seed, std::size_t size) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> step(0, 1);
  std::vector<Point> points(size);
  double angle = 0;
  for (std::size_t k = 1; k < size; ++k) {
    angle += (k % 50 == 0 ? 2.0 : 0.1) * step(random);  // corners now and then
    const double length = random() % 20 == 0 ? 0 : std::exp(step(random));
    points[k] = {points[k - 1].x + length * std::cos(angle), points[k - 1].y + length * std::sin(angle)};
    if (random() % 97 == 0) points[k].x = std::numeric_limits<double>::quiet_NaN();
    if (std::isnan(points[k - 1].x)) points[k] = {1, 2};
  }
  return points;
}

TEST(Turning, ManyAtOnceHaveTheBitsOfOneByOne) {
  for (const std::size_t size : {2U, 3U, 256U, 257U, 258U, 259U, 513U, 2000U}) {
    const std::vector<Point> points = polyline(size, size);
    std::vector<double> lengths(size - 1), curvatures(size - 2);
    turns_along(points.data(), size - 1, lengths.data(), curvatures.data());
    for (std::size_t k = 0; k + 1 < size; ++k) {
      const double x = points[k + 1].x - points[k].x, y = points[k + 1].y - points[k].y;
      if (std::isnan(x)) continue;
      ASSERT_EQ(lengths[k], std::sqrt(x * x + y * y)) << size << ' ' << k;
    }
    for (std::size_t k = 0; k + 2 < size; ++k) {
      const VertexCurvature one = vertex_curvature(points[k], points[k + 1], points[k + 2], lengths[k], lengths[k + 1]);
      ASSERT_EQ(std::bit_cast<std::uint64_t>(curvatures[k]), std::bit_cast<std::uint64_t>(one.computed))
          << size << ' ' << k;
      ASSERT_NEAR(curvatures[k], one.defined, 1e-15 * one.defined) << size << ' ' << k;
    }
  }
}

// A circle of radius 2 in chords of length h lies h^2 / 16 off them.
TEST(Turning, PartsOfACircle) {
  const double curvature = 0.5;
  const std::vector<double> lengths{0.1, 0.2, 0.4, 4, std::numeric_limits<double>::quiet_NaN()};
  // The larger of both ends counts.
  const std::vector<double> curvatures{-1, curvature, 0.25, curvature, curvature, curvature};
  std::vector<double> parts(lengths.size());
  const double tolerance = 0.01 / 16;
  parts_needed(lengths.data(), curvatures.data(), lengths.size(), {tolerance, 1e9, 16}, parts.data());
  EXPECT_NEAR(parts[0], 1, 1e-14);
  EXPECT_NEAR(parts[1], 2, 1e-14);
  EXPECT_NEAR(parts[2], 4, 1e-14);
  EXPECT_EQ(parts[3], 16);
  EXPECT_EQ(parts[4], 16);
  parts_needed(lengths.data(), curvatures.data(), 3, {tolerance, 0.025, 16}, parts.data());
  EXPECT_NEAR(parts[0], 4, 1e-14);
}

}  // namespace
}  // namespace lober::detail

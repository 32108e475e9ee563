#include "kernels/smooth_segment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "kernels/cpu.hpp"

namespace lober::detail {
namespace {

using Window = std::array<Point, 8>;
using SegmentKind = SmoothSegment::Kind;

Window circle_window(double h) {
  Window p;
  for (std::size_t k = 0; k < 8; ++k) {
    const double t = h * (static_cast<double>(k) - 3.5) + 1;
    p[k] = {std::cos(t), std::sin(t)};
  }
  return p;
}

TEST(SmoothSegment, ReproducesGraphsOfDegreeFive) {
  // y = x (x - 1) (g0 + g1 x + g2 x^2 + g3 x^3) through uneven x, turned and moved.
  const std::array<double, 4> g{0.1, -0.03, 0.02, -0.005};
  const std::array<double, 8> x{-2.9, -2.1, -0.8, 0, 1, 1.7, 2.4, 3.6};
  const double turn = 0.7;
  const auto transformed = [&](double u, double v) {
    return Point{3 + 2 * (u * std::cos(turn) - v * std::sin(turn)), 4 + 2 * (u * std::sin(turn) + v * std::cos(turn))};
  };
  const auto y = [&](double u) { return u * (u - 1) * (g[0] + u * (g[1] + u * (g[2] + u * g[3]))); };
  Window p;
  for (std::size_t k = 0; k < 8; ++k) p[k] = transformed(x[k], y(x[k]));
  const SmoothSegment segment = fit_smooth_segment(p);
  ASSERT_EQ(segment.kind, SegmentKind::smooth);
  for (const double u : {0.0, 0.2, 0.5, 0.9, 1.0, 1.1}) {
    const Point expected = transformed(u, y(u)), at = segment.at(u);
    EXPECT_NEAR(p[3].x + at.x, expected.x, 1e-14);
    EXPECT_NEAR(p[3].y + at.y, expected.y, 1e-14);
    const Point ahead = segment.at(u + 1e-6), behind = segment.at(u - 1e-6), velocity = segment.velocity(u);
    EXPECT_NEAR(velocity.x, (ahead.x - behind.x) / 2e-6, 1e-8);
    EXPECT_NEAR(velocity.y, (ahead.y - behind.y) / 2e-6, 1e-8);
    double loop = 0;  // a fan of triangles about the first end
    constexpr int steps = 20000;
    for (int k = 0; k < steps; ++k) {
      const Point a = segment.at(u * k / steps), b = segment.at(u * (k + 1) / steps);
      loop += a.x * b.y - a.y * b.x;
    }
    EXPECT_NEAR(segment.chord_area(u), loop, 1e-9);
  }
}

TEST(SmoothSegment, ChordAreaOfACircleIsRightToOrderSeven) {
  double previous = 0;
  for (double h = 0.4; h > 0.04; h /= 2) {
    const SmoothSegment segment = fit_smooth_segment(circle_window(h));
    const double error = std::fabs(segment.chord_area(1) - (h - std::sin(h)));
    EXPECT_LT(error, segment.error);
    if (previous > 0) {
      EXPECT_LT(error, previous / 110);
    }
    previous = error;
  }
}

TEST(SmoothSegment, DoesNotLookBeyondCorners) {
  Window p = circle_window(0.1);
  const double full = fit_smooth_segment(p).chord_area(1);
  for (std::size_t k = 5; k < 8; ++k) p[k] = {p[4].x + 0.1 * static_cast<double>(k - 4), p[4].y};  // corner at p[4]
  const SmoothSegment left = fit_smooth_segment(p);
  EXPECT_EQ(left.kind, SegmentKind::smooth);
  EXPECT_NEAR(left.chord_area(1), full, 0.02 * full);
  EXPECT_GT(left.error, std::fabs(left.chord_area(1) - full));
  for (std::size_t k = 0; k < 3; ++k) p[k] = {p[3].x - 0.1 * static_cast<double>(3 - k), p[3].y};  // and at p[3]
  EXPECT_EQ(fit_smooth_segment(p).kind, SegmentKind::straight);
  EXPECT_EQ(fit_smooth_segment(p).chord_area(1), 0);
}

// Twice the area that an ellipse of half-axes 1 and 0.2 has beyond the chord between two of its points.
TEST(SmoothSegment, SpikesOfFewVerticesHaveAnErrorBar) {
  const double b = 0.2;
  for (const double first : {-3.5, -3.2, -3.0, -2.5}) {
    for (const double h : {0.2, 0.25, 0.3, 0.35}) {
      Window p;
      for (std::size_t k = 0; k < 8; ++k) {
        const double t = h * (static_cast<double>(k) + first);
        p[k] = {std::cos(t), b * std::sin(t)};
      }
      const SmoothSegment spike = fit_smooth_segment(p);
      EXPECT_LE(std::fabs(spike.chord_area(1) - b * (h - std::sin(h))), spike.error) << first << ' ' << h;
    }
  }
  // The sides of polygons have none, with vertices between their corners or without.
  for (const std::size_t divided : {1U, 3U}) {
    Window p{Point{0, 0}};
    for (std::size_t k = 1; k < 8; ++k) {
      const double angle = std::numbers::pi / 3 * static_cast<double>(k / divided);
      p[k] = {p[k - 1].x + std::cos(angle), p[k - 1].y + std::sin(angle)};
    }
    EXPECT_LE(fit_smooth_segment(p).error, 1e-14);
  }
}

TEST(SmoothSegment, TakesAZigzagForNoise) {
  Window p;
  for (std::size_t k = 0; k < 8; ++k) p[k] = {static_cast<double>(k), k % 2 == 0 ? 0 : 0.05};
  const SmoothSegment segment = fit_smooth_segment(p);
  EXPECT_EQ(segment.kind, SegmentKind::noisy);
  EXPECT_EQ(segment.chord_area(1), 0);
  EXPECT_GT(segment.error, 0.01);
}

TEST(SmoothSegment, RunsTheSameWayBack) {
  Window p = circle_window(0.2);
  p[1].x += 0.01;
  const double there = fit_smooth_segment(p).chord_area(1);
  std::reverse(p.begin(), p.end());
  EXPECT_NEAR(fit_smooth_segment(p).chord_area(1), -there, 1e-16);
}

TEST(SmoothSegment, HasNoneWithoutLength) {
  Window p = circle_window(0.2);
  p[4] = p[3];
  const SmoothSegment segment = fit_smooth_segment(p);
  EXPECT_EQ(segment.kind, SegmentKind::straight);
  EXPECT_EQ(segment.chord_area(1), 0);
  EXPECT_EQ(segment.error, 0);
}

// Curves that are smooth, that have corners, whose points are uneven, and that are noise.
TEST(SmoothSegment, ManyAtOnceHaveTheBitsOfOneByOne) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> step(0, 1);
  std::size_t smooth_ones = 0, others = 0;
  for (const InstructionSet set : {instruction_set(), InstructionSet::baseline}) {
    const InstructionSet before = instruction_set();
    limit_instruction_set(set);
    for (const double scale : {1.0, 1e-150, 1e150}) {
      for (int round = 0; round < 60; ++round) {
        std::vector<Point> points(round % 5 == 0 ? 8 : 700);
        Point at{1, 2};
        double angle = 0;
        for (Point& point : points) {
          point = {scale * at.x, scale * at.y};
          angle += round % 3 == 0 ? 0.1 * step(random) : round % 3 == 1 ? 0.02 : 0;
          if (random() % 50 == 0) angle += step(random);
          const double length = random() % 20 == 0 ? 0.03 : 0.5 + 0.4 * std::sin(step(random));
          at = {at.x + length * std::cos(angle), at.y + length * std::sin(angle)};
        }
        const std::size_t count = points.size() - 7;
        std::vector<double> areas(count), errors(count);
        std::vector<std::uint8_t> smooth(count);
        smooth_chord_areas(points.data(), count, areas.data(), errors.data(), smooth.data());
        for (std::size_t k = 0; k < count; ++k) {
          Window window;
          std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(k), window.size(), window.begin());
          const SmoothSegment one = fit_smooth_segment(window);
          ASSERT_EQ(std::bit_cast<std::uint64_t>(areas[k]), std::bit_cast<std::uint64_t>(one.chord_area(1))) << k;
          ASSERT_EQ(std::bit_cast<std::uint64_t>(errors[k]), std::bit_cast<std::uint64_t>(one.error)) << k;
          ASSERT_EQ(smooth[k] != 0, one.kind == SegmentKind::smooth) << k;
          ++(smooth[k] != 0 ? smooth_ones : others);
        }
      }
    }
    limit_instruction_set(before);
  }
  EXPECT_GT(smooth_ones, 10'000U);
  EXPECT_GT(others, 10'000U);
}

}  // namespace
}  // namespace lober::detail

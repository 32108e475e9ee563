#include "kernels/interpolation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace lober::detail {
namespace {

CubicPiece random_piece(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto point = [&] { return Point{unit(random), unit(random)}; };
  return {point(), point(), point(), point()};
}

TEST(Interpolation, CurvatureIsThatOfTheCircleWithItsSign) {
  const auto on_circle = [](double angle) { return Point{5 + 4 * std::cos(angle), 4 * std::sin(angle)}; };
  EXPECT_NEAR(curvature(on_circle(0.1), on_circle(0.5), on_circle(1.7)), 0.25, 1e-15);
  EXPECT_NEAR(curvature(on_circle(1.7), on_circle(0.5), on_circle(0.1)), -0.25, 1e-15);
  EXPECT_EQ(curvature({0, 0}, {1, 1}, {2, 2}), 0);
  EXPECT_EQ(curvature({0, 0}, {0, 0}, {2, 2}), 0);
  EXPECT_EQ(curvature({0, 0}, {1, 1}, {0, 0}), 0);
  EXPECT_EQ(curvature({0, 0}, {1e200, 0}, {0, 1e200}), 0);
}

// The polynomial of Naik, Lekien & Ross (2017), term by term.
TEST(Interpolation, DritschelIsThePublishedCubic) {
  const Point a{1, 2}, b{4, 6};  // e = 5
  const double ka = 0.03, kb = -0.05, e = 5;
  const double mu = -e * (2 * ka + kb) / 6, beta = e * ka / 2, gamma = e * (kb - ka) / 6;
  const CubicPiece piece = dritschel_piece(a, b, ka, kb);
  for (const double p : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const double eta = mu * p + beta * p * p + gamma * p * p * p;
    EXPECT_NEAR(piece.at(p).x, a.x + 3 * p - 4 * eta, 1e-15);
    EXPECT_NEAR(piece.at(p).y, a.y + 4 * p + 3 * eta, 1e-14);
  }
}

// Around a circle that is run counter-clockwise the cubic bends outwards, by the sagitta kappa e^2 / 8 in the middle.
TEST(Interpolation, DritschelLeansToTheRightSide) {
  const double step = 0.01;
  const Point a{std::cos(0.0), std::sin(0.0)}, b{std::cos(step), std::sin(step)};
  const Point middle = dritschel_piece(a, b, 1, 1).at(0.5);
  EXPECT_NEAR(std::hypot(middle.x, middle.y), 1, 1e-10);
  EXPECT_GT(std::hypot(middle.x, middle.y), std::cos(step / 2) + step * step / 16);
}

TEST(Interpolation, SplinePieceHasTheSecondDerivativesGiven) {
  const Point a{0, 0}, b{3, 4}, ma{1, -2}, mb{-3, 5};
  const CubicPiece piece = spline_piece(a, b, ma, mb);
  const double h = 1e-4;
  for (const auto& [t, m] : {std::pair{h, ma}, {1 - h, mb}}) {
    const Point low = piece.at(t - h), here = piece.at(t), high = piece.at(t + h);
    EXPECT_NEAR((low.x - 2 * here.x + high.x) / (h * h) / 25, m.x, 1e-2);  // dt = ds / 5
    EXPECT_NEAR((low.y - 2 * here.y + high.y) / (h * h) / 25, m.y, 1e-2);
  }
}

TEST(Interpolation, SubdividingIsEvaluatingToTheBit) {
  std::mt19937_64 random(7);
  for (const std::uint32_t parts : {2U, 3U, 7U, 10U, 1001U}) {
    const CubicPiece piece = random_piece(random);
    std::vector<Point> whole(parts - 1), split(parts - 1);
    subdivide(piece, parts, 1, parts, whole.data());
    const std::uint32_t middle = 1 + parts / 3;
    subdivide(piece, parts, 1, middle, split.data());
    subdivide(piece, parts, middle, parts, split.data() + (middle - 1));
    for (std::uint32_t k = 1; k < parts; ++k) {
      EXPECT_EQ(whole[k - 1], piece.at(k * (1.0 / parts)));
      EXPECT_EQ(split[k - 1], whole[k - 1]);
    }
  }
}

TEST(Interpolation, BoundsHoldOnTheWholePiece) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 300; ++round) {
    const CubicPiece piece = random_piece(random);
    const PieceBounds bounds = bounds_of(piece);
    const double h = 1e-3;
    for (double t = h; t < 1 - h; t += h) {
      const Point low = piece.at(t - h), here = piece.at(t), high = piece.at(t + h);
      const Point speed{(high.x - low.x) / (2 * h), (high.y - low.y) / (2 * h)};
      const Point bend{(low.x - 2 * here.x + high.x) / (h * h), (low.y - 2 * here.y + high.y) / (h * h)};
      EXPECT_LE(speed.x * speed.x + speed.y * speed.y, bounds.speed2 + 1e-4);
      EXPECT_GE(speed.x * piece.chord.x + speed.y * piece.chord.y, bounds.advance - 1e-4);
      EXPECT_LE(bend.x * bend.x + bend.y * bend.y, bounds.bend2 + 1e-4);
    }
  }
}

TEST(Interpolation, TurningAngles) {
  EXPECT_EQ(turning_angle({0, 0}, {1, 0}, {2, 0}), 0);
  EXPECT_NEAR(turning_angle({0, 0}, {1, 0}, {1, -3}), std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(turning_angle({0, 0}, {1, 0}, {0, 0}), std::numbers::pi, 1e-15);
  EXPECT_EQ(turning_angle({0, 0}, {0, 0}, {1, 0}), 0);
  EXPECT_EQ(turning_angle_bound({0, 0}, {0, 0}, {1, 0}), 0);
  EXPECT_TRUE(std::isinf(turning_angle_bound({0, 0}, {1, 0}, {0, 1})));
  std::mt19937_64 random(13);
  for (int round = 0; round < 1000; ++round) {
    const CubicPiece p = random_piece(random);
    EXPECT_GE(turning_angle_bound(p.a, p.chord, p.u), turning_angle(p.a, p.chord, p.u) * (1 - 1e-15));
  }
}

}  // namespace
}  // namespace lober::detail

// Points from a function instead of an interpolation.

#include <gtest/gtest.h>

#include <atomic>

#include "engine/base/parallel/parallel.hpp"
#include "lober/densify.hpp"
#include "tests/engine/geometry/densify/shapes.hpp"

namespace lober {
namespace {

using namespace densify_test;

CurveFunction from(Point (*point)(double)) {
  return [point](std::span<const double> parameters, std::span<Point> points) {
    for (std::size_t k = 0; k < parameters.size(); ++k) points[k] = point(parameters[k]);
  };
}

void expect_images(const SampledCurve& curve, Point (*point)(double)) {
  ASSERT_EQ(curve.points.size(), curve.parameters.size());
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    EXPECT_EQ(curve.points[k], point(curve.parameters[k]));
    if (k > 0) {
      EXPECT_LT(curve.parameters[k - 1], curve.parameters[k]);
    }
  }
}

TEST(DensifySampled, CriteriaHoldOnExactImages) {
  const std::vector<double> start{0, 1, 3, 5};
  for (const double period : {0.0, 2 * std::numbers::pi}) {
    const Criteria criteria{.longest = 0.05, .angle = 0.02, .distance_angle = 5e-4, .shortest = 1e-6};
    const SampledCurve curve =
        densify_sampled(start, from(ellipse_at), {.criteria = criteria, .period = period, .batch = 7});
    expect_images(curve, ellipse_at);
    EXPECT_TRUE(curve.flaws.empty());
    EXPECT_EQ(curve.closed, period != 0);
    EXPECT_EQ(curve.parameters.front(), 0);
    if (period == 0) {
      EXPECT_EQ(curve.parameters.back(), 5);
    }
    const Extremes found = extremes(curve);
    EXPECT_LE(found.longest, 0.05);
    EXPECT_LE(found.angle, 0.02 * (1 + 1e-9));
    EXPECT_LE(found.distance_angle, 5e-4 * (1 + 1e-9));
    EXPECT_LT(curve.points.size(), 2000U);
  }
}

// A map that stretches: the twentieth image of a short segment under the cat map without the modulus.
TEST(DensifySampled, StretchingMaps) {
  const auto image = [](double t) {
    Point p{0.01 * t, 0.01 * t * t};
    for (int k = 0; k < 8; ++k) p = {p.x + p.y + 0.3 * std::sin(p.x), p.y + 0.3 * std::sin(p.x)};
    return p;
  };
  const std::vector<double> start{0, 1};
  const Criteria criteria{.angle = 0.3, .distance_angle = 1e-3, .shortest = 1e-7};
  const SampledCurve curve = densify_sampled(start, from(image), {.criteria = criteria});
  expect_images(curve, image);
  EXPECT_TRUE(curve.flaws.empty());
  EXPECT_LE(extremes(curve).angle, 0.3 * (1 + 1e-9));
}

TEST(DensifySampled, JumpsEndAtTheSpacingAndAreReported) {
  const auto jump = [](double t) { return Point{t, t < 0.3 ? 0.0 : 1.0}; };
  const std::vector<double> start{0, 0.5, 1};
  const SampledCurve curve = densify_sampled(start, from(jump), {.criteria = {.longest = 0.1}, .least_spacing = 1e-6});
  expect_images(curve, jump);
  ASSERT_EQ(curve.flaws.size(), 1U);
  const Flaw flaw = curve.flaws[0];
  EXPECT_EQ(flaw.cause, FlawCause::spacing);
  EXPECT_EQ(flaw.count, 1U);
  EXPECT_LT(curve.parameters[flaw.first], 0.3);
  EXPECT_GE(curve.parameters[flaw.first + 1], 0.3);
  EXPECT_GE(curve.parameters[flaw.first + 1] - curve.parameters[flaw.first], 1e-6);
  // Without a spacing it ends where doubles do.
  const SampledCurve close = densify_sampled(start, from(jump), {.criteria = {.longest = 0.1}, .most_rounds = 2000});
  ASSERT_EQ(close.flaws.size(), 1U);
  EXPECT_EQ(close.flaws[0].cause, FlawCause::spacing);
  EXPECT_EQ(close.parameters[close.flaws[0].first + 1], std::nextafter(close.parameters[close.flaws[0].first], 1));
}

TEST(DensifySampled, PointsThatAreNotFiniteAreLeftOut) {
  const auto pole = [](double t) { return Point{t, t == 0.5 ? std::nan("") : t < 0.5 ? 0.0 : 10.0}; };
  const SampledCurve curve = densify_sampled(std::vector<double>{0, 1}, from(pole), {.criteria = {.longest = 0.25}});
  ASSERT_EQ(curve.flaws.size(), 1U);
  EXPECT_EQ(curve.flaws[0], (Flaw{0, 1, FlawCause::not_finite}));
  EXPECT_EQ(curve.points.size(), 2U);
  EXPECT_THROW((void)densify_sampled(std::vector<double>{0, 0.5, 1}, from(pole), {.criteria = {.longest = 0.25}}),
               DataError);
}

TEST(DensifySampled, LimitsAndFloor) {
  const std::vector<double> start{0, 1, 2};
  const Criteria criteria{.longest = 1e-3};
  const SampledCurve few = densify_sampled(start, from(ellipse_at), {.criteria = criteria, .most_points = 100});
  EXPECT_LE(few.points.size(), 100U);
  ASSERT_EQ(few.flaws.size(), few.points.size() - 1);
  EXPECT_EQ(few.flaws[0].cause, FlawCause::most_points);
  const SampledCurve once = densify_sampled(start, from(ellipse_at), {.criteria = criteria, .most_rounds = 1});
  EXPECT_EQ(once.points.size(), 5U);
  EXPECT_EQ(once.rounds, 1U);
  EXPECT_EQ(once.flaws.at(3), (Flaw{3, 1, FlawCause::most_rounds}));
  const SampledCurve floor =
      densify_sampled(start, from(ellipse_at), {.criteria = {.longest = 1e-3, .shortest = 0.01}});
  EXPECT_GE(extremes(floor).shortest, 0.0099);
  EXPECT_EQ(floor.flaws.at(0).cause, FlawCause::shortest);
}

TEST(DensifySampled, BadInput) {
  const SampledOptions options{.criteria = {.longest = 0.1}};
  const auto run = [&](const std::vector<double>& start, const SampledOptions& chosen) {
    (void)densify_sampled(start, from(ellipse_at), chosen);
  };
  EXPECT_THROW(run({0}, options), UsageError);
  EXPECT_THROW(run({0, 0}, options), UsageError);
  EXPECT_THROW(run({0, std::nan("")}, options), UsageError);
  EXPECT_THROW(run({0, 2}, {.criteria = {.longest = 0.1}, .period = 1}), UsageError);
  EXPECT_THROW(run({0, 2}, {.criteria = {.longest = -1}}), UsageError);
  EXPECT_THROW(run({0, 2}, {.criteria = {.longest = 1}, .batch = 0}), UsageError);
  const CurveFunction failing = [](std::span<const double> parameters, std::span<Point> points) {
    for (std::size_t k = 0; k < parameters.size(); ++k) points[k] = {parameters[k], 0};
    if (parameters[0] == 0.25) throw DataError("the map fails here");
  };
  EXPECT_THROW((void)densify_sampled(std::vector<double>{0, 1}, failing, options), DataError);
}

TEST(DensifySampled, SameBitsForAnyNumberOfThreads) {
  std::atomic<std::size_t> evaluated = 0;
  const CurveFunction function = [&](std::span<const double> parameters, std::span<Point> points) {
    from(ellipse_at)(parameters, points);
    evaluated += parameters.size();
  };
  const auto run = [&] {
    return densify_sampled(std::vector<double>{0, 2, 3}, function, {.criteria = {.longest = 1e-4}, .batch = 100});
  };
  const SampledCurve one = with_threads(1, run);
  EXPECT_EQ(evaluated, one.points.size());  // no point is asked for twice
  for (const int threads : {2, 7}) {
    const SampledCurve more = with_threads(threads, run);
    EXPECT_TRUE(one.points == more.points);
    EXPECT_TRUE(one.parameters == more.parameters);
  }
}

}  // namespace
}  // namespace lober

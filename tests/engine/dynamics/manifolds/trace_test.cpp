#include "engine/dynamics/manifolds/trace.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/distance.hpp"

namespace lober::detail {
namespace {

constexpr double wave_tolerance = 1e-6, wave_end = 6;

// A wave that is much steeper at one end than at the other.
Point wave(double s) {
  return {s, std::sin(s * s)};
}
const CurveFunction wave_at = [](std::span<const double> parameters, std::span<Point> points) {
  std::transform(parameters.begin(), parameters.end(), points.begin(), wave);
};

Trace traced_wave(std::uint32_t max_rounds, bool images_are_dear, std::size_t& evaluations) {
  constexpr std::size_t size = 33;
  Samples guide{Buffer<double>(size), Buffer<Point>(size)};
  for (std::size_t k = 0; k < size; ++k) guide.parameters[k] = wave_end * static_cast<double>(k) / (size - 1);
  wave_at(guide.parameters, guide.points);
  TraceOptions options;
  options.tolerance = wave_tolerance;
  options.max_length = 1;
  options.min_spacing = 1e-12;
  options.box = Box::of({-10, -10}, {10, 10});
  options.max_points = 100000;
  options.max_rounds = max_rounds;
  options.images_are_dear = images_are_dear;
  evaluations = 0;
  options.evaluated = [&](std::size_t more) { evaluations += more; };
  return traced(std::move(guide), {0, 10, size - 1}, {}, wave_at, options);
}

double worst_on_wave(const Samples& samples) {
  double most = 0;
  for (std::size_t k = 0; k + 1 < samples.points.size(); ++k) {
    const double from = samples.parameters[k], step = samples.parameters[k + 1] - from;
    for (int j = 1; j < 16; ++j) {
      most = std::max(most, distance_to_segment(wave(from + step * j / 16), samples.points[k], samples.points[k + 1]));
    }
  }
  return most / wave_tolerance;
}

TEST(Trace, MeetsTheToleranceWhetherImagesAreDearOrNot) {
  std::size_t dear = 0, cheap = 0;
  const Trace with = traced_wave(40, true, dear), without = traced_wave(40, false, cheap);
  for (const Trace* trace : {&with, &without}) {
    EXPECT_TRUE(trace->diagnostics.empty());
    EXPECT_LE(worst_on_wave(trace->samples), 1.1);
    const Samples& samples = trace->samples;
    for (std::size_t k = 0; k < samples.points.size(); ++k) ASSERT_EQ(samples.points[k], wave(samples.parameters[k]));
    // A point that is kept has its parameter still.
    ASSERT_EQ(trace->kept.size(), 3U);
    EXPECT_EQ(samples.parameters[trace->kept[1]], wave_end * 10 / 32);
    EXPECT_EQ(trace->kept[2], samples.points.size() - 1);
  }
  EXPECT_NEAR(static_cast<double>(with.samples.points.size()), static_cast<double>(without.samples.points.size()),
              0.05 * static_cast<double>(without.samples.points.size()));
  EXPECT_LT(dear, cheap);
}

// The guide is unfinished then, but what its segments require is known of each.
TEST(Trace, PlacesPointsByAGuideThatRoundsDoNotSufficeFor) {
  std::size_t evaluations = 0;
  const std::size_t enough = traced_wave(40, true, evaluations).samples.points.size();
  for (const bool images_are_dear : {true, false}) {
    const Trace trace = traced_wave(1, images_are_dear, evaluations);
    EXPECT_FALSE(trace.diagnostics.empty());
    EXPECT_GT(trace.samples.points.size(), enough / 2);
    EXPECT_LE(worst_on_wave(trace.samples), 100);
  }
}

}  // namespace
}  // namespace lober::detail

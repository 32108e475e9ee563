// The densifier: 10^6 points to 10^7, against one plain area sum over the points that come out (one thread) and against
// writing them once, in the same run.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/curve/densify.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t given_points = 1'000'000;
constexpr double pi = 3.14159265358979312;

std::vector<Point> wavy_circle(std::size_t count) {
  std::vector<Point> points(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = 2 * pi * static_cast<double>(k) / static_cast<double>(count);
    const double radius = 1 + 0.1 * std::sin(5 * angle);
    points[k] = {radius * std::cos(angle), radius * std::sin(angle)};
  }
  return points;
}

// One plain area sum: the first unit.
double plain_sum(std::span<const Point> points) {
  double sum[4] = {};
  for (std::size_t k = 0; k + 4 < points.size(); k += 4) {
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const Point a = points[k + lane], b = points[k + lane + 1];
      sum[lane] += a.x * b.y - b.x * a.y;
    }
  }
  return sum[0] + sum[1] + sum[2] + sum[3];
}

// The other unit: what it costs to write the same points once into memory of their own, with as many threads.
double copy_seconds(std::span<const Point> points) {
  const Stopwatch watch;
  Buffer<Point> copy(points.size());
  for_each_block(points.size(), std::size_t{1} << 14, [&](std::size_t first, std::size_t last) {
    std::copy(points.begin() + static_cast<std::ptrdiff_t>(first), points.begin() + static_cast<std::ptrdiff_t>(last),
              copy.begin() + static_cast<std::ptrdiff_t>(first));
  });
  benchmark::DoNotOptimize(copy.data());
  return watch.seconds();
}

// Times `run` and, right behind it, the units over its result; reports the ratios of the medians.
template <typename Run>
void against_sum(benchmark::State& state, const Run& run) {
  const auto threads = static_cast<int>(state.range(0));
  std::vector<double> times, units, copies;
  std::size_t size = 0, rounds = 0, diagnostics = 0;
  for (auto _ : state) {
    const Stopwatch watch;
    const DensifiedCurve result = with_threads(threads, run);
    times.push_back(watch.seconds());
    state.SetIterationTime(times.back());
    const Stopwatch unit_watch;
    benchmark::DoNotOptimize(plain_sum(result.points));
    units.push_back(unit_watch.seconds());
    copies.push_back(with_threads(threads, [&] { return copy_seconds(result.points); }));
    size = result.points.size();
    rounds = result.rounds;
    diagnostics = result.diagnostics.size();
  }
  const auto median = [](std::vector<double>& values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
  };
  state.counters["points_out"] = static_cast<double>(size);
  state.counters["rounds"] = static_cast<double>(rounds);
  state.counters["diagnostics"] = static_cast<double>(diagnostics);
  state.counters["sum_ms"] = 1e3 * median(units);
  state.counters["copy_ms"] = 1e3 * median(copies);
  state.counters["x_sum"] = median(times) / median(units);
  state.counters["x_copy"] = median(times) / median(copies);
}

Interpolation kind(const benchmark::State& state) {
  return static_cast<Interpolation>(state.range(1));
}

// The distance criterion, chosen so that every segment is cut into ten parts or so.
void distance_criterion(benchmark::State& state) {
  const std::vector<Point> points = wavy_circle(given_points);
  state.SetLabel(std::string(name(kind(state))));
  const Criteria criteria{.max_length = 6.7e-7};
  against_sum(state, [&] { return densify({points, true}, criteria, {.interpolation = kind(state)}); });
}

// Angles: the same number of points from distance times angle.
void angle_criteria(benchmark::State& state) {
  const std::vector<Point> points = wavy_circle(given_points);
  state.SetLabel(std::string(name(kind(state))));
  const Criteria criteria{.angle = 0.3, .distance_angle = 1.1e-12, .min_length = 1e-10};
  against_sum(state, [&] { return densify({points, true}, criteria, {.interpolation = kind(state)}); });
}

void simplifying(benchmark::State& state) {
  const std::vector<Point> points = wavy_circle(10 * given_points);
  against_sum(state, [&] { return simplify({points, true}, {.tolerance = 1e-10}); });
}

void passes_near_crossings(benchmark::State& state) {
  const std::vector<Point> points = wavy_circle(given_points);
  std::vector<Point> circle(given_points);
  for (std::size_t k = 0; k < circle.size(); ++k) {
    const double angle = 2 * pi * (static_cast<double>(k) + 0.3) / given_points;
    circle[k] = {std::cos(angle), std::sin(angle)};
  }
  state.SetLabel(std::string(name(kind(state))));
  const NearOptions options{.passes = 5, .points = 100, .interpolation = kind(state)};
  against_sum(state, [&] { return densify_near({points, true}, {circle, true}, options); });
}

constexpr int linear = 0, dritschel = 1, spline = 2;

BENCHMARK(distance_criterion)
    ->ArgsProduct({{1, 2}, {linear, dritschel, spline}})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(angle_criteria)->ArgsProduct({{1, 2}, {dritschel, spline}})->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(simplifying)->Arg(1)->Arg(2)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(passes_near_crossings)
    ->ArgsProduct({{1}, {linear, dritschel, spline}})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lober::detail

BENCHMARK_MAIN();

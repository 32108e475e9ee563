// The kernels, one by one: time per call, and bytes per second against a plain sum over the same points.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "kernels/box.hpp"
#include "kernels/crossing_parameters.hpp"
#include "kernels/leaf.hpp"
#include "kernels/predicates.hpp"
#include "kernels/segment_boxes.hpp"
#include "kernels/shoelace.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t many_points = 1'000'000;  // 16 MB, beyond the inner caches
constexpr std::size_t few_points = 1024;        // in the innermost one

std::vector<Point> circle(std::size_t count) {
  std::vector<Point> points(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = 6.283185307179586 * static_cast<double>(k) / static_cast<double>(count);
    points[k] = {std::cos(angle), std::sin(angle)};
  }
  return points;
}

// Three points a test, from the unit square.
std::vector<Point> random_points(std::size_t count) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Point> points(count);
  for (Point& point : points) {
    point.x = unit(random);
    point.y = unit(random);
  }
  return points;
}

void per_item(benchmark::State& state, std::size_t items) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(items));
}

void orient2d_of(benchmark::State& state, const std::vector<Point>& points) {
  PredicateCounts counts;
  for (auto _ : state) {
    int sum = 0;
    for (std::size_t k = 0; k + 2 < points.size(); k += 3)
      sum += orient2d(points[k], points[k + 1], points[k + 2], counts);
    benchmark::DoNotOptimize(sum);
  }
  const auto tests = static_cast<double>(state.iterations()) * static_cast<double>(points.size() / 3);
  state.counters["past_filter"] = static_cast<double>(counts.filter_failures) / tests;
  state.counters["exact"] = static_cast<double>(counts.exact_calls) / tests;
  per_item(state, points.size() / 3);
}

void orient2d_random(benchmark::State& state) {
  orient2d_of(state, random_points(3 * few_points));
}

// The third point is the rounded middle of the other two: on the line or an ulp off.
void orient2d_near_degenerate(benchmark::State& state) {
  std::vector<Point> points = random_points(3 * few_points);
  for (std::size_t k = 0; k < points.size(); k += 3) {
    points[k + 2] = {(points[k].x + points[k + 1].x) / 2, (points[k].y + points[k + 1].y) / 2};
  }
  orient2d_of(state, points);
}

// The same with coordinates of very different size, so that differences are not exact in double.
void orient2d_exact_stage(benchmark::State& state) {
  std::vector<Point> points = random_points(3 * few_points);
  for (std::size_t k = 0; k < points.size(); k += 3) {
    const double slope = points[k + 1].y;
    points[k] = {0x1p-60 * points[k].x, 0x1p-60 * points[k].x * slope};
    points[k + 1] = {points[k + 1].x, points[k + 1].x * slope};
    points[k + 2] = {0x1p60 * points[k + 2].x, 0x1p60 * points[k + 2].x * slope};
  }
  orient2d_of(state, points);
}

void plain_sum(benchmark::State& state) {
  const std::vector<Point> points = circle(many_points);
  for (auto _ : state) {
    double sum[4] = {};
    for (std::size_t k = 0; k + 4 < points.size(); k += 4) {
      for (std::size_t lane = 0; lane < 4; ++lane) {
        const Point a = points[k + lane];
        const Point b = points[k + lane + 1];
        sum[lane] += a.x * b.y - b.x * a.y;
      }
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(points.size() * sizeof(Point)));
}

void summarise_leaves_streaming(benchmark::State& state) {
  const std::vector<Point> points = circle(many_points);
  const std::size_t leaves = (points.size() - 1) / leaf_size;
  std::vector<Box> boxes(leaves);
  std::vector<DD> sums(leaves);
  std::vector<std::uint8_t> flags(leaves);
  for (auto _ : state) {
    summarise_leaves(points.data(), 0, leaves, boxes.data(), sums.data(), flags.data());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(points.size() * sizeof(Point)));
}

void segment_boxes_of_leaf(benchmark::State& state) {
  const std::vector<Point> points = circle(few_points);
  SegmentBoxes boxes;
  for (auto _ : state) {
    for (std::size_t k = 0; k + leaf_size < points.size(); k += leaf_size) {
      segment_boxes(points.data() + k, boxes);
      benchmark::DoNotOptimize(boxes);
    }
  }
  per_item(state, (points.size() - 1) / leaf_size);
}

// Two leaves that cross once, at an angle of `range` thousandths of a radian.
void meeting_segments_of_leaves(benchmark::State& state) {
  const double angle = 0.3 + static_cast<double>(state.range(0)) / 1000;
  std::vector<Point> a(leaf_size + 1);
  std::vector<Point> b(leaf_size + 1);
  for (std::size_t k = 0; k <= leaf_size; ++k) {
    const double t = (static_cast<double>(k) - 15.7) / leaf_size;
    a[k] = {t * std::cos(0.3), t * std::sin(0.3)};
    b[k] = {t * std::cos(angle), t * std::sin(angle)};
  }
  const Box box = box_of(b);
  SegmentBoxes boxes;
  segment_boxes(a.data(), boxes);
  std::vector<SegmentPair> pairs(leaf_size * leaf_size);
  std::size_t found = 0;
  for (auto _ : state) {
    found = meeting_segments(boxes, 0, b.data(), box, 0, pairs.data());
    benchmark::DoNotOptimize(pairs.data());
  }
  state.counters["pairs"] = static_cast<double>(found);
  per_item(state, 1);
}

// Crossing segments of unit length, at angles of 10^-range radians.
std::vector<SegmentCrossing> crossings_at_angle(double angle) {
  const std::vector<Point> points = random_points(few_points);
  std::vector<SegmentCrossing> crossings;
  for (const Point& at : points) {
    const double along = 10 * at.x;
    const Point u{std::cos(along), std::sin(along)};
    const Point v{std::cos(along + angle), std::sin(along + angle)};
    crossings.push_back({{at.x - u.x / 2, at.y - u.y / 2},
                         {at.x + u.x / 2, at.y + u.y / 2},
                         {at.x - v.x / 3, at.y - v.y / 3},
                         {at.x + v.x / 3, at.y + v.y / 3}});
  }
  return crossings;
}

void crossing_parameters_at_angle(benchmark::State& state) {
  const auto crossings = crossings_at_angle(std::pow(10.0, -static_cast<double>(state.range(0))));
  std::vector<CrossingParameters> parameters(crossings.size());
  std::size_t exact = 0;
  for (auto _ : state) {
    exact = crossing_parameters(crossings.data(), crossings.size(), 1, parameters.data());
    benchmark::DoNotOptimize(parameters.data());
  }
  state.counters["exact"] = static_cast<double>(exact) / static_cast<double>(crossings.size());
  per_item(state, crossings.size());
}

void shoelace_prefixes_of_leaf(benchmark::State& state) {
  const std::vector<Point> points = circle(few_points);
  LeafPrefixes prefixes;
  for (auto _ : state) {
    for (std::size_t k = 0; k + leaf_size < points.size(); k += leaf_size) {
      shoelace_prefixes(points.data() + k, points[0], {}, nullptr, prefixes);
      benchmark::DoNotOptimize(prefixes);
    }
  }
  per_item(state, (points.size() - 1) / leaf_size * leaf_size);
}

// Two segments that cross a third one at nearly the same point.
void compare_along_exact(benchmark::State& state) {
  const auto crossings = crossings_at_angle(0.5);
  for (auto _ : state) {
    int sum = 0;
    for (const SegmentCrossing& crossing : crossings) {
      const ImplicitPoint p{crossing.c, crossing.d};
      const ImplicitPoint q{crossing.d, {crossing.c.x + 0x1p-50, crossing.c.y}};
      sum += compare_along(crossing.a, crossing.b, p, q);
    }
    benchmark::DoNotOptimize(sum);
  }
  per_item(state, crossings.size());
}

BENCHMARK(orient2d_random);
BENCHMARK(orient2d_near_degenerate);
BENCHMARK(orient2d_exact_stage);
BENCHMARK(plain_sum)->Unit(benchmark::kMillisecond);
BENCHMARK(summarise_leaves_streaming)->Unit(benchmark::kMillisecond);
BENCHMARK(segment_boxes_of_leaf);
BENCHMARK(meeting_segments_of_leaves)->Arg(1)->Arg(100)->Arg(1000);
BENCHMARK(crossing_parameters_at_angle)->Arg(0)->Arg(6)->Arg(12)->Arg(15);
BENCHMARK(shoelace_prefixes_of_leaf);
BENCHMARK(compare_along_exact);

}  // namespace
}  // namespace lober::detail

BENCHMARK_MAIN();

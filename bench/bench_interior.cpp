// The interior function: queries against the direct sum, labels of all vertices against the search for crossings.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "bench/scenes/scenes.hpp"
#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/crossings/node_graph.hpp"
#include "engine/geometry/index/box_tree.hpp"
#include "kernels/box.hpp"
#include "lober/overlay/interior.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t many_points = 1'000'000;

const bench::Scene& scene(const std::string& name) {
  static std::map<std::string, bench::Scene> made;
  if (!made.contains(name)) made[name] = bench::find_scene(name)->make(many_points);
  return made[name];
}

std::vector<Point> random_points(const Box& box, std::size_t count) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> x(box.min_x(), box.max_x()), y(box.min_y(), box.max_y());
  std::vector<Point> points(count);
  for (Point& point : points) {
    point.x = x(random);
    point.y = y(random);
  }
  return points;
}

// Each query by itself, at random points of the bounding box: the median and the 99th percentile in nanoseconds.
// (Reading the clock is in both, some 20 ns.)
template <typename Query>
void queries(benchmark::State& state, const char* name, std::size_t count, const Query& query) {
  using Clock = std::chrono::steady_clock;
  const IndexedCurve curve{CurveView{scene(name).first}};
  const std::vector<Point> points = random_points(curve.tree().box(), count);
  std::vector<double> nanoseconds;
  for (auto _ : state) {
    for (const Point point : points) {
      const auto begin = Clock::now();
      benchmark::DoNotOptimize(query(curve, point));
      nanoseconds.push_back(std::chrono::duration<double, std::nano>(Clock::now() - begin).count());
    }
  }
  std::sort(nanoseconds.begin(), nanoseconds.end());
  state.counters["median_ns"] = nanoseconds[nanoseconds.size() / 2];
  state.counters["p99_ns"] = nanoseconds[nanoseconds.size() * 99 / 100];
  state.SetItemsProcessed(static_cast<std::int64_t>(nanoseconds.size()));
}

void winding_query(benchmark::State& state, const char* name) {
  queries(state, name, 10000, [](const IndexedCurve& curve, Point point) { return winding(curve, point); });
}
void j_query(benchmark::State& state, const char* name) {
  queries(state, name, 10000, [](const IndexedCurve& curve, Point point) { return interior_function(curve, point).j; });
}
void j_direct(benchmark::State& state, const char* name) {
  queries(state, name, 5,
          [](const IndexedCurve& curve, Point point) { return interior_function_direct(curve.view(), point); });
}

struct Prepared {
  explicit Prepared(const char* name) : c1(CurveView{scene(name).first}), c2(CurveView{scene(name).second}) {}
  [[nodiscard]] Crossings search() const {
    return make_crossings(build_node_graph(c1, c2, IndexKind::tree), c1, c2, Orientation::counter_clockwise,
                          Orientation::counter_clockwise);
  }
  IndexedCurve c1, c2;
};

void search_for_crossings(benchmark::State& state, const char* name) {
  const Prepared pair(name);
  for (auto _ : state) benchmark::DoNotOptimize(pair.search());
}
void index_and_search(benchmark::State& state, const char* name) {
  for (auto _ : state) benchmark::DoNotOptimize(Prepared(name).search());
}
void labels_by_propagation(benchmark::State& state, const char* name) {
  const Prepared pair(name);
  const Crossings nodes = pair.search();
  for (auto _ : state) benchmark::DoNotOptimize(label_vertices(nodes, 1));
}
void labels_by_queries(benchmark::State& state, const char* name) {
  const Prepared pair(name);
  for (auto _ : state) benchmark::DoNotOptimize(label_points(pair.c2, pair.c1.view().points));
}
void areas(benchmark::State& state, const char* name) {
  const Prepared pair(name);
  for (auto _ : state) benchmark::DoNotOptimize(interior_areas(pair.c1, pair.c2, {.check_simple = false}));
}

#define LOBER_ON_SCENES(function)                                               \
  BENCHMARK_CAPTURE(function, lens, "lens")->Unit(benchmark::kMillisecond);     \
  BENCHMARK_CAPTURE(function, tangle, "tangle")->Unit(benchmark::kMillisecond); \
  BENCHMARK_CAPTURE(function, dense_tangle, "dense-tangle")->Unit(benchmark::kMillisecond)

LOBER_ON_SCENES(winding_query);
LOBER_ON_SCENES(j_query);
LOBER_ON_SCENES(j_direct);
LOBER_ON_SCENES(search_for_crossings);
LOBER_ON_SCENES(index_and_search);
LOBER_ON_SCENES(labels_by_propagation);
LOBER_ON_SCENES(labels_by_queries);
LOBER_ON_SCENES(areas);

}  // namespace
}  // namespace lober::detail

BENCHMARK_MAIN();

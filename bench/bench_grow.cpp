// Growth of manifolds against a bare loop over the same points: P(s), then k steps of the map for each vertex of
// generation k, in the same run; and images of a circle against the loop over the points of all of them. Counters:
// points and images (steps of the map) a second, images taken for each image that a vertex needs, time over that of the
// bare loop.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/dynamics/manifolds.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober::detail {
namespace {

struct Scene {
  const char* system;
  ParameterValues parameters;
  Point saddle;
  Branch branch;
  int iterates;
  double tolerance;
};

// The steps that the vertices need, and the seconds a loop takes over them.
double bare_loop(const PlanarMap& map, const LocalManifold& local, const GrownManifold& grown, double& steps) {
  const Stopwatch watch;
  Buffer<Point> points(grown.points.size());
  constexpr std::size_t batch = 512;
  steps = 0;
  for (std::size_t k = 0; k + 1 < grown.generation_begin.size(); ++k) {
    const std::size_t begin = grown.generation_begin[k], size = grown.generation_begin[k + 1] - begin;
    for_each_block(size, batch, [&](std::size_t first, std::size_t last) {
      const auto some = std::span(points).subspan(begin + first, last - first);
      local.points_at(std::span(grown.parameters).subspan(begin + first, last - first), some);
      map.iterate(some, static_cast<int>(k) * local.steps);
    });
    steps += static_cast<double>(k * size);
  }
  benchmark::DoNotOptimize(points.data());
  return watch.seconds();
}

double median(std::vector<double>& values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

void growth(benchmark::State& state, const Scene& scene) {
  const auto threads = static_cast<int>(state.range(0));
  const System system = make_system(scene.system, scene.parameters);
  const LocalManifold local = local_manifold(*system.map, scene.saddle, ManifoldSide::unstable);
  GrowthOptions options;
  options.tolerance = scene.tolerance;
  options.iterates = scene.iterates;
  std::vector<double> times, loops;
  double points = 0, images = 0, steps = 0;
  for (auto _ : state) {
    const Stopwatch watch;
    const GrownManifold grown = with_threads(threads, [&] { return grow(*system.map, local, scene.branch, options); });
    times.push_back(watch.seconds());
    state.SetIterationTime(times.back());
    loops.push_back(with_threads(threads, [&] { return bare_loop(*system.map, local, grown, steps); }));
    points = static_cast<double>(grown.points.size());
    images = static_cast<double>(grown.images);
  }
  const double time = median(times);
  state.counters["points"] = points;
  state.counters["points_per_s"] = points / time;
  state.counters["images_per_s"] = images / time;
  state.counters["images_per_need"] = images / steps;
  state.counters["over_bare_loop"] = time / median(loops);
}

// All images of a circle from 1 to `iterates`.
void images(benchmark::State& state, const Scene& scene) {
  const auto threads = static_cast<int>(state.range(0));
  const System system = make_system(scene.system, scene.parameters);
  const CurveFunction circle = [&](std::span<const double> parameters, std::span<Point> points) {
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      points[k] = {scene.saddle.x + std::cos(parameters[k]), scene.saddle.y + std::sin(parameters[k])};
    }
  };
  const std::array<double, 2> corners{0, 2 * std::numbers::pi};
  ImageOptions options;
  options.tolerance = scene.tolerance;
  std::vector<double> times, loops;
  double size = 0, taken = 0, steps = 0;
  for (auto _ : state) {
    const Stopwatch watch;
    const auto found =
        with_threads(threads, [&] { return images_of(*system.map, 1, scene.iterates, circle, corners, options); });
    times.push_back(watch.seconds());
    state.SetIterationTime(times.back());
    size = steps = 0;
    taken = static_cast<double>(found.back().images);
    double loop = 0;
    for (const CurveImage& image : found) {
      Buffer<Point> points(image.points.size());
      const Stopwatch bare;
      with_threads(threads, [&] {
        for_each_block(points.size(), 512, [&](std::size_t first, std::size_t last) {
          const auto some = std::span(points).subspan(first, last - first);
          circle(std::span(image.parameters).subspan(first, last - first), some);
          system.map->iterate(some, image.iterate);
        });
      });
      loop += bare.seconds();
      benchmark::DoNotOptimize(points.data());
      size += static_cast<double>(points.size());
      steps += static_cast<double>(points.size()) * image.iterate;
    }
    loops.push_back(loop);
  }
  const double time = median(times);
  state.counters["points"] = size;
  state.counters["points_per_s"] = size / time;
  state.counters["images_per_s"] = taken / time;
  state.counters["images_per_need"] = taken / steps;
  state.counters["over_bare_loop"] = time / median(loops);
}

#define LOBER_IMAGES(name, ...) \
  BENCHMARK_CAPTURE(images, name, Scene{__VA_ARGS__})->Arg(1)->Arg(2)->UseManualTime()->Unit(benchmark::kMillisecond)

#define LOBER_GROWTH(name, ...) \
  BENCHMARK_CAPTURE(growth, name, Scene{__VA_ARGS__})->Arg(1)->Arg(2)->UseManualTime()->Unit(benchmark::kMillisecond)

LOBER_GROWTH(standard_map, "standard", {{"K", 1.2}}, {0, 0}, Branch::plus, 8, 1e-9);
LOBER_GROWTH(henon_map, "henon", {{"k", 0}}, {2, 2}, Branch::minus, 4, 1e-9);
LOBER_GROWTH(vortex_pair, "ovp", {{"gamma", 0.5}}, {1.45, 0}, Branch::minus, 4, 1e-6);
LOBER_GROWTH(vortex_pair_slow, "ovp", {{"gamma", 1.81}}, {1.567, 0}, Branch::minus, 2, 1e-4);

LOBER_IMAGES(standard_map, "standard", {{"K", 1.2}}, {3.14, 0}, Branch::plus, 14, 1e-9);
LOBER_IMAGES(henon_map, "henon", {{"k", 0}}, {0, 0}, Branch::plus, 5, 1e-9);
LOBER_IMAGES(vortex_pair, "ovp", {{"gamma", 0.5}}, {0, 2.5}, Branch::plus, 3, 1e-6);

}  // namespace
}  // namespace lober::detail

BENCHMARK_MAIN();

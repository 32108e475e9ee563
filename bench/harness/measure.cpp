#include "bench/harness/measure.hpp"

#include <algorithm>

#include "engine/base/parallel/parallel.hpp"

namespace lober::bench {
using namespace lober::detail;
namespace {

// Runs `job` once to warm caches and threads, then at least `repeat` times; short jobs until a second has
// passed.
template <typename Job>
void repeated(int repeat, const Job& job) {
  job();
  const Stopwatch watch;
  for (int run = 0; run < repeat || (watch.seconds() < 1 && run < 100); ++run) job();
}

double cross(Point a, Point b) {
  return a.x * b.y - b.x * a.y;
}

}  // namespace

double plain_area_sum(const Polygon& polygon) {
  const std::size_t size = polygon.size();
  double sum0 = cross(polygon[size - 1], polygon[0]);
  double sum1 = 0;
  double sum2 = 0;
  double sum3 = 0;
  std::size_t k = 0;
  for (; k + 4 < size; k += 4) {
    sum0 += cross(polygon[k], polygon[k + 1]);
    sum1 += cross(polygon[k + 1], polygon[k + 2]);
    sum2 += cross(polygon[k + 2], polygon[k + 3]);
    sum3 += cross(polygon[k + 3], polygon[k + 4]);
  }
  for (; k + 1 < size; ++k) sum0 += cross(polygon[k], polygon[k + 1]);
  return ((sum0 + sum1) + (sum2 + sum3)) / 2;
}

double floor_seconds(const Scene& scene) {
  std::vector<double> seconds;
  volatile double sink = 0;  // so that the sums are not optimised away
  repeated(31, [&] {
    const Stopwatch watch;
    sink = plain_area_sum(scene.first) + plain_area_sum(scene.second);
    seconds.push_back(watch.seconds());
  });
  (void)sink;
  return median_of(seconds);
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

OverlayRun overlay_once(const Scene& scene, int threads, Work work) {
  OverlayOptions options;
  options.pieces = work.pieces;
  options.check_simple = work.check_simple;
  options.index = work.index;
  return with_threads(threads, [&] {
    OverlayRun run;
    const Stopwatch watch;
    run.result = overlay(ClosedCurve::borrow(scene.first), ClosedCurve::borrow(scene.second), options);
    run.seconds = watch.seconds();
    return run;
  });
}

OverlayTimes time_overlay(const Scene& scene, int threads, Work work, int repeat) {
  struct Timed {
    double seconds;
    OverlayTiming phases;
  };
  std::vector<Timed> runs;
  OverlayTimes times;
  repeated(repeat, [&] {
    const OverlayRun run = overlay_once(scene, threads, work);
    runs.push_back({run.seconds, run.result.timing});
    if (runs.size() > 1) return;
    const Overlay& result = run.result;
    times.crossings = result.nodes.crossings();
    times.index = result.statistics.index;
    times.touches = result.nodes.touches();
    times.shared_arcs = result.nodes.shared_arcs();
    for (std::size_t k = 0; k < 4; ++k) times.pieces[k] = result.pieces(all_pairings[k]).size();
    times.areas = {result.areas.c1_minus_c2, result.areas.c2_minus_c1, result.areas.intersection, result.areas.union_};
  });
  runs.erase(runs.begin());  // the warm-up
  const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
  std::nth_element(runs.begin(), middle, runs.end(),
                   [](const Timed& a, const Timed& b) { return a.seconds < b.seconds; });
  times.seconds = middle->seconds;
  times.phases = middle->phases;
  return times;
}

}  // namespace lober::bench

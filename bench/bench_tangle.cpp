// The tangle of two manifolds of a million points each, in multiples of the bare search for crossings on the same
// curves (index, crossings, order along both). Every repetition times both, one after the other; what is reported is
// the median of the ratios. The proof that the manifolds do not cross themselves is timed apart.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/geometry/crossings/contacts.hpp"
#include "lober/tangle/tangle.hpp"

namespace lober::detail {
namespace {

struct ManifoldPair {
  std::vector<Point> u, s;
};

// Fingers on both sides of the x axis; those of S lean over those of U, by `lean` at their ends: lobe j meets lobes up
// to about j + lean.
ManifoldPair leaning_fingers(std::size_t lobes, std::size_t points, double lean) {
  ManifoldPair pair{{{-0.5, -30}}, {}};
  for (std::size_t k = 0; k < points; ++k) {
    const double x = -0.5 + static_cast<double>(k) * static_cast<double>(lobes + 1) / static_cast<double>(points - 1);
    const double y = std::sin(std::numbers::pi * x);
    pair.u.push_back({x, y});
    pair.s.push_back({x + lean * y * y, -y});
  }
  pair.s.push_back({pair.s.back().x, -30});
  std::reverse(pair.s.begin(), pair.s.end());
  return pair;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

void whole_job(benchmark::State& state, std::size_t lobes, double lean) {
  const ManifoldPair pair = leaning_fingers(lobes, 1'000'000, lean);
  const CurveView u{pair.u, false}, s{pair.s, false};
  std::vector<double> total, with_overlaps, overlaps_alone, shapes_alone, check_alone;
  std::size_t crossings = 0, overlap_count = 0;
  with_threads(1, [&] {
    for (auto _ : state) {
      Stopwatch watch;
      {
        const IndexedCurve first(u), second(s);
        benchmark::DoNotOptimize(find_contacts(first, second, choose_index(first, second)).list.size());
      }
      const double bare = watch.seconds();
      TangleOptions options;
      options.check_simple = false;
      Stopwatch whole;
      const Tangle found = tangle(OpenCurve::borrow(pair.u), OpenCurve::borrow(pair.s), options);
      const double job = whole.seconds();
      Stopwatch more;
      overlap_count = overlaps(found).size();
      const double common = more.seconds();
      Stopwatch yet_more;
      benchmark::DoNotOptimize(lobe_shapes(found).data());
      const double shapes = yet_more.seconds();
      Stopwatch check;
      benchmark::DoNotOptimize(require_simple(IndexedCurve(u), 1).pairs);
      benchmark::DoNotOptimize(require_simple(IndexedCurve(s), 2).pairs);
      check_alone.push_back(check.seconds() / bare);
      total.push_back(job / bare);
      overlaps_alone.push_back(common / bare);
      shapes_alone.push_back(shapes / bare);
      crossings = found.nodes.crossings();
    }
    return 0;
  });
  state.counters["crossings"] = static_cast<double>(crossings);
  state.counters["overlaps"] = static_cast<double>(overlap_count);
  state.counters["tangle/search"] = median(total);
  state.counters["overlaps/search"] = median(overlaps_alone);
  state.counters["shapes/search"] = median(shapes_alone);
  state.counters["simple/search"] = median(check_alone);
}

void few_crossings(benchmark::State& state) {
  whole_job(state, 20, 5);
}
void two_hundred_lobes(benchmark::State& state) {
  whole_job(state, 200, 250);
}
void thousands_of_lobes(benchmark::State& state) {
  whole_job(state, 5000, 20);
}
BENCHMARK(few_crossings)->Unit(benchmark::kMillisecond)->Iterations(15);
BENCHMARK(two_hundred_lobes)->Unit(benchmark::kMillisecond)->Iterations(15);
BENCHMARK(thousands_of_lobes)->Unit(benchmark::kMillisecond)->Iterations(15);

}  // namespace
}  // namespace lober::detail

BENCHMARK_MAIN();

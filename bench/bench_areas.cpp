// The other ways to areas, on every scene, in multiples of the overlay and its search: the interior function, smooth
// curves, regions of curves that may cross themselves. All of a scene are timed in turns, so that other work on the
// machine meets them alike.
//
// usage: bench_areas [POINTS [SCENE...]]      prints Markdown; 10^6 points a curve unless told
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "bench/harness/measure.hpp"
#include "bench/harness/program.hpp"
#include "bench/harness/table.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/regions.hpp"
#include "lober/overlay/smooth.hpp"

namespace lober::bench {
namespace {

constexpr int rounds = 9;

struct Times {
  std::vector<double> overlay, search, interior, smooth, regions;  // seconds, round by round
};

template <typename Job>
double seconds_of(const Job& job) {
  const Stopwatch watch;
  job();
  return watch.seconds();
}

double ratio(const std::vector<double>& of, const std::vector<double>& to) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < of.size(); ++k) ratios.push_back(of[k] / to[k]);
  return median_of(ratios);
}

// One thread. Scenes are simple curves, which the overlay does not have to prove; regions look for crossings of each
// curve with itself in any case, so their search is the one with that proof.
Times time_scene(const Scene& scene) {
  const ClosedCurve c1 = ClosedCurve::borrow(scene.first), c2 = ClosedCurve::borrow(scene.second);
  Times times;
  for (int round = 0; round <= rounds; ++round) {
    const OverlayRun plain = overlay_once(scene, 1, {});
    const OverlayTiming checked = overlay_once(scene, 1, {.check_simple = true}).result.timing;
    const auto interior = [&] { (void)interior_areas(c1, c2, {.check_simple = false}); };
    const double interior_seconds = with_threads(1, [&] { return seconds_of(interior); });
    const double smooth_seconds =
        with_threads(1, [&] { return seconds_of([&] { (void)smooth_areas(plain.result); }); });
    const double regions_seconds = with_threads(1, [&] { return seconds_of([&] { (void)regions(c1, c2); }); });
    if (round == 0) continue;  // it warms caches
    times.overlay.push_back(plain.seconds);
    times.search.push_back(checked.index + checked.check + checked.crossings + checked.order);
    times.interior.push_back(interior_seconds);
    times.smooth.push_back(smooth_seconds);
    times.regions.push_back(regions_seconds);
  }
  return times;
}

int run(int count, char** arguments) {
  const std::size_t points = count > 1 ? std::stoul(arguments[1]) : 1'000'000;
  std::vector<const SceneKind*> wanted;
  for (int k = 2; k < count; ++k) {
    wanted.push_back(find_scene(arguments[k]));
    if (wanted.back() == nullptr) throw std::invalid_argument("no scene has the name " + std::string(arguments[k]));
  }
  if (wanted.empty()) {
    for (const SceneKind& kind : scenes()) wanted.push_back(&kind);
  }
  std::cout << points << " + " << points << " points, one thread, curves in memory; medians of " << rounds
            << " rounds, times in ms. `x overlay`: the interior function against the overlay with its pieces. `ns a "
               "segment`: the "
               "smooth areas of an overlay that is there. `x search`: regions against index, proofs and crossings of "
               "the overlay.\n\n";
  Table table({"scene", "overlay", "interior", "x overlay", "smooth", "ns a segment", "search", "regions", "x search"});
  for (const SceneKind* kind : wanted) {
    std::cerr << kind->name << " ..." << std::endl;
    const Times times = time_scene(kind->make(points));
    const double smooth = median_of(times.smooth);
    table.add({std::string(kind->name), milliseconds(median_of(times.overlay)), milliseconds(median_of(times.interior)),
               digits3(ratio(times.interior, times.overlay)), milliseconds(smooth),
               digits3(1e9 * smooth / (2 * static_cast<double>(points))), milliseconds(median_of(times.search)),
               milliseconds(median_of(times.regions)), digits3(ratio(times.regions, times.search))});
  }
  std::cout << table << std::endl;
  return 0;
}

}  // namespace
}  // namespace lober::bench

int main(int count, char** arguments) {
  return lober::bench::exit_status("bench_areas", [&] { return lober::bench::run(count, arguments); });
}

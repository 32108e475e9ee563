// Timing the engine and the floor that it is measured against.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "bench/scenes/scenes.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/overlay/overlay.hpp"

namespace lober::bench {
using namespace lober::detail;

/// Medians are over at least `repeat` runs; short jobs run until a second has passed, at most 100 times. A
/// first run, which warms caches and threads, does not count.
[[nodiscard]] double median_of(std::vector<double> values);

/// Both curves' plain shoelace sums: one multiplication pair a segment, four independent sums, no error
/// control. The cost of reading the points once.
[[nodiscard]] double plain_area_sum(const Polygon& polygon);
[[nodiscard]] double floor_seconds(const Scene& scene);

struct OverlayRun {
  Overlay result;
  double seconds = 0;
};

/// The parts of the engine's work that are asked for, besides totals.
struct Work {
  bool pieces = true;
  bool check_simple = false;
  IndexKind index = IndexKind::automatic;
};

/// Index, crossings, order, areas (and pieces) of curves in memory on that many threads.
[[nodiscard]] OverlayRun overlay_once(const Scene& scene, int threads, Work work);

struct OverlayTimes {
  double seconds = 0;    ///< median
  OverlayTiming phases;  ///< of the run in the middle
  std::size_t crossings = 0, touches = 0, shared_arcs = 0;
  IndexKind index = IndexKind::automatic;  ///< the one that was used
  std::array<std::size_t, 4> pieces{};
  std::array<double, 4> areas{};
};

[[nodiscard]] OverlayTimes time_overlay(const Scene& scene, int threads, Work work, int repeat);

}  // namespace lober::bench

// Polygons as runs of points of curves that are in the page anyway: the boundary of a lobe costs a few numbers, however
// many points it has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lober/curve/point.hpp"

namespace lober::viewer {

/// Points `first` to `last` of a curve, both included, in either direction.
struct Run {
  std::uint32_t curve, first, last;
};

/// Finds points in curves by their coordinates, bit for bit.
class RunFinder {
 public:
  /// The curves stay alive. O(their points), in time and memory (about 8 bytes a point).
  explicit RunFinder(std::vector<std::span<const Point>> curves);

  /// The runs of a polygon, in its order. Points of no curve are appended to `pool`, which counts as the curve after
  /// the last one. O(its points).
  [[nodiscard]] std::vector<Run> runs(std::span<const Point> polygon, std::vector<Point>& pool) const;

 private:
  struct Location {
    std::uint32_t curve, point;
  };
  template <typename Accepts>
  [[nodiscard]] bool find(Point point, const Accepts& accepts, Location& found) const;
  [[nodiscard]] Location location(std::uint32_t number) const;

  std::vector<std::span<const Point>> curves_;
  std::vector<std::uint32_t> begins_;  // number of the first point of each curve, counted over all of them
  std::vector<std::uint32_t> slots_;   // numbers + 1 of points by hash; 0: free
  std::uint64_t mask_ = 0;
};

}  // namespace lober::viewer

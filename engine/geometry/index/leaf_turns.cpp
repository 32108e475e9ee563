#include "engine/geometry/index/leaf_turns.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "kernels/bent_slab.hpp"
#include "kernels/segment_boxes.hpp"

namespace lober::detail {
namespace {

// How the segments of a leaf go along an axis.
struct Ways {
  std::uint32_t rises = 0, falls = 0;
  // How many from segment `begin` on go the same way.
  [[nodiscard]] std::uint32_t run_from(std::uint32_t begin) const {
    return static_cast<std::uint32_t>(std::max(std::countr_one(rises >> begin), std::countr_one(falls >> begin)));
  }
};
Ways ways_along(const Point* points, double Point::*axis) {
  Ways ways;
  for (std::size_t k = 0; k < leaf_size; ++k) {
    const double from = points[k].*axis, to = points[k + 1].*axis;
    ways.rises |= static_cast<std::uint32_t>(from < to) << k;
    ways.falls |= static_cast<std::uint32_t>(from > to) << k;
  }
  return ways;
}

}  // namespace

std::uint32_t segments_meeting_earlier(const Point* points, const Box& box) {
  const Ways ways = ways_along(points, box.width() < box.height() ? &Point::y : &Point::x);
  const std::uint32_t first = ways.run_from(0);  // within a run nothing meets
  if (first == leaf_size) return 0;
  const std::uint32_t later = all_segments << first;
  if (first == 0 || first + ways.run_from(first) < leaf_size) return later;
  // Two runs: of the second what lies beside the first is apart from it.
  std::array<Point, leaf_size + 1> run;
  std::fill(std::copy_n(points, first, run.begin()), run.end(), points[first]);
  BentSlab slab;
  bent_slab(run.data(), slab);
  return later & segments_meeting(slab, points);
}

}  // namespace lober::detail

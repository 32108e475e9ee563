#include "engine/geometry/index/raster.hpp"

#include <limits>

#include "engine/geometry/index/block_search.hpp"

namespace lober::detail {
namespace {

// The part of [low, high] inside [from, to], relative to the latter.
double share(double low, double high, double from, double to) {
  const double extent = to - from;
  return Raster::usable(extent) ? (std::min(high, to) - std::max(low, from)) / extent : 0;
}

}  // namespace

std::uint64_t max_grid_entries(std::size_t segments) {
  return std::min<std::uint64_t>(8 * std::uint64_t{segments} + (1U << 20U), std::numeric_limits<std::uint32_t>::max());
}

Raster Raster::fitted(const BoxTree& tree, const Box& window, std::uint64_t max_entries, std::size_t sample) {
  const std::size_t leaves = tree.leaves(), looked_at = std::min(leaves, sample);
  double segments = 0, across = 0,
         along = 0;  // how many, and their widths and heights in those of the window
  for (std::size_t k = 0; k < looked_at; ++k) {
    const std::size_t leaf = k * leaves / looked_at;
    for_each_segment_of_leaf(tree, leaf, window, [&](std::uint32_t, const Segment& ends) {
      const Box box = Box::of(ends.a, ends.b);
      segments += 1;
      across += share(box.min_x(), box.max_x(), window.min_x(), window.max_x());
      along += share(box.min_y(), box.max_y(), window.min_y(), window.max_y());
    });
  }
  const double factor = static_cast<double>(leaves) / static_cast<double>(looked_at);
  segments *= factor;
  // A grid of c x r cells has about segments + across c + along r entries; for c r fixed they are fewest when
  // both terms are equal. Two entries per cell: 2 c r = segments + 2 sqrt(across along c r).
  const double x = std::max(across * factor, 1.0), y = std::max(along * factor, 1.0);
  const double mean = std::sqrt(x * y);
  const double two_per_cell = (mean + std::sqrt(mean * mean + 2 * segments)) / 2;  // the square root of c r
  const double affordable = std::max(static_cast<double>(max_entries) - segments, 0.0) / (2 * mean);
  const double side = std::min({two_per_cell, affordable, 0x1p15});
  const double cells = std::max(side * side, 1.0);
  const double columns = std::clamp(side * std::sqrt(y / x), 1.0, cells);
  return {window, static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(cells / columns)};
}

}  // namespace lober::detail

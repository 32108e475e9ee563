// Shoelace sums along a curve, from its first vertex to any number of positions on it.
//
// The leaves of the box tree bring their sums along, so only leaves that hold a position are read again.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/unfilled.hpp"
#include "engine/geometry/index/box_tree.hpp"
#include "kernels/shoelace.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

/// A position on a curve with its parameter in full.
struct PrecisePosition {
  std::uint32_t segment;
  DD t;
};

struct SumAlong {
  DD total;            ///< sum of the whole curve: if it is closed, twice its signed area
  double largest = 0;  ///< the largest |sum| at every 1024th vertex: roundings are relative to it
};

/// Bound on what double-double loses in twice an area made of such sums in a scene of this extent (Box::extent): the
/// gap at each of the nodes where curves meet (crossing_parameters.hpp) times the extent, and the additions of
/// RunningSum.
[[nodiscard]] inline double lost_in_sums(double extent, std::size_t nodes, std::size_t segments) {
  const double additions = static_cast<double>(segments) / 1024 + 4096;
  return extent * extent * (static_cast<double>(nodes) * 0x1p-91 + additions * 0x1p-104);
}

/// Calls take(k, sum) for each k < count, in parallel, with the sum of cross(v_i - o, v_{i+1} - o) up to position(k),
/// the PrecisePosition number k; positions come in order along the curve. A position inside a segment counts t times
/// the term of the segment. O(count + leaves that hold a position + n / 1024).
template <typename PositionAt, typename Take>
SumAlong sum_along(const BoxTree& tree, Point origin, std::size_t count, const PositionAt& position, const Take& take) {
  SumAlong result;
  const Buffer<DD>& chunks = tree.chunk_sums();
  Buffer<DD> before(chunks.size());
  for (std::size_t k = 0; k < chunks.size(); ++k) {
    before[k] = result.total;
    result.largest = std::max(result.largest, std::fabs(result.total.hi));
    result.total += chunks[k];
    result.total += shoelace(*tree.chunk_points(k), *tree.chunk_points(k + 1), origin);
  }
  if (count == 0) return result;

  // The first position of a chunk, by bisection.
  const auto first_from = [&](std::size_t chunk) {
    std::size_t low = 0, high = count;
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (position(middle).segment < chunk * leaf_size * leaf_size)
        low = middle + 1;
      else
        high = middle;
    }
    return low;
  };
  // Leaves with positions lie anywhere in memory; those of some positions further on are asked for in time.
  constexpr std::uint32_t nowhere = 0xffffffff;
  constexpr std::size_t batch = 64, ahead = 6, points_per_line = 64 / sizeof(Point);
  const auto fetch = [](const Point* leaf) {
    for (std::size_t k = 0; k < leaf_size; k += points_per_line) __builtin_prefetch(leaf + k);
  };
  for_each_block(chunks.size(), 4, [&](std::size_t first_chunk, std::size_t last_chunk) {
    LeafPrefixes leaves, prefixes;
    std::array<std::uint32_t, batch> segments;  // segments of positions on one leaf
    Unfilled<DD, batch> t, sums;
    std::size_t k = first_from(first_chunk);
    for (std::size_t chunk = first_chunk; chunk < last_chunk && k < count; ++chunk) {
      std::uint32_t segment = position(k).segment;
      if (segment / leaf_size / leaf_size != chunk) continue;
      shoelace_prefixes(tree.chunk_points(chunk), origin, before[chunk], tree.leaf_sums() + chunk * leaf_size, leaves);
      while (segment / leaf_size / leaf_size == chunk) {
        const std::size_t leaf = segment / leaf_size;
        if (k + ahead < count) fetch(tree.leaf_points(position(k + ahead).segment / leaf_size));
        shoelace_prefixes(tree.leaf_points(leaf), origin, leaves.before(leaf % leaf_size), nullptr, prefixes);
        while (segment / leaf_size == leaf) {
          const std::size_t first = k;
          std::size_t filled = 0;
          do {
            segments[filled] = segment;
            t[filled++] = position(k).t;
            segment = ++k < count ? position(k).segment : nowhere;
          } while (segment / leaf_size == leaf && filled < batch);
          sums_at(prefixes, segments.data(), t.data(), filled, sums.data());
          for (std::size_t i = 0; i < filled; ++i) take(first + i, sums[i]);
        }
      }
    }
  });
  return result;
}

}  // namespace lober::detail

// Shoelace sums along a curve, from its first vertex to any number of places on it.
//
// The leaves of the box tree bring their sums along, so only leaves that hold a place are read again.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engine/index/box_tree.hpp"
#include "engine/memory.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/shoelace.hpp"

namespace lober {

/// A place on a curve with its parameter in full.
struct PlaceAlong {
  std::uint32_t segment;
  DD t;
};

struct SumsAlong {
  Buffer<DD> at;       ///< at each place: the sum of cross(v_i - o, v_{i+1} - o) up to it
  DD total;            ///< of the whole curve: if it is closed, twice its signed area
  double largest = 0;  ///< of the sums at every 1024th vertex, in size: what roundings are relative to
};

/// place(k), k < count, gives the PlaceAlong number k; places come in order along the curve. A place inside a segment
/// counts t times the term of the segment. O(count + leaves that hold a place + n / 1024), parallel.
template <typename PlaceAt>
[[nodiscard]] SumsAlong sums_along(const BoxTree& tree, Point origin, std::size_t count, const PlaceAt& place) {
  SumsAlong result;
  const Buffer<DD>& stretches = tree.stretch_sums();
  const std::size_t leaves = tree.leaves();
  Buffer<DD> before(stretches.size());
  DD sum;
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    before[k] = sum;
    result.largest = std::max(result.largest, std::fabs(sum.hi));
    sum += stretches[k];
    sum += shoelace(tree.leaf_begin(k * leaf_size), tree.leaf_begin(std::min((k + 1) * leaf_size, leaves)), origin);
  }
  result.total = sum;
  result.at.resize(count);
  if (count == 0) return result;
  for_each_block(stretches.size(), 4, [&](std::size_t first_stretch, std::size_t last_stretch) {
    std::array<DD, leaf_size> terms;
    // The first place of the stretch, by bisection.
    const auto first_at = [&](std::size_t begin_segment) {
      std::size_t low = 0, high = count;
      while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (place(middle).segment < begin_segment)
          low = middle + 1;
        else
          high = middle;
      }
      return low;
    };
    std::size_t k = first_at(first_stretch * leaf_size * leaf_size);
    for (std::size_t stretch = first_stretch; stretch < last_stretch; ++stretch) {
      RunningSum running;
      running.add(before[stretch]);
      const std::size_t leaf_end = std::min((stretch + 1) * leaf_size, leaves);
      for (std::size_t leaf = stretch * leaf_size; leaf < leaf_end; ++leaf) {
        if (k == count) return;
        if (place(k).segment >= leaf_end * leaf_size) break;  // nothing more in this stretch
        if (place(k).segment >= (leaf + 1) * leaf_size) {
          running.add(tree.leaf_sums()[leaf]);
          running.add(shoelace(tree.leaf_begin(leaf), tree.leaf_begin(leaf + 1), origin));
          continue;
        }
        shoelace_terms(tree.leaf_points(leaf), origin, terms.data());
        for (std::size_t i = 0; i < leaf_size; ++i) {
          for (; k < count && place(k).segment == leaf * leaf_size + i; ++k) {
            result.at[k] = running.value() + place(k).t * terms[i];
          }
          running.add(terms[i]);
        }
      }
    }
  });
  return result;
}

}  // namespace lober

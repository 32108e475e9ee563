// The boxes of many curves, to find those that meet a given one (private to overlay/).
//
// A packed tree: boxes in the order of a Hilbert curve through their centres, boxes over consecutive ones, and so on
// (Kamel & Faloutsos 1993, doi:10.1145/170088.170403).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/box.hpp"

namespace lober::detail {

class BoxSet {
 public:
  /// Fewer than 2^32 boxes; an empty one meets none. O(n log n).
  explicit BoxSet(std::span<const Box> boxes);

  /// Appends the numbers of all boxes that meet the query, in no order. Safe for several threads.
  void find(const Box& query, std::vector<std::uint32_t>& found) const;

 private:
  static constexpr std::size_t fan_out = 16;
  void descend(const Box& query, std::size_t level, std::size_t node, std::vector<std::uint32_t>& found) const;

  std::vector<std::uint32_t> numbers_;    ///< in the order of the curve
  std::vector<std::vector<Box>> levels_;  ///< the first one: boxes in that order
};

}  // namespace lober::detail

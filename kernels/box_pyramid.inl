// Body of pairs_below_first and pairs_below_second for boxes (kernels/all.inl).
#pragma once

#include "kernels/box_pyramid.hpp"
#include "kernels/pair_lanes.inl"

namespace lober::detail {
namespace {

// Four boxes and one, for split_pairs.
struct BoxPairs {
  using Level = BoxLevel;
  Lanes four[lanes];
  const double* one;
  bool second_is_one;
  LOBER_INLINE void load_four(const Box* boxes) {
    for (std::size_t k = 0; k < lanes; ++k) four[k] = load(boxes[k].lane);
    transpose(four);
  }
  LOBER_INLINE void first_by_four(Level first, Level second, NodePair pair) {
    load_four(first.boxes + 4 * std::size_t{pair.first});
    one = second.boxes[pair.second].lane;
    second_is_one = true;
  }
  LOBER_INLINE void second_by_four(Level first, Level second, NodePair pair) {
    load_four(second.boxes + 4 * std::size_t{pair.second});
    one = first.boxes[pair.first].lane;
    second_is_one = false;
  }
  LOBER_INLINE unsigned meet() const {
    return mask_bits((four[0] <= splat(-one[2])) & (four[1] <= splat(-one[3])) & (four[2] <= splat(-one[0])) &
                     (four[3] <= splat(-one[1])));
  }
  LOBER_INLINE unsigned second_is_small() const {
    // Extents with their signs changed.
    const Lanes of_four = (four[0] + four[2]) + (four[1] + four[3]);
    const Lanes of_one = splat((one[0] + one[2]) + (one[1] + one[3]));
    return mask_bits(second_is_one ? of_one >= of_four : of_four >= of_one);
  }
};

}  // namespace
}  // namespace lober::detail

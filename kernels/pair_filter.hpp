// The first look at candidate pairs of segments: several at a time, in floating point, with a proof or none.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/point.hpp"
#include "kernels/segment_boxes.hpp"

namespace lober::detail {

enum class PairVerdict : std::uint8_t {
  apart,            ///< the segments have no common point
  crosses_to_left,  ///< they cross properly, the second one from right to left of the first
  crosses_to_right,
  uncertain,  ///< some orientation is zero or too near to it to tell: ask the exact predicates
};

/// One of the curves: segment k joins points[k] and points[k + 1]; segments from `first_wrapped` on do not, and are
/// always uncertain.
struct SegmentSource {
  const Point* points;
  std::uint32_t first_wrapped;
};

/// The verdicts of `count` pairs. A verdict other than `uncertain` is right for all finite coordinates: each of the
/// four orientations is compared with the error bound of orient2d.
void filter_pairs(SegmentSource first, SegmentSource second, const SegmentPair* pairs, std::size_t count,
                  PairVerdict* verdicts);

}  // namespace lober::detail

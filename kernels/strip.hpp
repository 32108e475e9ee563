// Strips along parabolas: what tells folds apart that run side by side and turn.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/box_pyramid.hpp"
#include "kernels/point.hpp"

namespace lober::detail {

/// The points with |u| <= length and |v - bend u^2| <= width, where u and v are measured from `middle` along `along`
/// and to the left of it. `along` has length 1, but for rounding, |v| <= reach, and |bend| length < 1. `length`,
/// `width` and `reach` contain what rounding may do to all functions here: 2^-45 of the coordinates of `middle` and of
/// the sizes. One whose numbers are not finite stands for the whole plane.
struct Strip {
  Point middle;
  Point along;
  double length, width, bend, reach;
  using LeftUnfilled = void;  ///< in arrays (lober/base/buffer.hpp)
};

/// Fills `strip` with one that holds the segments between the leaf_size + 1 points of a leaf, along the parabola
/// through its ends and its middle. A leaf that is folded in two lies in one along both halves.
void leaf_strip(const Point* points, Strip& strip);

/// Fills above[k] with a strip that holds what below[2 k] and below[2 k + 1] hold, whatever lies between the two on the
/// curve, for k < `count`. Along both: the parabola whose slopes at both middles are those of the strips, for strips
/// side by side their mean, or straight where that is narrower.
void join_strips(const Strip* below, std::size_t count, Strip* above);

/// Keeps those of the `count` pairs whose strips, by their numbers in `first` and `second`, may meet, in order; returns
/// how many. One goes only if it is certain that a strip lies beside the parabola of the other one as far as that goes.
std::size_t keep_near(const Strip* first, const Strip* second, NodePair* pairs, std::size_t count);

}  // namespace lober::detail

// Heights across folds that run side by side: what tells pieces of one curve apart in a window.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/box.hpp"
#include "kernels/point.hpp"

namespace lober::detail {

/// With u along `along` and v to the left of it, measured from `at`, the height of a point is
///   v + u (slope + bend u + shear v) + bow v^2,
/// a function whose level lines follow folds, be they bent or spread out. `along` has length 1, but for rounding, and
/// |slope| <= 4.
struct FoldChart {
  Point at;
  Point along;
  double slope = 0, bend = 0, shear = 0, bow = 0;
};

/// The segments of a leaf that reach into a window: bounds of their heights and of their u, whatever rounding does;
/// infinite where it may do anything.
struct ChartedLeaf {
  double low, high;
  double left, right;
  bool is_inside;     ///< some segment may reach into the window; else there are no bounds
  bool rises, falls;  ///< u grows, or shrinks, strictly along *all* segments of the leaf
};

/// Measures the segments between the leaf_size + 1 points of a leaf whose boxes meet the window, which takes in its
/// edges; `box` is that of the leaf. Coordinates must be finite.
void chart_leaf(const Point* points, const Box& box, const Box& window, const FoldChart& chart, ChartedLeaf& charted);

}  // namespace lober::detail

// Boxes about the arcs of a smooth curve (private to smooth/).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/geometry/smooth/smooth_curve.hpp"
#include "kernels/box.hpp"
#include "kernels/box_pyramid.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

/// Arcs lie no farther than `width` from the chord between their ends.
struct ArcStrip {
  Point from, to;
  double width;
  using LeftUnfilled = void;  ///< in arrays
};

/// A binary tree of boxes about the arcs of a closed curve, whose leaves are 16 arcs each.
class ArcBoxes {
 public:
  static constexpr std::size_t segments_a_leaf = 16;

  /// No boxes yet: a pass that reads the points anyway calls add() for all of them, then join().
  explicit ArcBoxes(const SmoothCurve& curve);
  /// The leaves of the segments from `begin`, the first of a leaf, to `end`, the first of another one or that of the
  /// curve, with the errors of their areas (SmoothSegment::error): an arc may lie as far beside where it is fitted as
  /// its error allows. Where `errors` is null, leaves of few points and of corners fit their arcs for that. Any thread
  /// may call it, for leaves of its own. 2 ns a segment whose points are in the cache.
  void add(std::size_t begin, std::size_t end, const double* errors);
  /// The boxes above leaves. O(n / 16).
  void join();
  /// Both for all segments, in parallel.
  void add_all();

  [[nodiscard]] std::uint32_t levels() const { return levels_; }
  [[nodiscard]] std::uint32_t nodes(std::uint32_t level) const { return size_[level]; }
  [[nodiscard]] const Box& box(TreeNode node) const { return boxes_[begin_[node.level] + node.index]; }
  /// The boxes of a level; none above the root.
  [[nodiscard]] BoxLevel level(std::uint32_t level) const {
    if (level >= levels_) return {};
    return {&boxes_[begin_[level]], size_[level]};
  }
  [[nodiscard]] const ArcStrip& strip(std::size_t leaf) const { return strips_[leaf]; }
  /// How far arcs of a leaf lie from their segments at most, where they are fitted or as far beside as they may be
  /// wrong.
  [[nodiscard]] double bend(std::size_t leaf) const { return bends_[leaf]; }
  [[nodiscard]] std::size_t end(std::size_t leaf) const { return std::min((leaf + 1) * segments_a_leaf, segments_); }

 private:
  [[nodiscard]] double error_of_leaf(std::size_t leaf, const Point* window) const;

  const SmoothCurve* curve_;
  std::size_t segments_;
  std::uint32_t levels_ = 1;
  std::array<std::uint32_t, 32> size_{}, begin_{};
  Buffer<Box> boxes_;
  Buffer<ArcStrip> strips_;
  Buffer<double> bends_;
};

}  // namespace lober::detail

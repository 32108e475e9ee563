// The curve-order box tree: boxes over consecutive segments, over consecutive boxes, and so on.
//
// The points of a curve come in order, so no sorting is needed: the tree is built in one pass over contiguous memory,
// and everything else that only that pass can give cheaply (shoelace sums, monotone runs) is taken along.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/geometry/index/kept_sums.hpp"
#include "kernels/box_pyramid.hpp"
#include "kernels/frame_filter.hpp"
#include "kernels/leaf.hpp"
#include "lober/base/buffer.hpp"
#include "lober/curve/curve.hpp"

namespace lober::detail {

class NodeFrames;

class BoxTree {
 public:
  /// Builds the tree of a curve that stays alive as long as the tree does. O(N), parallel; about 2 bytes per
  /// point, see kept_sums(). The curve is not validated: NaN coordinates give a useless tree, no fault.
  explicit BoxTree(CurveView curve);
  ~BoxTree();
  BoxTree(const BoxTree&) = delete;
  BoxTree& operator=(const BoxTree&) = delete;

  [[nodiscard]] const CurveView& curve() const { return curve_; }
  [[nodiscard]] std::size_t segments() const { return curve_.segments(); }
  [[nodiscard]] std::size_t leaves() const { return level_size_[0]; }
  [[nodiscard]] std::uint32_t levels() const { return levels_; }
  [[nodiscard]] std::uint32_t nodes(std::uint32_t level) const { return level_size_[level]; }
  [[nodiscard]] TreeNode root() const { return {levels_ - 1, 0}; }
  [[nodiscard]] const Box& box(TreeNode node) const { return boxes_[level_begin_[node.level] + node.index]; }
  [[nodiscard]] BoxPyramid pyramid() const { return {boxes_.data(), level_begin_.data(), level_size_.data()}; }
  /// The tree, for searches of what its curve has in common with itself.
  [[nodiscard]] SelfTree as_self() const { return {pyramid(), flags_.data(), curve_.closed}; }
  [[nodiscard]] const Box& box() const { return box(root()); }
  /// The boxes of a level; none above the root.
  [[nodiscard]] BoxLevel level(std::uint32_t level) const {
    if (level >= levels_) return {};
    return {&boxes_[level_begin_[level]], level_size_[level]};
  }
  /// Whether the curve stays in one point for so long that whole leaves do. Searches leave these out: each would meet
  /// each, and there is nothing to find.
  [[nodiscard]] bool stalls() const { return stalls_; }
  /// MonotoneFlags of the whole node.
  [[nodiscard]] std::uint8_t flags(TreeNode node) const { return flags_[level_begin_[node.level] + node.index]; }
  [[nodiscard]] const Box* leaf_boxes() const { return boxes_.data(); }
  /// Shoelace sums of the leaves, see summarise_leaves.
  /// A whole number of chunks of them: behind the last leaf they are zero.
  [[nodiscard]] const DD* leaf_sums() const { return sums_.data(); }
  /// Shoelace sums of chunks of leaf_size leaves, each about its first point (the last one may be shorter).
  [[nodiscard]] const Buffer<DD>& chunk_sums() const { return chunk_sums_; }
  /// False when the shoelace sums came out infinite or not a number: then some coordinate is not finite, or so large
  /// that products overflow. A curve with a bad coordinate never passes. O(N / 1024).
  [[nodiscard]] bool sums_finite() const;
  /// Where leaf `leaf` begins; leaves() is allowed and means the end of the curve (the first point again, if closed).
  [[nodiscard]] Point leaf_begin(std::size_t leaf) const { return starts_[leaf]; }
  /// leaf_begin of the leaf_size leaves of a chunk and of the next one; behind the end of the curve its last point.
  [[nodiscard]] const Point* chunk_points(std::size_t chunk) const { return &starts_[chunk * leaf_size]; }
  /// leaf_size + 1 points of a leaf; behind the end of the curve its last point is repeated.
  [[nodiscard]] const Point* leaf_points(std::size_t leaf) const {
    return leaf + 1 == leaves() ? tail_.data() : curve_.points.data() + leaf * leaf_size;
  }
  /// Asks for these points ahead of their use, where leaves are read here and there in memory.
  void prefetch_leaf(std::size_t leaf) const {
    constexpr std::size_t line = 64;
    const Point* const points = leaf_points(leaf);
    for (std::size_t i = 0; i <= leaf_size; i += line / sizeof(Point)) __builtin_prefetch(points + i);
  }
  /// The sums of a short curve that has been used several times; null until then, and of a long one always. Any thread
  /// may call it.
  [[nodiscard]] const KeptSums* kept_sums() const;
  /// The frames of its nodes; null until somebody has asked for them by make_frames. Any thread may call both.
  [[nodiscard]] const NodeFrames* frames() const { return frames_.load(std::memory_order_acquire); }
  const NodeFrames& make_frames() const;
  /// Bytes held besides the curve, kept sums and, of long curves, frames included, be they there yet or not.
  [[nodiscard]] std::size_t memory() const;

 private:
  void sum_chunks(std::size_t begin, std::size_t end);
  void build_upper(std::uint32_t level, std::size_t begin, std::size_t end);
  [[nodiscard]] bool stalls_between(std::size_t begin, std::size_t end) const;

  CurveView curve_;
  bool stalls_ = false;
  std::uint32_t levels_ = 0;
  std::array<std::uint32_t, 32> level_size_{};
  std::array<std::uint32_t, 32> level_begin_{};
  Buffer<Box> boxes_;
  Buffer<std::uint8_t> flags_;
  Buffer<DD> sums_;
  Buffer<DD> chunk_sums_;
  Buffer<Point> starts_;
  std::array<Point, leaf_size + 1> tail_{};
  mutable std::atomic<const KeptSums*> kept_sums_{nullptr};
  mutable std::atomic<const NodeFrames*> frames_{nullptr};
  mutable std::atomic<std::uint32_t> uses_{0};
};

}  // namespace lober::detail

// Boxes about the arcs of a smooth curve (private to smooth/).
#pragma once

#include <cstddef>
#include <vector>

#include "engine/geometry/smooth/smooth_curve.hpp"
#include "kernels/box.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

/// Arcs lie no farther than `width` from the chord between their ends.
struct ArcStrip {
  Point from, to;
  double width;
};

/// Boxes and strips of leaves of 16 arcs of a closed curve, of four leaves, of four of these, and so on up to one.
class ArcBoxes {
 public:
  static constexpr std::size_t segments_a_leaf = 16, children = 4;

  /// No boxes yet: a pass that reads the points anyway calls add() for all of them, then join().
  explicit ArcBoxes(const SmoothCurve& curve);
  /// The leaves of the segments from `begin`, the first of a leaf, to `end`, the first of another one or that of the
  /// curve. Any thread may call it, for leaves of its own. 2 ns a segment whose points are in the cache.
  void add(std::size_t begin, std::size_t end);
  /// The boxes and strips of leaves together. O(n / 16).
  void join();

  [[nodiscard]] std::size_t levels() const { return levels_.size(); }
  [[nodiscard]] const Buffer<Box>& boxes(std::size_t level) const { return levels_[level]; }
  [[nodiscard]] const Buffer<ArcStrip>& strips(std::size_t level) const { return strips_[level]; }
  /// How far arcs of a leaf lie from their segments at most.
  [[nodiscard]] double bend(std::size_t leaf) const { return bends_[leaf]; }
  [[nodiscard]] std::size_t end(std::size_t leaf) const { return std::min((leaf + 1) * segments_a_leaf, size_); }

 private:
  const SmoothCurve* curve_;
  std::size_t size_;
  std::vector<Buffer<Box>> levels_;
  std::vector<Buffer<ArcStrip>> strips_;
  Buffer<double> bends_;
};

}  // namespace lober::detail

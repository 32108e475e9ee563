// Where smooth curves overlap although their polygons do not cross (private to smooth/).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/geometry/smooth/arc_boxes.hpp"
#include "engine/geometry/smooth/smooth_curve.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

/// Segments of a closed curve about its nodes, which lead from one side of the other curve to the other one.
class NodeSegments {
 public:
  explicit NodeSegments(std::size_t segments);
  /// Counts the segments from one position (a segment's number and a parameter) to another one, and one more at either
  /// end. Any thread may call it.
  void add(double from, double to) { mark(from, to, 1); }
  /// Takes them out again: where a crossing has not been moved, the smooth curves may have any side of each other.
  void remove(double from, double to) { mark(from, to, 0); }
  /// Nothing is added any more. O(n).
  void join();
  /// Whether there are none.
  [[nodiscard]] bool none() const { return none_; }
  /// The bits of those of a leaf of ArcBoxes that are not about nodes.
  [[nodiscard]] std::uint32_t others(std::size_t leaf) const { return others_[leaf]; }
  /// Whether there are any in a node of them.
  [[nodiscard]] bool any_others(TreeNode node) const { return (levels_[node.level][node.index] & any) != 0; }
  /// Whether there are any in each leaf of a node; false above the root.
  [[nodiscard]] bool others_everywhere(TreeNode node) const {
    return node.level < levels_.size() && (levels_[node.level][node.index] & everywhere) != 0;
  }

 private:
  void mark(double from, double to, std::uint8_t about);

  std::size_t size_;
  bool none_ = true;
  Buffer<std::uint8_t> about_node_;  // and behind the last one up to the end of its leaf
  Buffer<std::uint32_t> others_;
  static constexpr std::uint8_t any = 1, everywhere = 2;
  std::vector<Buffer<std::uint8_t>> levels_;  // which of these holds for a node
};

/// One of two curves.
struct ArcsOfCurve {
  const SmoothCurve& curve;
  const ArcBoxes& boxes;
  const NodeSegments& about;
};

/// Twice the area, from above, in which smooth arcs have come to the other side of the other curve's arcs where the
/// polygons have not: two segments about nodes are not compared with each other. Arcs that lie nearer than they are
/// wrong count as well. Closed curves. O(pairs of leaves that come nearer than arcs bend), parallel; the same bits for
/// any number of threads.
[[nodiscard]] double hidden_area(const ArcsOfCurve& c1, const ArcsOfCurve& c2);

}  // namespace lober::detail

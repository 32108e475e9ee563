// Exact winding numbers: crossings of a ray to the right, with sign.

#include <algorithm>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/curve/require.hpp"
#include "engine/geometry/index/box_tree.hpp"
#include "kernels/predicates.hpp"
#include "lober/interior.hpp"

namespace lober {
namespace {

constexpr std::size_t grain = 256;  // queries a task

// Follows the ray from one point through a tree. Heights are half-open, a vertex at the height of the point counts as
// below it, so that every crossing belongs to exactly one segment.
class RayWalk {
 public:
  RayWalk(const BoxTree& tree, Point point) : tree_(tree), point_(point) {}

  Winding run() {
    visit(tree_.root());
    if (on_) return {0, true};
    return {number_, false};
  }

 private:
  // +1 for a way from below to above, -1 for the way back.
  [[nodiscard]] int rise(double from, double to) const {
    return static_cast<int>(to > point_.y) - static_cast<int>(from > point_.y);
  }

  void visit(TreeNode node) {
    const Box& box = tree_.box(node);
    if (box.max_y() < point_.y || box.min_y() > point_.y || box.max_x() < point_.x) return;
    if (box.min_x() > point_.x) {
      const std::size_t first = std::size_t{node.index} << node.level;
      const std::size_t end = std::min((std::size_t{node.index} + 1) << node.level, tree_.leaves());
      number_ += rise(tree_.leaf_begin(first).y, tree_.leaf_begin(end).y);
    } else if (node.level > 0) {
      const std::uint32_t end = std::min(2 * node.index + 2, tree_.nodes(node.level - 1));
      for (std::uint32_t child = 2 * node.index; child < end && !on_; ++child) visit({node.level - 1, child});
    } else {
      visit_leaf(tree_.leaf_points(node.index));
    }
  }

  void visit_leaf(const Point* p) {
    for (std::size_t i = 0; i < leaf_size && !on_; ++i) {
      const Point a = p[i], b = p[i + 1];
      const int direction = rise(a.y, b.y);
      if (direction != 0) {
        const int side = orient2d(a, b, point_, counts_);
        if (side == 0) on_ = true;
        if (side == direction) number_ += direction;  // the crossing is to the right of the point
      } else if (a.y == point_.y || b.y == point_.y) {
        // Not crossed: a level segment, or one that ends at this height.
        on_ = a == point_ || b == point_ || (a.y == b.y && (a.x < point_.x) != (b.x < point_.x));
      }
    }
  }

  const BoxTree& tree_;
  Point point_;
  std::int32_t number_ = 0;
  bool on_ = false;
  PredicateCounts counts_;
};

}  // namespace

Winding winding(const IndexedCurve& curve, Point point) {
  require_closed(curve.view(), "the curve", "winding number");
  return RayWalk(curve.tree(), point).run();
}

std::vector<Winding> windings(const IndexedCurve& curve, std::span<const Point> points) {
  std::vector<Winding> result(points.size());
  for_each_block(points.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) result[k] = winding(curve, points[k]);
  });
  return result;
}

Side side_of(const IndexedCurve& curve, Point point) {
  const Winding here = winding(curve, point);
  return here.on ? Side::on : here.number != 0 ? Side::inside : Side::outside;
}

Buffer<Side> label_points(const IndexedCurve& curve, std::span<const Point> points) {
  Buffer<Side> labels(points.size());
  for_each_block(points.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) labels[k] = side_of(curve, points[k]);
  });
  return labels;
}

}  // namespace lober

#include "engine/geometry/index/ray_crossings.hpp"

#include <algorithm>

#include "engine/geometry/curve/require.hpp"
#include "kernels/predicates.hpp"
#include "lober/overlay/index.hpp"

namespace lober {
using namespace detail;
namespace {

// Follows the ray from one point through a tree. Heights are half-open, a vertex at the height of the point counts as
// below it, so that every crossing belongs to exactly one segment.
class RayWalk {
 public:
  RayWalk(const BoxTree& tree, Point point) : tree_(tree), point_(point) {}

  RayCrossings run() {
    visit(tree_.root());
    return {number_, on_};
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

RayCrossings detail::ray_crossings(const BoxTree& tree, Point point) {
  return RayWalk(tree, point).run();
}

bool contains(const IndexedCurve& curve, Point point) {
  require_closed(curve.view(), "the curve", "inside or outside");
  return ray_crossings(curve.tree(), point).number % 2 != 0;
}

}  // namespace lober

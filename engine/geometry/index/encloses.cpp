// Inside or outside, by the parity of crossings of a ray to the right.

#include "engine/geometry/curve/require.hpp"
#include "engine/geometry/index/index.hpp"
#include "kernels/predicates.hpp"

namespace lober {
namespace {

// Whether a way from height `from` to height `to` crosses height y an odd number of times (a point at y counts as
// below).
bool changes_side(double from, double to, double y) {
  return (from > y) != (to > y);
}

bool odd_crossings(const BoxTree& tree, TreeNode node, Point point, PredicateCounts& counts) {
  const Box& box = tree.box(node);
  if (box.max_y() < point.y || box.min_y() > point.y || box.max_x() < point.x) return false;
  const std::size_t first_leaf = std::size_t{node.index} << node.level;
  const std::size_t end_leaf = std::min((std::size_t{node.index} + 1) << node.level, tree.leaves());
  if (box.min_x() > point.x) {
    return changes_side(tree.leaf_begin(first_leaf).y, tree.leaf_begin(end_leaf).y, point.y);
  }
  bool odd = false;
  if (node.level > 0) {
    for (std::uint32_t child = 2 * node.index; child < 2 * node.index + 2; ++child) {
      if (child < tree.nodes(node.level - 1)) odd ^= odd_crossings(tree, {node.level - 1, child}, point, counts);
    }
    return odd;
  }
  const Point* p = tree.leaf_points(node.index);
  for (std::size_t i = 0; i < leaf_size; ++i) {
    if (!changes_side(p[i].y, p[i + 1].y, point.y)) continue;
    const bool upward = p[i + 1].y > p[i].y;
    const int side = orient2d(p[i], p[i + 1], point, counts);
    if (side == (upward ? 1 : -1)) odd = !odd;  // the crossing is to the right of the point
  }
  return odd;
}

}  // namespace

bool encloses(const IndexedCurve& curve, Point point) {
  require_closed(curve.view(), "the curve", "inside or outside");
  PredicateCounts counts;
  return odd_crossings(curve.tree(), curve.tree().root(), point, counts);
}

}  // namespace lober

#include "engine/geometry/index/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/geometry/curve/require.hpp"
#include "kernels/predicates.hpp"
#include "kernels/shoelace.hpp"

namespace lober::detail {
namespace {

// The sign of twice an area, a sum along the curve about a point so near that both are of that extent; 0 if it is not
// certain. A term is wrong by 2^-102 of the square of the extent at most, an addition by less; what underflows is lost
// whole.
int certain_sign(DD twice_area, const BoxTree& tree, double extent) {
  const double lost = static_cast<double>(tree.segments()) * (extent * extent * 0x1p-98 + 0x1p-1000);
  if (!(std::fabs(twice_area.hi) > lost)) return 0;
  return twice_area.hi > 0 ? 1 : -1;
}

// The same from the sums that the tree brings along.
int certain_sign(const BoxTree& tree) {
  DD twice_area;
  if (const KeptSums* const kept = tree.kept_sums()) {
    twice_area = kept->total();
  } else {
    const Point origin = tree.leaf_begin(0);
    for (std::size_t k = 0; k < tree.chunk_sums().size(); ++k) {
      twice_area += tree.chunk_sums()[k] + shoelace(*tree.chunk_points(k), *tree.chunk_points(k + 1), origin);
    }
  }
  return certain_sign(twice_area, tree, tree.box().extent());
}

// The turn at the extreme vertex, where a simple curve is convex.
int extreme_turn(const BoxTree& tree) {
  const CurveView& curve = tree.curve();
  const std::uint32_t segment = extreme_segment(tree);
  const auto [at, after] = curve.segment(segment);
  std::size_t before = segment;
  do {
    before = before == 0 ? curve.points.size() - 1 : before - 1;
  } while (curve.points[before] == at && before != segment);
  PredicateCounts counts;
  return orient2d(curve.points[before], at, after, counts);
}

}  // namespace

std::uint32_t extreme_segment(const BoxTree& tree) {
  const double greatest_x = tree.box().max_x();
  std::vector<TreeNode> open{tree.root()};
  std::uint32_t best = 0;
  bool found = false;
  while (!open.empty()) {
    const TreeNode node = open.back();
    open.pop_back();
    if (tree.box(node).max_x() < greatest_x) continue;
    if (node.level > 0) {
      for (std::uint32_t child = 2 * node.index; child < 2 * node.index + 2; ++child) {
        if (child < tree.nodes(node.level - 1)) open.push_back({node.level - 1, child});
      }
      continue;
    }
    const std::size_t begin = node.index * leaf_size, end = std::min(begin + leaf_size, tree.segments());
    for (std::size_t k = begin; k < end; ++k) {
      const auto [a, b] = tree.curve().segment(k);
      if (a == b || a.x < greatest_x) continue;
      const Point rival = tree.curve().points[best];
      if (found && (a.y < rival.y || (a.y == rival.y && k > best))) continue;
      best = static_cast<std::uint32_t>(k);
      found = true;
    }
  }
  return best;
}

Orientation orientation(const IndexedCurve& curve) {
  require_closed(curve.view(), "the curve", "orientation");
  int sign = certain_sign(curve.tree());
  if (sign == 0) sign = extreme_turn(curve.tree());
  return sign > 0 ? Orientation::counter_clockwise : sign < 0 ? Orientation::clockwise : Orientation::degenerate;
}

Orientation orientation(const IndexedCurve& curve, DD twice_area, double extent) {
  const int sign = certain_sign(twice_area, curve.tree(), extent);
  if (sign == 0) return orientation(curve);
  return sign > 0 ? Orientation::counter_clockwise : Orientation::clockwise;
}

}  // namespace lober::detail

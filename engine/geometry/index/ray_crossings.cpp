#include "engine/geometry/index/ray_crossings.hpp"

#include <algorithm>
#include <array>

#include "engine/geometry/curve/require.hpp"
#include "engine/geometry/index/ray_tally.hpp"
#include "lober/overlay/index.hpp"

namespace lober {
using namespace detail;
namespace {

using Nodes = std::array<std::uint32_t, ray_room>;

// Follows the ray from the first `count` nodes of a level, no more than follow_ray takes, down to the leaves.
void follow_to_leaves(const BoxTree& tree, Point point, std::uint32_t level, Nodes& nodes, std::size_t count,
                      RayTally& tally) {
  const RayTree followed{tree.pyramid(), tree.chunk_points(0), static_cast<std::uint32_t>(tree.leaves())};
  const RayProgress reached = follow_ray(point, followed, level, nodes.data(), count);
  tally.add(reached.number);
  if (reached.level == 0) {
    for (std::size_t k = 0; k < reached.count && !tally.found().on; ++k) tally.add_leaf(tree.leaf_points(nodes[k]));
    return;
  }
  for (std::size_t begin = 0; begin < reached.count && !tally.found().on; begin += ray_nodes) {
    const std::size_t part_count = std::min(ray_nodes, reached.count - begin);
    Nodes part;
    std::copy_n(nodes.begin() + static_cast<std::ptrdiff_t>(begin), part_count, part.begin());
    follow_to_leaves(tree, point, reached.level, part, part_count, tally);
  }
}

}  // namespace

RayCrossings detail::ray_crossings(const BoxTree& tree, Point point) {
  const Box& box = tree.box();
  if (box.max_y() < point.y || box.min_y() > point.y || box.max_x() < point.x) return {};
  RayTally tally(point);
  Nodes nodes;  // not filled: a query takes less time than that
  nodes[0] = 0;
  follow_to_leaves(tree, point, tree.root().level, nodes, 1, tally);
  return tally.found();
}

bool contains(const IndexedCurve& curve, Point point) {
  require_closed(curve.view(), "the curve", "inside or outside");
  return ray_crossings(curve.tree(), point).number % 2 != 0;
}

}  // namespace lober

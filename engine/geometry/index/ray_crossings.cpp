#include "engine/geometry/index/ray_crossings.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "engine/geometry/curve/require.hpp"
#include "kernels/predicates.hpp"
#include "kernels/ray.hpp"
#include "lober/overlay/index.hpp"

namespace lober {
using namespace detail;
namespace {

// Follows the ray from one point through a tree.
class RayWalk {
 public:
  RayWalk(const BoxTree& tree, Point point) : tree_(tree), point_(point) {}

  RayCrossings run() {
    const Box& box = tree_.box();
    if (box.max_y() < point_.y || box.min_y() > point_.y || box.max_x() < point_.x) return {};
    Nodes all;  // not filled: a query takes less time than that
    all[0] = 0;
    follow(tree_.root().level, all, 1);
    return {number_, on_};
  }

 private:
  using Nodes = std::array<std::uint32_t, ray_room>;

  // From the first `count` nodes, no more than follow_ray takes, down to the leaves.
  void follow(std::uint32_t level, Nodes& nodes, std::size_t count) {
    const RayProgress reached =
        follow_ray(point_, {tree_.pyramid(), tree_.chunk_points(0), leaves()}, level, nodes.data(), count);
    number_ += reached.number;
    if (reached.level == 0) {
      for (std::size_t k = 0; k < reached.count && !on_; ++k) count_on_leaf(tree_.leaf_points(nodes[k]));
      return;
    }
    for (std::size_t begin = 0; begin < reached.count && !on_; begin += ray_nodes) {
      const std::size_t part_count = std::min(ray_nodes, reached.count - begin);
      Nodes part;
      std::copy_n(nodes.begin() + static_cast<std::ptrdiff_t>(begin), part_count, part.begin());
      follow(reached.level, part, part_count);
    }
  }

  void count_on_leaf(const Point* p) {
    const HeightCrossings found = crossings_of_height(p, point_);
    number_ += found.number;
    for (std::uint64_t bits = found.up | found.down; bits != 0; bits &= bits - 1) {
      const auto segment = static_cast<std::size_t>(std::countr_zero(bits)) / 2;
      const int direction = (found.up & bits & -bits) != 0 ? 1 : -1;
      const int side = orient2d(p[segment], p[segment + 1], point_, counts_);
      if (side == 0) on_ = true;
      if (side == direction) number_ += direction;  // the crossing is to the right of the point
    }
    for (std::uint64_t bits = found.level; bits != 0; bits &= bits - 1) {
      const auto segment = static_cast<std::size_t>(std::countr_zero(bits)) / 2;
      const Point a = p[segment], b = p[segment + 1];
      on_ = on_ || a == point_ || b == point_ || (a.y == b.y && (a.x < point_.x) != (b.x < point_.x));
    }
  }

  [[nodiscard]] std::uint32_t leaves() const { return static_cast<std::uint32_t>(tree_.leaves()); }

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

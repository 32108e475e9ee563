// J, from the angles of arcs as seen from a point.

#include <algorithm>
#include <cmath>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/curve/require.hpp"
#include "engine/geometry/index/box_tree.hpp"
#include "kernels/elementary.hpp"
#include "kernels/predicates.hpp"
#include "lober/overlay/interior.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr std::size_t interior_queries_a_task = 256;  // queries a task

struct Vector {
  double x, y;
};

// The direction from one point to another, its larger component between 1/2 and 2 unless the points are equal.
Vector far_direction(Point from, Point to) {
  // Halves cannot overflow; what they lose of subnormal numbers matters only where whole differences are safe.
  Vector v{0.5 * to.x - 0.5 * from.x, 0.5 * to.y - 0.5 * from.y};
  if (std::max(std::fabs(v.x), std::fabs(v.y)) < 0x1p-900) v = {to.x - from.x, to.y - from.y};
  const double size = std::max(std::fabs(v.x), std::fabs(v.y));
  if (size == 0) return v;
  const int exponent = std::ilogb(size);
  return {std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent)};
}

// The angle at `at` from a to b, in (-pi, pi), where the way from a to b makes less than half a turn; 0 if one of them
// is `at`. Error below 2^-51 or so: products and their sum are rounded relative to |a - at| |b - at|.
double angle(Point at, Point a, Point b, PredicateCounts& counts) {
  Vector u{a.x - at.x, a.y - at.y}, v{b.x - at.x, b.y - at.y};
  const double size_u = std::max(std::fabs(u.x), std::fabs(u.y)), size_v = std::max(std::fabs(v.x), std::fabs(v.y));
  constexpr double smallest = 0x1p-450, largest = 0x1p500;
  if (!(size_u > smallest && size_u < largest && size_v > smallest && size_v < largest)) {
    if (a == at || b == at) return 0;
    u = far_direction(at, a);
    v = far_direction(at, b);
  }
  const double sine = u.x * v.y - u.y * v.x, cosine = u.x * v.x + u.y * v.y;
  // Near half a turn the rounded sine may have the wrong sign, which would be a whole turn.
  if (cosine >= 0) return elementary::atan2(sine, cosine);
  return std::copysign(elementary::atan2(std::fabs(sine), cosine), orient2d(at, a, b, counts));
}

// Half-planes beside the point.
enum HalfPlanes : unsigned { right_of = 1, left_of = 2, above = 4, below = 8 };

// Follows the curve once round. Neighbouring arcs that stay in one half-plane beside the point are taken for one, which
// leaves a handful of angles.
class AngleWalk {
 public:
  AngleWalk(const BoxTree& tree, Point point) : tree_(tree), point_(point) {}

  InteriorValue run() {
    visit(tree_.root());
    end_arc();
    return value_;
  }

 private:
  [[nodiscard]] unsigned half_planes(const Box& box) const {
    return (box.min_x() > point_.x ? right_of : 0U) | (box.max_x() < point_.x ? left_of : 0U) |
           (box.min_y() > point_.y ? above : 0U) | (box.max_y() < point_.y ? below : 0U);
  }

  void visit(TreeNode node) {
    if (const unsigned planes = half_planes(tree_.box(node)); planes != 0) {
      const std::size_t first = std::size_t{node.index} << node.level;
      const std::size_t end = std::min((std::size_t{node.index} + 1) << node.level, tree_.leaves());
      follow(tree_.leaf_begin(first), tree_.leaf_begin(end), planes);
    } else if (node.level > 0) {
      const std::uint32_t end = std::min(2 * node.index + 2, tree_.nodes(node.level - 1));
      for (std::uint32_t child = 2 * node.index; child < end; ++child) visit({node.level - 1, child});
    } else {
      visit_leaf(tree_.leaf_points(node.index));
    }
  }

  // A segment through the point contributes nothing: the principal value.
  void visit_leaf(const Point* p) {
    for (std::size_t i = 0; i < leaf_size; ++i) {
      if (const unsigned planes = half_planes(Box::of(p[i], p[i + 1])); planes != 0) {
        follow(p[i], p[i + 1], planes);
      } else if (end_arc(); on_segment(p[i], p[i + 1], point_, counts_)) {
        value_.on = true;
      } else {
        value_.j += angle(point_, p[i], p[i + 1], counts_);
      }
    }
  }

  // The curve goes on from `from` to `to` inside these half-planes.
  void follow(Point from, Point to, unsigned planes) {
    if ((planes_ & planes) == 0) {
      end_arc();
      from_ = from;
      planes_ = planes;
    }
    planes_ &= planes;
    to_ = to;
  }
  void end_arc() {
    if (planes_ != 0) value_.j += angle(point_, from_, to_, counts_);
    planes_ = 0;
  }

  const BoxTree& tree_;
  Point point_;
  InteriorValue value_;
  Point from_, to_;      // ends of the arc under way
  unsigned planes_ = 0;  // half-planes that all of it lies in; 0 when there is none
  PredicateCounts counts_;
};

}  // namespace

InteriorValue interior_function(const IndexedCurve& curve, Point point) {
  require_closed(curve.view(), "the curve", "interior function");
  return AngleWalk(curve.tree(), point).run();
}

std::vector<InteriorValue> interior_function(const IndexedCurve& curve, std::span<const Point> points) {
  std::vector<InteriorValue> result(points.size());
  for_each_block(points.size(), interior_queries_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) result[k] = interior_function(curve, points[k]);
  });
  return result;
}

double interior_function_direct(CurveView curve, Point point) {
  require_closed(curve, "the curve", "interior function");
  double sum = 0;
  for (std::size_t k = 0; k < curve.segments(); ++k) {
    const auto [a, b] = curve.segment(k);
    const Vector u{a.x - point.x, a.y - point.y}, v{b.x - a.x, b.y - a.y};
    const double cross = u.x * v.y - u.y * v.x, dot = u.x * v.x + u.y * v.y;
    if (cross != 0) sum += elementary::atan((v.x * v.x + v.y * v.y + dot) / cross) - elementary::atan(dot / cross);
  }
  return sum;
}

}  // namespace lober

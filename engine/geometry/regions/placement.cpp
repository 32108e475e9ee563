// In which face of one curve a point lies: the first edge that a ray meets.

#include <algorithm>
#include <optional>
#include <vector>

#include "engine/geometry/regions/faces.hpp"

namespace lober::detail {
namespace {

// Where a segment crosses the height just above the point.
struct RayHit {
  std::uint32_t segment;  // as the curve numbers them
  Point low, high;        // its ends, upwards
  bool upward;
};

// The point of a hit, on the ray and on the segment.
ImplicitPoint on_ray(const RayHit& hit, double y) {
  return hit.low.y == y ? ImplicitPoint{hit.low, hit.low, true} : ImplicitPoint{hit.low, hit.high};
}
ImplicitPoint on_segment_of(const RayHit& hit, Point from, Point to) {
  return hit.low.y == from.y ? ImplicitPoint{hit.low, hit.low, true} : ImplicitPoint{from, to};
}

// The first segment of the curve to the right of `from`; `to` is the end of the ray.
std::optional<RayHit> first_hit(const BoxTree& tree, Point from, Point to, PredicateCounts& counts) {
  std::optional<RayHit> first;
  // Just above the height of the ray, when both meet it in the same point, the one that leans more to the left comes
  // first.
  const auto before = [&](const RayHit& x, const RayHit& y) {
    const int order = compare_along(from, to, on_ray(x, from.y), on_ray(y, from.y));
    return order != 0 ? order < 0 : cross_sign(x.low, x.high, y.low, y.high, counts) < 0;
  };
  std::vector<TreeNode> open{tree.root()};
  while (!open.empty()) {
    const TreeNode node = open.back();
    open.pop_back();
    const Box& box = tree.box(node);
    if (box.max_y() < from.y || box.min_y() > from.y || box.max_x() < from.x) continue;
    if (node.level > 0) {
      for (std::uint32_t child = 2 * node.index; child < 2 * node.index + 2; ++child) {
        if (child < tree.nodes(node.level - 1)) open.push_back({node.level - 1, child});
      }
      continue;
    }
    const Point* points = tree.leaf_points(node.index);
    for (std::size_t k = 0; k < leaf_size; ++k) {
      const Point a = points[k], b = points[k + 1];
      if ((a.y > from.y) == (b.y > from.y)) continue;
      const bool upward = b.y > a.y;
      const RayHit hit{static_cast<std::uint32_t>(node.index * leaf_size + k), upward ? a : b, upward ? b : a, upward};
      if (orient2d(hit.low, hit.high, from, counts) <= 0) continue;  // it passes on the left of the point
      if (!first || before(hit, *first)) first = hit;
    }
  }
  return first;
}

}  // namespace

std::uint32_t half_edge_right_of(Point point, const EdgeChains& edge_chains, const Events& events,
                                 const HalfEdges& graph, const IndexedCurve& curve, int number,
                                 PredicateCounts& counts) {
  const Point end{curve.tree().box().max_x(), point.y};
  if (end.x <= point.x) return no_half_edge;
  const std::optional<RayHit> hit = first_hit(curve.tree(), point, end, counts);
  if (!hit) return no_half_edge;
  // The event before the hit on the same segment, if any; else the last one before the segment.
  const std::uint32_t segment = edge_chains.first_of(number) + hit->segment;
  const Segment ends = edge_chains.segment(segment);
  const auto begin = events.candidate.begin() + events.begin[static_cast<std::size_t>(number)];
  const auto last = events.candidate.begin() + events.begin[static_cast<std::size_t>(number) + 1];
  const ImplicitPoint on_segment_point = on_segment_of(*hit, point, end);
  const auto after = std::partition_point(begin, last, [&](std::uint32_t candidate) {
    const Event event = events.of_candidate(candidate);
    if (event.segment != segment) return event.segment < segment;
    const int order = compare_along(ends.a, ends.b, implicit_point(edge_chains, event), on_segment_point);
    return order != 0 ? order < 0 : hit->upward;  // the hit is a little above that point
  });
  const auto next = static_cast<std::uint32_t>(after - events.candidate.begin());
  const bool none_before = after == begin;
  const std::uint32_t edge = (none_before ? events.begin[static_cast<std::size_t>(number) + 1] : next) - 1;
  return graph.representative(2 * edge + (hit->upward ? 0U : 1U));
}

}  // namespace lober::detail

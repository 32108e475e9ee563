#include "engine/geometry/index/vertex_rays.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/index/ray_tally.hpp"

namespace lober::detail {
namespace {

constexpr std::uint32_t rays_task_level = 6;
constexpr std::size_t vertices_a_task = 256;
// With fewer vertices for each leaf, they are located one by one.
constexpr double worth_carrying = 1;

// The heights of the ends of a part of the other curve that is to the right of all points looked from.
struct Heights {
  double from, to;
};

// The nodes that rays from a node of the own tree meet.
struct Sight {
  std::int32_t number = 0;     // crossings of all of them alike
  std::size_t near_count = 0;  // in `near`
  Buffer<TreeNode> near;       // nodes that reach to the left of the right end of the node
  std::vector<Heights> ahead;  // parts to the right, one end of which is at the height of the node
};

void ensure_size(Buffer<TreeNode>& list, std::size_t size) {
  if (list.size() < size) list.resize(2 * size);
}

class VertexRays {
 public:
  VertexRays(const BoxTree& own, const BoxTree& other, std::span<const std::uint32_t> vertices,
             Buffer<RayCrossings>& found)
      : own_(own), other_(other), vertices_(vertices), found_(found) {}

  // All vertices of the leaves below `node`.
  void run(TreeNode node) const {
    const Range vertices = vertices_of(node, {0, vertices_.size()});
    if (vertices.first == vertices.last) return;
    Scratch scratch;
    std::vector<Sight>& sights = scratch.sights;
    sights.resize(own_.levels() + std::size_t{1});
    sights[own_.levels()].near = {other_.root()};
    sights[own_.levels()].near_count = 1;
    for (std::uint32_t level = own_.levels(); level-- > node.level;) {
      look({level, node.index >> (level - node.level)}, sights[level + std::size_t{1}], sights[level], scratch);
    }
    walk(node, vertices, scratch);
  }

 private:
  struct Scratch {
    std::vector<Sight> sights;  // by level
    Buffer<TreeNode> waiting, below, ahead;
    Buffer<std::uint32_t> leaves, around, leaves_ahead;
  };

  // A part of vertices_.
  struct Range {
    std::size_t first, last;
  };

  // The vertices of the leaves below a node, out of those of a node above it.
  [[nodiscard]] Range vertices_of(TreeNode node, Range above) const {
    const std::uint64_t begin = (std::uint64_t{node.index} << node.level) * leaf_size;
    const std::uint64_t end = (std::uint64_t{node.index + 1} << node.level) * leaf_size;
    const std::span<const std::uint32_t> part = vertices_.subspan(above.first, above.last - above.first);
    const auto from = std::lower_bound(part.begin(), part.end(), begin);
    const auto to = std::lower_bound(from, part.end(), end);
    return {above.first + static_cast<std::size_t>(from - part.begin()),
            above.first + static_cast<std::size_t>(to - part.begin())};
  }

  void walk(TreeNode node, Range vertices, Scratch& scratch) const {
    const Sight& sight = scratch.sights[node.level];
    if (node.level == 0) {
      for (Buffer<std::uint32_t>* const list : {&scratch.leaves, &scratch.around, &scratch.leaves_ahead}) {
        if (list->size() <= sight.near_count) list->resize(2 * sight.near_count + 1);
      }
      for (std::size_t k = 0; k < sight.near_count; ++k) scratch.leaves[k] = sight.near[k].index;
      for (std::size_t k = vertices.first; k < vertices.last; ++k) {
        found_[k] = from_vertex(own_.curve().points[vertices_[k]], sight, scratch);
      }
      return;
    }
    for (std::uint32_t child = 2 * node.index; child < 2 * node.index + 2; ++child) {
      if (child >= own_.nodes(node.level - 1)) continue;
      const Range below = vertices_of({node.level - 1, child}, vertices);
      if (below.first == below.last) continue;
      look({node.level - 1, child}, sight, scratch.sights[node.level - 1], scratch);
      walk({node.level - 1, child}, below, scratch);
    }
  }

  // The part that rays from `node` meet of what those from a node above it meet.
  void look(TreeNode node, const Sight& above, Sight& sight, Scratch& scratch) const {
    const Box& box = own_.box(node);
    sight.number = above.number;
    sight.near_count = 0;
    sight.ahead.clear();
    for (const Heights& part : above.ahead) add_ahead(part, box, sight);
    Box shadow = box;
    shadow.lane[2] = -std::numeric_limits<double>::infinity();
    const double largest = node.level == 0 ? -1 : box.extent();
    Buffer<TreeNode>&waiting = scratch.waiting, &below = scratch.below;
    std::size_t count = keep_near(above.near.data(), above.near_count, shadow, box, scratch, sight);
    while (count > 0) {
      ensure_size(sight.near, sight.near_count + count + 1);
      ensure_size(below, nodes_at_once * count + 1);
      const SplitCounts refined =
          refine(shadow, largest, other_.pyramid(), waiting.data(), count, &sight.near[sight.near_count], below.data());
      sight.near_count += refined.kept;
      count = keep_near(below.data(), refined.split, shadow, box, scratch, sight);
    }
  }

  // Moves those of the nodes that reach to the left of the right end of `box` to `waiting`, and counts the others.
  std::size_t keep_near(const TreeNode* nodes, std::size_t count, const Box& shadow, const Box& box, Scratch& scratch,
                        Sight& sight) const {
    ensure_size(scratch.waiting, count + 1);
    ensure_size(scratch.ahead, count + 1);
    const BoxQuery query(shadow);
    std::size_t near = 0, ahead = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const Box& there = other_.box(nodes[k]);
      const auto met = static_cast<unsigned>(meet(query, there));
      const auto beyond = static_cast<unsigned>(there.min_x() > box.max_x());
      scratch.waiting[near] = scratch.ahead[ahead] = nodes[k];
      near += met & ~beyond;
      ahead += met & beyond;
    }
    for (std::size_t k = 0; k < ahead; ++k) add_ahead(ends_of(scratch.ahead[k]), box, sight);
    return near;
  }

  [[nodiscard]] Heights ends_of(TreeNode node) const {
    const std::size_t first = std::size_t{node.index} << node.level;
    const std::size_t end = std::min((std::size_t{node.index} + 1) << node.level, other_.leaves());
    return {other_.leaf_begin(first).y, other_.leaf_begin(end).y};
  }

  static void add_ahead(Heights part, const Box& box, Sight& sight) {
    const auto is_certain = [&](double height) { return height > box.max_y() || height <= box.min_y(); };
    if (is_certain(part.from) && is_certain(part.to)) {
      sight.number += static_cast<int>(part.to > box.max_y()) - static_cast<int>(part.from > box.max_y());
    } else {
      sight.ahead.push_back(part);
    }
  }

  [[nodiscard]] RayCrossings from_vertex(Point point, const Sight& sight, Scratch& scratch) const {
    RayTally tally(point, sight.number);
    for (const Heights& part : sight.ahead) tally.add_ahead(part.from, part.to);
    const RayCounts found = leaves_on_ray(point, other_.leaf_boxes(), scratch.leaves.data(), sight.near_count,
                                          scratch.around.data(), scratch.leaves_ahead.data());
    for (std::size_t k = 0; k < found.ahead; ++k) {
      const Heights part = ends_of({0, scratch.leaves_ahead[k]});
      tally.add_ahead(part.from, part.to);
    }
    for (std::size_t k = 0; k < found.around; ++k) tally.add_leaf(other_.leaf_points(scratch.around[k]));
    return tally.found();
  }

  const BoxTree& own_;
  const BoxTree& other_;
  std::span<const std::uint32_t> vertices_;
  Buffer<RayCrossings>& found_;
};

}  // namespace

Buffer<RayCrossings> vertex_rays(const BoxTree& own, const BoxTree& other, std::span<const std::uint32_t> vertices) {
  Buffer<RayCrossings> found(vertices.size());
  if (static_cast<double>(vertices.size()) < worth_carrying * static_cast<double>(own.leaves())) {
    for_each_block(vertices.size(), vertices_a_task, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) found[k] = ray_crossings(other, own.curve().points[vertices[k]]);
    });
    return found;
  }
  const VertexRays rays(own, other, vertices, found);
  const std::uint32_t level = std::min(rays_task_level, own.levels() - 1);
  for_each_block(own.nodes(level), 1, [&](std::size_t node, std::size_t) {
    rays.run({level, static_cast<std::uint32_t>(node)});
  });
  return found;
}

}  // namespace lober::detail

#include "engine/geometry/index/node_frames.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/segment_boxes.hpp"

namespace lober::detail {
namespace {

// Rounding of the middles, of products and sums with them, here and in keep_near: less than this times the largest
// numbers that occur.
constexpr double roundings = 0x1p-47;

// A box tells how far a node reaches along any direction; how far beside it, `low` to `high`, is known better. A
// direction of no length, or none that can be normalised, stands for the x axis.
Frame frame_of(const Box& box, Point along, double length, double low, double high) {
  const Point middle{0.5 * box.min_x() + 0.5 * box.max_x(), 0.5 * box.min_y() + 0.5 * box.max_y()};
  const double half_width = 0.5 * box.width(), half_height = 0.5 * box.height();
  const double slack = roundings * (std::fabs(middle.x) + std::fabs(middle.y) + half_width + half_height) + 0x1p-1000;
  if (!(length > 0x1p-900 && length < 0x1p900)) {
    return {middle, {1, 0}, half_width + slack, half_height + slack};
  }
  const double beside = 0.5 * (low + high) - (along.x * middle.y - along.y * middle.x);
  return {{middle.x - beside * along.y, middle.y + beside * along.x},
          along,
          half_width * std::fabs(along.x) + half_height * std::fabs(along.y) + slack,
          0.5 * (high - low) + slack};
}

Frame frame_of_leaf(const Box& box, const Point* points) {
  Slab slab;
  leaf_slab(points, slab);
  const double length = std::sqrt(slab.normal.x * slab.normal.x + slab.normal.y * slab.normal.y), part = 1 / length;
  return frame_of(box, {slab.normal.y * part, -slab.normal.x * part}, length, slab.low * part, slab.high * part);
}

Frame frame_of_two(const Box& box, Point from, Point to, const Frame& first, const Frame& last) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::sqrt(dx * dx + dy * dy);
  const Point along{dx / length, dy / length};
  double low = INFINITY, high = -INFINITY;
  for (const Frame* const one : {&first, &last}) {
    const double parallel = std::fabs(along.x * one->along.x + along.y * one->along.y);
    const double across = std::fabs(along.x * one->along.y - along.y * one->along.x);
    const double beside = along.x * one->middle.y - along.y * one->middle.x;
    const double reach = one->length * across + one->width * parallel;
    low = std::min(low, beside - reach);
    high = std::max(high, beside + reach);
  }
  return frame_of(box, along, length, low, high);
}

}  // namespace

NodeFrames::NodeFrames(const BoxTree& tree) {
  std::uint32_t total = 0;
  for (std::uint32_t level = 0; level < tree.levels(); ++level) {
    begin_[level] = total;
    total += tree.nodes(level);
  }
  frames_.resize(total);
  for_each_block(tree.leaves(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t leaf = begin; leaf < end; ++leaf)
      frames_[leaf] = frame_of_leaf(tree.leaf_boxes()[leaf], tree.leaf_points(leaf));
  });
  for (std::uint32_t level = 1; level < tree.levels(); ++level) {
    const Frame* below = &frames_[begin_[level - 1]];
    for_each_block(tree.nodes(level), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const std::size_t last = std::min<std::size_t>((k + 1) << level, tree.leaves());
        const bool one = 2 * k + 1 == tree.nodes(level - 1);
        const Box& box = tree.box({level, static_cast<std::uint32_t>(k)});
        frames_[begin_[level] + k] =
            one ? below[2 * k]
                : frame_of_two(box, tree.leaf_begin(k << level), tree.leaf_begin(last), below[2 * k], below[2 * k + 1]);
      }
    });
  }
}

}  // namespace lober::detail

// Bodies of follow_ray and crossings_of_height (kernels/all.inl).
#pragma once

#include "kernels/ray.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {
namespace {

// A box is met if its lanes but the first are at most these; its first says whether it begins to the right.
inline Lanes bound_of_ray(Point point) {
  return Lanes{point.x, point.y, -point.x, -point.y};
}

// The numbers of nodes that went to each list: those that a ray may begin in, or beside, and those wholly to the right.
struct RayCounts {
  std::size_t around = 0, ahead = 0;
};

inline RayCounts go_down_ray(Point point, BoxPyramid pyramid, std::uint32_t below, std::uint32_t down,
                             const std::uint32_t* list, std::size_t count, std::uint32_t* around,
                             std::uint32_t* ahead) {
  const Lanes bound = bound_of_ray(point);
  const std::uint32_t size = pyramid.size[below], most = 1U << down;
  const Box* boxes = pyramid.boxes + pyramid.begin[below];
  RayCounts end;
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint32_t first = list[k] << down, left = size - first, present = left < most ? left : most;
    for (std::uint32_t i = 0; i < nodes_at_once; ++i) {
      const unsigned bits = mask_bits(load(boxes[first + i].lane) <= bound);
      const auto there = static_cast<unsigned>(i < present);
      around[end.around] = first + i;
      end.around += static_cast<unsigned>(bits == 15) & there;
      ahead[end.ahead] = first + i;
      end.ahead += static_cast<unsigned>(bits == 14) & there;
    }
  }
  return end;
}

inline RayProgress follow_ray_down(Point point, const RayTree& tree, std::uint32_t level, std::uint32_t* list,
                                   std::size_t count) {
  std::uint32_t other[ray_room], ahead[ray_room];
  std::uint32_t *from = list, *to = other;
  RayProgress progress{level, count, 0};
  while (progress.level > 0 && progress.count > 0 && progress.count <= ray_nodes) {
    const std::uint32_t down = progress.level < levels_at_once ? progress.level : levels_at_once;
    progress.level -= down;
    const RayCounts found = go_down_ray(point, tree.boxes, progress.level, down, from, progress.count, to, ahead);
    for (std::size_t k = 0; k < found.ahead; ++k) {
      const std::uint32_t first = ahead[k] << progress.level, width = 1U << progress.level;
      const std::uint32_t end = tree.leaves - first < width ? tree.leaves : first + width;
      progress.number +=
          static_cast<int>(tree.begins[end].y > point.y) - static_cast<int>(tree.begins[first].y > point.y);
    }
    progress.count = found.around;
    std::uint32_t* const swapped = from;
    from = to;
    to = swapped;
  }
  if (from != list) {
    for (std::size_t k = 0; k < progress.count; ++k) list[k] = from[k];
  }
  return progress;
}

// Bits of x at even places, of y at odd ones, of 32 points; those of the one behind them apart.
struct CoordinateBits {
  std::uint64_t first = 0, behind = 0;
  /// The same of the ends of segments.
  [[nodiscard]] std::uint64_t ends() const { return first >> 2 | behind << 62; }
};

inline HeightCrossings crossings_of_leaf(const Point* points, Point point) {
  constexpr std::uint64_t x_bits = 0x5555555555555555, y_bits = x_bits << 1;
  const Lanes at{point.x, point.y, point.x, point.y};
  const double* coordinates = &points[0].x;
  CoordinateBits greater, less;
  for (std::size_t k = 0; k < 2 * leaf_size; k += lanes) {
    const Lanes two = load(coordinates + k);
    greater.first |= static_cast<std::uint64_t>(mask_bits(two > at)) << k;
    less.first |= static_cast<std::uint64_t>(mask_bits(two < at)) << k;
  }
  const Point last = points[leaf_size];
  greater.behind = static_cast<std::uint64_t>(last.x > point.x) | static_cast<std::uint64_t>(last.y > point.y) << 1;
  less.behind = static_cast<std::uint64_t>(last.x < point.x) | static_cast<std::uint64_t>(last.y < point.y) << 1;

  const std::uint64_t above = greater.first, above_after = greater.ends();
  const std::uint64_t up = ~above & above_after & y_bits, down = above & ~above_after & y_bits;
  const std::uint64_t right = (above & above_after & x_bits) << 1, left = (less.first & less.ends() & x_bits) << 1;
  const std::uint64_t at_height = ~(above | less.first) & y_bits,
                      at_height_after = ~(above_after | less.ends()) & y_bits;
  return {__builtin_popcountll(up & right) - __builtin_popcountll(down & right), up & ~right & ~left,
          down & ~right & ~left, (at_height | at_height_after) & ~(up | down)};
}

}  // namespace
}  // namespace lober::detail

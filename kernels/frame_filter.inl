// Bodies of the kernels of frames (kernels/all.inl).
#pragma once

#include "kernels/eight.hpp"
#include "kernels/fetch.hpp"
#include "kernels/frame_filter.hpp"
#include "kernels/node_lanes.inl"

namespace lober::detail {
namespace {

// Rounding of the middles, of products and sums with them, here and in tests: less than this times the largest numbers
// that occur.
constexpr double frame_roundings = 0x1p-47;

struct FrameLanes {
  Lanes x, y, along_x, along_y, length, width;
};
inline void load_frames(const FourFrames& four, FrameLanes& frames) {
  frames = {load(four.x), load(four.y), load(four.along_x), load(four.along_y), load(four.length), load(four.width)};
}
inline void splat_frame(const FourFrames& four, std::size_t k, FrameLanes& frame) {
  frame = {splat(four.x[k]),       splat(four.y[k]),      splat(four.along_x[k]),
           splat(four.along_y[k]), splat(four.length[k]), splat(four.width[k])};
}

// Directions of four chords. One of no length, or one that cannot be normalised, stands for the x axis.
struct Directions {
  Lanes x, y;
  LaneMask sound;
};
inline void normalise_chords(Lanes dx, Lanes dy, Directions& along) {
  const Lanes one = splat(1), length = square_root(dx * dx + dy * dy);
  along.sound = (length > splat(0x1p-900)) & (length < splat(0x1p900));
  const Lanes part = one / (along.sound ? length : one);
  along.x = along.sound ? dx * part : one;
  along.y = along.sound ? dy * part : splat(0);
}

// A box tells how far a node reaches along any direction; how far beside it, `low` to `high`, is known better.
inline void put_frames(const Box* const* boxes, const Directions& along, Lanes low, Lanes high, FourFrames& frames) {
  const Lanes half = splat(0.5);
  Lanes box[lanes];
  for (std::size_t k = 0; k < lanes; ++k) box[k] = load(boxes[k]->lane);
  transpose(box);
  const Lanes x = half * box[0] - half * box[2], y = half * box[1] - half * box[3];
  const Lanes half_width = half * (-box[2] - box[0]), half_height = half * (-box[3] - box[1]);
  const Lanes slack =
      splat(frame_roundings) * (absolute(x) + absolute(y) + half_width + half_height) + splat(0x1p-1000);
  const Lanes beside = half * (low + high) - (along.x * y - along.y * x);
  const Lanes length = half_width * absolute(along.x) + half_height * absolute(along.y);
  store(frames.x, along.sound ? x - beside * along.y : x);
  store(frames.y, along.sound ? y + beside * along.x : y);
  store(frames.along_x, along.x);
  store(frames.along_y, along.y);
  store(frames.length, length + slack);
  store(frames.width, (along.sound ? half * (high - low) : half_height) + slack);
}

inline void put_frames_of_leaves(const Point* const* points, const Box* const* boxes, FourFrames& frames) {
  Lanes low[lanes], high[lanes], dx, dy;
  for (std::size_t k = 0; k < lanes; ++k) {
    const Point from = points[k][0], to = points[k][leaf_size];
    dx[k] = to.x - from.x;
    dy[k] = to.y - from.y;
  }
  Directions along;
  normalise_chords(dx, dy, along);
  for (std::size_t k = 0; k < lanes; ++k) {
    const double* coordinates = &points[k][0].x;
    const Widest ax = splat_widest(along.x[k]), ay = splat_widest(along.y[k]);
    Widest lowest = splat_widest(along.x[k] * points[k][leaf_size].y - along.y[k] * points[k][leaf_size].x),
           highest = lowest;
    for (std::size_t i = 0; i < leaf_size; i += widest) {
      fetch(coordinates + 2 * i, bytes_ahead);
      if constexpr (widest == eight) fetch(coordinates + 2 * i, bytes_ahead + bytes_a_line);
      const Widest first = load_widest(coordinates + 2 * i), second = load_widest(coordinates + 2 * i + widest);
      const Widest beside = ax * odds_crosswise(first, second) - ay * evens_crosswise(first, second);
      lowest = min(lowest, beside);
      highest = max(highest, beside);
    }
    low[k] = least_four(lowest);
    high[k] = greatest_four(highest);
  }
  transpose(low);
  transpose(high);
  put_frames(boxes, along, min(min(low[0], low[1]), min(low[2], low[3])),
             max(max(high[0], high[1]), max(high[2], high[3])), frames);
}

inline void put_joined_frames(const FourFrames* const* below, const Chord* chords, const Box* const* boxes,
                              FourFrames& frames) {
  Lanes low[lanes], high[lanes], dx, dy;
  for (std::size_t k = 0; k < lanes; ++k) {
    dx[k] = chords[k].to.x - chords[k].from.x;
    dy[k] = chords[k].to.y - chords[k].from.y;
  }
  Directions along;
  normalise_chords(dx, dy, along);
  for (std::size_t k = 0; k < lanes; ++k) {
    const Lanes ax = splat(along.x[k]), ay = splat(along.y[k]);
    FrameLanes part;
    load_frames(*below[k], part);
    const Lanes parallel = absolute(ax * part.along_x + ay * part.along_y);
    const Lanes across = absolute(ax * part.along_y - ay * part.along_x);
    const Lanes beside = ax * part.y - ay * part.x, reach = part.length * across + part.width * parallel;
    low[k] = beside - reach;
    high[k] = beside + reach;
  }
  transpose(low);
  transpose(high);
  put_frames(boxes, along, min(min(low[0], low[1]), min(low[2], low[3])),
             max(max(high[0], high[1]), max(high[2], high[3])), frames);
}

// Distances of the middles beside each frame, and along the first, against the reach of both.
inline LaneMask certainly_apart(const FrameLanes& a, const FrameLanes& b) {
  const Lanes dx = b.x - a.x, dy = b.y - a.y;
  const Lanes parallel = absolute(a.along_x * b.along_x + a.along_y * b.along_y);
  const Lanes across = absolute(a.along_x * b.along_y - a.along_y * b.along_x);
  const Lanes beside_a = absolute(a.along_x * dy - a.along_y * dx),
              beside_b = absolute(b.along_x * dy - b.along_y * dx);
  const Lanes along_a = absolute(a.along_x * dx + a.along_y * dy);
  return (beside_a > a.width + (b.width * parallel + b.length * across)) |
         (beside_b > b.width + (a.width * parallel + a.length * across)) |
         (along_a > a.length + (b.length * parallel + b.width * across));
}

inline const FourFrames& frames_at(FramePyramid pyramid, std::uint32_t level, std::uint32_t index) {
  return pyramid.frames[pyramid.begin[level / 2] + index / lanes];
}

// Those of four nodes of the tree that have nothing to do with a node, out of the ones in `bits`.
inline unsigned left_out(const SelfTree& tree, TreeNode node, TreeNode first, unsigned bits) {
  const auto stays = [&](TreeNode at) {
    return tree.stalls && is_point(tree.boxes.boxes[tree.boxes.begin[at.level] + at.index]);
  };
  if (stays(node)) return bits;
  unsigned out = 0;
  for (std::uint32_t i = 0; i < lanes; ++i) {
    if ((bits >> i & 1U) == 0) continue;
    const TreeNode candidate{first.level, first.index + i};
    out |= static_cast<unsigned>(nothing_between(tree, node, candidate) || stays(candidate)) << i;
  }
  return out;
}

// The way down from candidates to those that are no larger than one of the nodes. They are the last
// `splits` of the `capacity` nodes of `out`; the others are put behind the first `kept`. Returns the number of frames
// tested, or 0 if there was not memory.
inline std::size_t descend_to_node(const SelfTree& tree, const FramedNodes& nodes, std::uint32_t which, double largest,
                                   TreeNode* out, std::size_t capacity, std::size_t splits, std::size_t& kept) {
  FrameLanes a, b;
  splat_frame(*nodes.frames, which, a);
  const TreeNode node{nodes.first.level, nodes.first.index + which};
  TreeNode waiting[4 * 16];  // three of each second level, and those of the last
  std::size_t tested = 0;
  for (std::size_t k = 0; k < splits; ++k) {
    std::size_t count = 0;
    waiting[count++] = out[capacity - splits + k];
    while (count > 0) {
      if (kept + lanes + (splits - k) > capacity) return 0;
      const TreeNode above = waiting[--count], first{above.level - 2, above.index * 4};
      const std::uint32_t left = tree.boxes.size[first.level] - first.index;
      load_frames(frames_at(tree.frames, first.level, first.index), b);
      unsigned meets = (left < lanes ? (1U << left) - 1 : 15U) & ~mask_bits(certainly_apart(a, b));
      if (first.index << first.level < nodes.far) meets &= ~left_out(tree, node, first, meets);
      const unsigned small = first.level == 0 ? 15U : mask_bits(b.length + b.width <= splat(largest));
      const NodeLanes four = nodes_from(first);
      kept += put_nodes(four, meets & small, out + kept);
      count += put_nodes(four, meets & ~small, waiting + count);
      tested += lanes;
    }
  }
  return tested;
}

inline std::size_t descend_by_frames(const SelfTree& tree, const FramedNodes& nodes, const TreeNode* list,
                                     std::size_t count, TreeNode* const* met, std::size_t capacity,
                                     std::size_t* met_count) {
  FrameLanes a, b;
  load_frames(*nodes.frames, a);
  const Lanes largest = nodes.first.level == 0 ? splat(-1) : a.length + a.width;
  const unsigned present = (1U << nodes.present) - 1;
  std::size_t kept[lanes] = {}, splits[lanes] = {};
  for (std::size_t k = 0; k < count; ++k) {
    const TreeNode candidate = list[k];
    splat_frame(frames_at(tree.frames, candidate.level, candidate.index), candidate.index % lanes, b);
    unsigned meets = present & ~mask_bits(certainly_apart(a, b));
    if (candidate.index << candidate.level < nodes.far) {
      for (std::uint32_t i = 0; i < nodes.present; ++i) {
        const TreeNode node{nodes.first.level, nodes.first.index + i};
        meets &= ~(left_out(tree, node, candidate, meets >> i & 1U) << i);
      }
    }
    const unsigned small = candidate.level == 0 ? 15U : mask_bits(b.length + b.width <= largest);
    const unsigned keep = meets & small, split = meets & ~small;
    for (std::size_t i = 0; i < lanes; ++i) {
      met[i][kept[i]] = met[i][capacity - 1 - splits[i]] = candidate;
      kept[i] += keep >> i & 1U;
      splits[i] += split >> i & 1U;
    }
  }
  std::size_t tested = nodes.present * count;
  for (std::uint32_t i = 0; i < lanes; ++i) {
    if (splits[i] > 0) {
      const std::size_t below = descend_to_node(tree, nodes, i, largest[i], met[i], capacity, splits[i], kept[i]);
      if (below == 0) return 0;
      tested += below;
    }
    met_count[i] = kept[i];
  }
  return tested;
}

}  // namespace
}  // namespace lober::detail

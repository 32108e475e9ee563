#include "engine/geometry/smooth/near_misses.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/index/pair_walk.hpp"
#include "engine/geometry/smooth/segment_shapes.hpp"
#include "kernels/inline.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t leaf_size_of_arcs = ArcBoxes::segments_a_leaf, samples = 8;

// A bit for each segment of a leaf.
static_assert(leaf_size_of_arcs == 16);
std::uint32_t first_bits(std::size_t count) {
  return (std::uint32_t{1} << count) - 1;
}

Box grown_by(Box box, double by) {
  for (double& lane : box.lane) lane -= by;
  return box;
}

using Samples = std::array<double, samples + 1>;

// Two arcs, the second one from `from2`, as seen from the first end of the first one.
struct ArcPair {
  const SmoothSegment &arc1, &arc2;
  Point from2;

  // Twice the area over the chord of the first arc in which the second one lies on the wrong side of it; nothing where
  // no part of the second chord lies above the first one.
  [[nodiscard]] LOBER_INLINE std::optional<double> hidden() const {
    const Point chord = arc1.chord, chord2 = arc2.chord, left2{-chord2.y, chord2.x}, to2 = from2 + chord2;
    const double square = dot(chord, chord);
    if (!(square > 0) || from2 == to2) return 0.0;
    // Along the first chord and above it, in units of it.
    const double begin = dot(chord, from2) / square, end = dot(chord, to2) / square;
    const double from = cross(chord, from2) / square, to = cross(chord, to2) / square;
    // The side that the segments have of each other, in the middle of what they have above one another.
    const double low = std::max(std::min(begin, end), 0.0), high = std::min(std::max(begin, end), 1.0);
    if (!(low < high)) return std::nullopt;
    const double apart = from + ((low + high) / 2 - begin) / (end - begin) * (to - from);
    if (apart == 0) return 0.0;
    // The second arc may be far longer: its part above the first one, and somewhat more, as it is curved.
    constexpr double more_of_it = 0.125;
    const double u = (low - begin) / (end - begin), v = (high - begin) / (end - begin), aside = more_of_it * (v - u);
    const double first = std::clamp(u - aside, 0.0, 1.0), last = std::clamp(v + aside, 0.0, 1.0);
    const double along_left = dot(chord, left2) / square, above_left = cross(chord, left2) / square;
    // Loop by loop, several samples at a time.
    Samples at, depth, bent, height;
    for (std::size_t k = 0; k <= samples; ++k) at[k] = first + static_cast<double>(k) / samples * (last - first);
    arc2.f_at(at, bent);
    for (std::size_t k = 0; k <= samples; ++k) {
      depth[k] = from + at[k] * (to - from) + bent[k] * above_left;
      at[k] = begin + at[k] * (end - begin) + bent[k] * along_left;
    }
    for (double& x : at) x = std::clamp(x, 0.0, 1.0);
    arc1.f_at(at, height);
    const double side = apart > 0 ? 1 : -1;
    for (std::size_t k = 0; k <= samples; ++k) depth[k] = side * (height[k] - depth[k]);
    // Between samples it may be deeper.
    double bend = 0;
    for (std::size_t k = 1; k < samples; ++k)
      bend = std::max(bend, std::fabs(depth[k - 1] - 2 * depth[k] + depth[k + 1]));
    const double more = bend / 8 + (arc1.error + arc2.error) / square;
    double area = 0;
    for (std::size_t k = 0; k < samples; ++k) {
      const double deep = std::max(depth[k] + more, 0.0) + std::max(depth[k + 1] + more, 0.0);
      area += deep * std::fabs(at[k + 1] - at[k]);
    }
    return area * square;
  }
};

// The points of a leaf.
struct LeafPoints {
  std::size_t begin, count;  // segments
  std::array<double, leaf_size_of_arcs + 1> x, y;

  LeafPoints(const ArcsOfCurve& on, std::size_t leaf)
      : begin(leaf * leaf_size_of_arcs), count(on.boxes.end(leaf) - begin) {
    const auto first = static_cast<std::int64_t>(begin);
    const Point* const points = on.curve.points(first, leaf_size_of_arcs + 1);
    for (std::size_t k = 0; k <= leaf_size_of_arcs; ++k) {
      // Behind the end of the curve its last point.
      const Point here =
          points != nullptr ? points[k] : on.curve.vertex(first + static_cast<std::int64_t>(std::min(k, count)));
      x[k] = here.x;
      y[k] = here.y;
    }
  }
  [[nodiscard]] Point at(std::size_t k) const { return {x[k], y[k]}; }
  // The bits of segments that meet the box.
  [[nodiscard]] std::uint32_t near(const Box& box) const {
    const double low_x = box.min_x(), high_x = box.max_x(), low_y = box.min_y(), high_y = box.max_y();
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < leaf_size_of_arcs; ++k) {
      const bool apart = std::max(x[k], x[k + 1]) < low_x || std::min(x[k], x[k + 1]) > high_x ||
                         std::max(y[k], y[k + 1]) < low_y || std::min(y[k], y[k + 1]) > high_y;
      bits |= static_cast<std::uint32_t>(!apart) << k;
    }
    return bits & first_bits(count);
  }
};

// Whether the ends of one segment lie on one side of the other's line, and farther from it than that.
bool keeps_away(Point a, Point b, Point c, Point d, double by) {
  const Point along = b - a;
  const double from = cross(along, c - a), to = cross(along, d - a);
  if ((from > 0) != (to > 0)) return false;
  const double least = std::min(std::fabs(from), std::fabs(to));
  return least * least > by * by * (along.x * along.x + along.y * along.y);
}
bool keep_away(Point a, Point b, Point c, Point d, double by) {
  return keeps_away(a, b, c, d, by) || keeps_away(c, d, a, b, by);
}
bool keep_away(const ArcStrip& one, const ArcStrip& other) {
  return keep_away(one.from, one.to, other.from, other.to, one.width + other.width);
}

// The boxes of a curve's arcs, for a walk.
class ArcNodes {
 public:
  explicit ArcNodes(const ArcsOfCurve& arcs) : boxes_(arcs.boxes) {}
  [[nodiscard]] BoxLevel level(std::uint32_t level) const { return boxes_.level(level); }

 private:
  const ArcBoxes& boxes_;
};

// Pairs of nodes of which both have nothing but segments about nodes of the curves.
class LeftOutAboutNodes {
 public:
  LeftOutAboutNodes(const NodeSegments& about1, const NodeSegments& about2) : about1_(about1), about2_(about2) {}
  [[nodiscard]] bool none_below(TreeNode first, TreeNode second) const {
    return about1_.others_everywhere(first) || about2_.others_everywhere(second);
  }
  [[nodiscard]] bool operator()(TreeNode first, TreeNode second) const {
    return !about1_.any_others(first) && !about2_.any_others(second);
  }

 private:
  const NodeSegments &about1_, &about2_;
};

using ArcWalk = PairWalk<ArcNodes, LeftOutAboutNodes>;

// In leaves that a walk finds to meet, pairs of segments that come near are collected, then their arcs
// compared.
class NearPairs {
 public:
  NearPairs(const ArcsOfCurve& c1, const ArcsOfCurve& c2, const ArcWalk& walk)
      : c1_(c1), c2_(c2), walk_(walk), no_nodes_(c1.about.none() && c2.about.none()) {}

  /// Goes through the leaves of C1 below one of its nodes, which meets those of the list.
  void go_down(TreeNode node, std::span<const TreeNode> list) {
    const auto [level, pairs] = walk_.pairs_below(node, 0, list, pairs_at_once, counts_);
    if (level == 0) {
      pairs.for_each_list([&](const PairList& found, std::uint32_t) {
        for (std::size_t k = 0; k < found.count; ++k) look_at(found.pair[k].first, found.pair[k].second);
      });
      return;
    }
    MeetingLists lists;
    const std::uint32_t begin = node.index << (node.level - level);
    lists.sort_in(pairs, begin, std::size_t{1} << (node.level - level));
    for (std::uint32_t k = 0; k < lists.size(); ++k) {
      if (!lists[k].empty()) go_down({level, begin + k}, lists[k]);
    }
  }
  [[nodiscard]] double area() {
    compare();
    return area_;
  }

 private:
  void look_at(std::uint32_t leaf1, std::uint32_t leaf2) {
    const ArcBoxes &boxes1 = c1_.boxes, &boxes2 = c2_.boxes;
    // Boxes of folds that lie close together all meet.
    if (keep_away(boxes1.strip(leaf1), boxes2.strip(leaf2))) return;
    const LeafPoints points1(c1_, leaf1), points2(c2_, leaf2);
    const std::uint32_t near1 = points1.near(grown_by(boxes2.box({0, leaf2}), boxes1.bend(leaf1)));
    const std::uint32_t near2 = points2.near(grown_by(boxes1.box({0, leaf1}), boxes2.bend(leaf2)));
    const std::uint32_t free1 = near1 & c1_.about.others(leaf1), free2 = near2 & c2_.about.others(leaf2);
    if ((free1 == 0 || near2 == 0) && (free2 == 0 || near1 == 0)) return;
    const double bend = boxes1.bend(leaf1) + boxes2.bend(leaf2);
    add(points1, free1, points2, near2, bend);
    add(points1, near1 & ~free1, points2, free2, bend);
  }
  void add(const LeafPoints& points1, std::uint32_t which1, const LeafPoints& points2, std::uint32_t which2,
           double bend) {
    if (which2 == 0) return;
    for (; which1 != 0; which1 &= which1 - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(which1));
      const Point a = points1.at(i), b = points1.at(i + 1);
      for (std::uint32_t left = which2 & points2.near(grown_by(Box::of(a, b), bend)); left != 0; left &= left - 1) {
        const auto j = static_cast<std::size_t>(std::countr_zero(left));
        const Point c = points2.at(j), d = points2.at(j + 1);
        if (keep_away(a, b, c, d, bend)) continue;
        pairs_.push_back({static_cast<std::int64_t>(points1.begin + i), static_cast<std::int64_t>(points2.begin + j)});
        if (pairs_.size() == together) compare();
      }
    }
  }

  // Seldom called, apart from the loop of the pairs.
  [[nodiscard, gnu::noinline]] static double hidden_above(const ArcPair& pair) { return pair.hidden().value_or(0); }
  static bool steep(Point chord, Point other) { return std::fabs(cross(chord, other)) > std::fabs(dot(chord, other)); }
  void compare() {
    SegmentShapes shapes1(c1_.curve, pairs_.size()), shapes2(c2_.curve, pairs_.size());
    for (Pair& pair : pairs_) {
      pair.shape1 = shapes1.ask_for(pair.segment1);
      pair.shape2 = shapes2.ask_for(pair.segment2);
    }
    shapes1.fit();
    shapes2.fit();
    for (const Pair& pair : pairs_) {
      const Point a = c1_.curve.vertex(pair.segment1), c = c2_.curve.vertex(pair.segment2);
      const SmoothSegment &arc1 = shapes1[pair.shape1], &arc2 = shapes2[pair.shape2];
      const std::optional<double> above = ArcPair{arc1, arc2, c - a}.hidden();
      if (above)
        area_ += *above;
      else if (no_nodes_ && steep(arc1.chord, arc2.chord))
        area_ += hidden_above({arc2, arc1, a - c});
    }
    pairs_.clear();
  }

  static constexpr std::size_t together = 1024;
  struct Pair {
    std::int64_t segment1, segment2;
    std::uint32_t shape1 = 0, shape2 = 0;
  };
  const ArcsOfCurve &c1_, &c2_;
  const ArcWalk& walk_;
  // Where polygons cross nowhere, nothing but the areas found here tells that arcs may: then those of few points, whose
  // chords lead elsewhere, are compared along the second chord too.
  bool no_nodes_;
  SearchCounts counts_;
  std::vector<Pair> pairs_;
  double area_ = 0;
};

}  // namespace

NodeSegments::NodeSegments(std::size_t segments)
    : size_(segments), about_node_((segments + leaf_size_of_arcs - 1) / leaf_size_of_arcs * leaf_size_of_arcs, 0) {}

void NodeSegments::mark(double from, double to, std::uint8_t about) {
  const auto size = static_cast<std::int64_t>(size_);
  const auto first = static_cast<std::int64_t>(std::floor(std::min(from, to))) - 1;
  const auto last = static_cast<std::int64_t>(std::floor(std::max(from, to))) + 1;
  for (std::int64_t k = first; k <= std::min(last, first + size - 1); ++k) {
    const std::int64_t segment = k >= 0 && k < size ? k : (k % size + size) % size;
    std::atomic_ref(about_node_[static_cast<std::size_t>(segment)]).store(about, std::memory_order_relaxed);
  }
}

void NodeSegments::join() {
  none_ = std::find(about_node_.begin(), about_node_.end(), 1) == about_node_.end();
  const std::size_t leaves = about_node_.size() / leaf_size_of_arcs;
  others_.resize(leaves);
  for (std::size_t leaf = 0; leaf < leaves; ++leaf) {
    std::array<std::uint64_t, leaf_size_of_arcs / 8> bytes;
    std::memcpy(bytes.data(), about_node_.data() + leaf * leaf_size_of_arcs, sizeof bytes);
    // Byte k, 0 or 1, as bit k: no carries reach the top byte.
    std::uint32_t bits = 0;
    for (std::size_t k = bytes.size(); k-- > 0;)
      bits = bits << 8 | static_cast<std::uint32_t>((bytes[k] * 0x0102040810204080U) >> 56);
    others_[leaf] = ~bits & first_bits(std::min(size_ - leaf * leaf_size_of_arcs, leaf_size_of_arcs));
  }
  levels_.emplace_back(leaves);
  for (std::size_t leaf = 0; leaf < leaves; ++leaf) levels_[0][leaf] = others_[leaf] != 0 ? any | everywhere : 0;
  while (levels_.back().size() > 1) {
    const Buffer<std::uint8_t>& below = levels_.back();
    Buffer<std::uint8_t> level((below.size() + 1) / 2);
    for (std::size_t k = 0; k < level.size(); ++k) {
      const std::uint8_t first = below[2 * k], second = below[std::min(2 * k + 1, below.size() - 1)];
      level[k] = ((first | second) & any) | (first & second & everywhere);
    }
    levels_.push_back(std::move(level));
  }
}

double hidden_area(const ArcsOfCurve& c1, const ArcsOfCurve& c2) {
  // Few leaves are one task.
  constexpr std::uint32_t tasks = 256;
  const ArcBoxes& boxes = c1.boxes;
  std::uint32_t level = top_of(boxes.levels()).level;
  if (boxes.nodes(0) > tasks) {
    while (level > levels_at_once && boxes.nodes(level - levels_at_once) <= tasks) level -= levels_at_once;
  }
  const ArcNodes arcs1(c1), arcs2(c2);
  const ArcWalk walk(arcs1, arcs2, {c1.about, c2.about});
  const std::vector<TreeNode> roots = roots_of(c2.boxes.levels());
  std::vector<double> areas(level < boxes.levels() ? boxes.nodes(level) : 1);
  for_each_block(areas.size(), 1, [&](std::size_t k, std::size_t) {
    NearPairs pairs(c1, c2, walk);
    pairs.go_down({level, static_cast<std::uint32_t>(k)}, roots);
    areas[k] = pairs.area();
  });
  double area = 0;
  for (const double part : areas) area += part;
  return area;
}

}  // namespace lober::detail

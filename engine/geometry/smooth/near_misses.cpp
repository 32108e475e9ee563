#include "engine/geometry/smooth/near_misses.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/smooth/segment_shapes.hpp"

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

// Two arcs with that vertices before them, seen from the first end of the first one.
struct ArcPair {
  const SmoothSegment &arc1, &arc2;
  Point from2;

  // Twice the area over the chord of the first arc in which the second one lies on the wrong side of it.
  [[nodiscard]] double hidden() const {
    const Point chord = arc1.chord, to2{from2.x + arc2.chord.x, from2.y + arc2.chord.y};
    const double square = chord.x * chord.x + chord.y * chord.y;
    if (!(square > 0) || from2 == to2) return 0;
    const auto along = [&](Point at) { return (chord.x * at.x + chord.y * at.y) / square; };
    const auto above = [&](Point at) { return cross(chord, at) / square; };
    // The side that the segments have of each other, in the middle of what they have above one another.
    const double begin = along(from2), end = along(to2), from = above(from2), to = above(to2);
    const double low = std::max(std::min(begin, end), 0.0), high = std::min(std::max(begin, end), 1.0);
    if (!(low < high)) return 0;
    const double apart = from + ((low + high) / 2 - begin) / (end - begin) * (to - from);
    if (apart == 0) return 0;
    std::array<double, samples + 1> at{}, depth{};
    for (std::size_t k = 0; k <= samples; ++k) {
      const Point point = arc2.at(static_cast<double>(k) / samples);
      const Point there{from2.x + point.x, from2.y + point.y};
      at[k] = std::clamp(along(there), 0.0, 1.0);
      double height = arc1.f[5];
      for (std::size_t power = 5; power-- > 0;) height = height * at[k] + arc1.f[power];
      depth[k] = apart > 0 ? height - above(there) : above(there) - height;
    }
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

bool keep_away(const ArcStrip& one, const ArcStrip& other) {
  const double width = one.width + other.width;
  return keeps_away(one.from, one.to, other.from, other.to, width) ||
         keeps_away(other.from, other.to, one.from, one.to, width);
}

// The segments below one node of C1's boxes: pairs that come near are collected, then their arcs compared.
class NearPairs {
 public:
  NearPairs(const ArcsOfCurve& c1, const ArcsOfCurve& c2) : c1_(c1), c2_(c2) {}

  struct Node {
    std::size_t level, index;
  };
  void walk(Node node1, Node node2) {
    const Box &box1 = c1_.boxes.boxes(node1.level)[node1.index], &box2 = c2_.boxes.boxes(node2.level)[node2.index];
    if (meet(box1, box2) && any_others(node1, node2)) below(node1, node2, box1, box2);
  }
  [[nodiscard]] double area() {
    compare();
    return area_;
  }

 private:
  // Divides both of two nodes whose boxes meet, or one that is larger by far.
  void below(Node node1, Node node2, const Box& box1, const Box& box2) {
    // Boxes of folds that lie close together all meet; above, strips are as wide.
    constexpr std::size_t levels_with_strips = 3;
    if (std::max(node1.level, node2.level) < levels_with_strips &&
        keep_away(c1_.boxes.strips(node1.level)[node1.index], c2_.boxes.strips(node2.level)[node2.index])) {
      return;
    }
    if (node1.level == 0 && node2.level == 0) return look_at(node1.index, node2.index);
    constexpr double by_far = 2;
    const double extent1 = box1.extent(), extent2 = box2.extent();
    const bool first = node1.level > 0 && (node2.level == 0 || extent2 <= by_far * extent1);
    const bool second = node2.level > 0 && (node1.level == 0 || extent1 <= by_far * extent2);
    const Children of1(c1_, node1, first), of2(c2_, node2, second);
    for (std::size_t i = of1.begin; i < of1.end; ++i) {
      const Box& child1 = of1.boxes[i];
      const BoxQuery query(child1);
      if (first && second && !meet(query, box2)) continue;
      for (std::size_t j = of2.begin; j < of2.end; ++j) {
        if (!meet(query, of2.boxes[j])) continue;
        const Node below1{of1.level, i}, below2{of2.level, j};
        if (any_others(below1, below2)) below(below1, below2, child1, of2.boxes[j]);
      }
    }
  }
  // The children of a node, or the node itself.
  struct Children {
    std::size_t level, begin, end;
    const Box* boxes;
    Children(const ArcsOfCurve& on, Node node, bool divided)
        : level(divided ? node.level - 1 : node.level), boxes(on.boxes.boxes(level).data()) {
      begin = divided ? ArcBoxes::children * node.index : node.index;
      end = divided ? std::min(begin + ArcBoxes::children, on.boxes.boxes(level).size()) : begin + 1;
    }
  };

  [[nodiscard]] bool any_others(Node node1, Node node2) const {
    return c1_.about.any_others(node1.level, node1.index) || c2_.about.any_others(node2.level, node2.index);
  }

  void look_at(std::size_t leaf1, std::size_t leaf2) {
    const double bend = c1_.boxes.bend(leaf1) + c2_.boxes.bend(leaf2);
    const LeafPoints points1(c1_, leaf1), points2(c2_, leaf2);
    const std::uint32_t near1 = points1.near(grown_by(c2_.boxes.boxes(0)[leaf2], c1_.boxes.bend(leaf1)));
    const std::uint32_t near2 = points2.near(grown_by(c1_.boxes.boxes(0)[leaf1], c2_.boxes.bend(leaf2)));
    const std::uint32_t free1 = near1 & c1_.about.others(leaf1), free2 = near2 & c2_.about.others(leaf2);
    if ((free1 == 0 || near2 == 0) && (free2 == 0 || near1 == 0)) return;
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
        if (keeps_away(a, b, c, d, bend) || keeps_away(c, d, a, b, bend)) continue;
        pairs_.push_back({static_cast<std::int64_t>(points1.begin + i), static_cast<std::int64_t>(points2.begin + j)});
        if (pairs_.size() == together) compare();
      }
    }
  }

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
      area_ += ArcPair{shapes1[pair.shape1], shapes2[pair.shape2], c - a}.hidden();
    }
    pairs_.clear();
  }

  static constexpr std::size_t together = 1024;
  struct Pair {
    std::int64_t segment1, segment2;
    std::uint32_t shape1 = 0, shape2 = 0;
  };
  const ArcsOfCurve &c1_, &c2_;
  std::vector<Pair> pairs_;
  double area_ = 0;
};

}  // namespace

NodeSegments::NodeSegments(std::size_t segments)
    : size_(segments), about_node_((segments + leaf_size_of_arcs - 1) / leaf_size_of_arcs * leaf_size_of_arcs, 0) {}

void NodeSegments::add(double from, double to) {
  const auto size = static_cast<std::int64_t>(size_);
  const auto first = static_cast<std::int64_t>(std::floor(std::min(from, to))) - 1;
  const auto last = static_cast<std::int64_t>(std::floor(std::max(from, to))) + 1;
  for (std::int64_t k = first; k <= std::min(last, first + size - 1); ++k) {
    const std::int64_t segment = k >= 0 && k < size ? k : (k % size + size) % size;
    std::atomic_ref(about_node_[static_cast<std::size_t>(segment)]).store(1, std::memory_order_relaxed);
  }
}

void NodeSegments::join() {
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
  for (std::size_t size = leaves; size > 1;) {
    const std::size_t above = (size + ArcBoxes::children - 1) / ArcBoxes::children;
    Buffer<std::uint8_t> level(above);
    for (std::size_t k = 0; k < above; ++k) {
      bool any = false;
      for (std::size_t j = k * ArcBoxes::children; j < std::min((k + 1) * ArcBoxes::children, size); ++j)
        any = any || any_others(levels_.size(), j);
      level[k] = any ? 1 : 0;
    }
    levels_.push_back(std::move(level));
    size = above;
  }
}

double hidden_area(const ArcsOfCurve& c1, const ArcsOfCurve& c2) {
  constexpr std::size_t tasks = 256;
  std::size_t level = 0;
  while (level + 1 < c1.boxes.levels() && c1.boxes.boxes(level).size() > tasks) ++level;
  std::vector<double> areas(c1.boxes.boxes(level).size());
  for_each_block(areas.size(), 1, [&](std::size_t k, std::size_t) {
    NearPairs pairs(c1, c2);
    pairs.walk({level, k}, {c2.boxes.levels() - 1, 0});
    areas[k] = pairs.area();
  });
  double area = 0;
  for (const double part : areas) area += part;
  return area;
}

}  // namespace lober::detail

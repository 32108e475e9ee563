#include "engine/geometry/smooth/arc_boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/parallel/parallel.hpp"

namespace lober::detail {
namespace {

// A bend of this part of a leaf's box comes from corners or from uneven points: segments of smooth curves turn less.
constexpr double uneven = 1.0 / (32 * ArcBoxes::segments_a_leaf);

// Both coordinates of a point.
using Pair = double __attribute__((vector_size(16)));
Pair pair_of(Point point) {
  return Pair{point.x, point.y};
}
Pair least(Pair a, Pair b) {
  return a < b ? a : b;
}
Pair largest(Pair a, Pair b) {
  return a > b ? a : b;
}

struct Extremes {
  Pair low, high, bend;
};

// For the `count` points after the first one; the bend is half the size of the largest second difference of three
// points in a row. An arc of a circle keeps |chord| / 8 times the turn of its tangent from the chord, the turn at a
// vertex is half of that or more, and the second difference there no less than it times the chord: a quarter of it
// would do, however long the segment on the other side is.
Extremes extremes_of(const Point* points, std::size_t count) {
  Pair here = pair_of(points[1]), step = here - pair_of(points[0]);
  Extremes e{here, here, {0, 0}};
  for (std::size_t k = 1; k <= count; ++k) {
    const Pair next = pair_of(points[k + 1]), next_step = next - here, bend = next_step - step;
    e.low = least(e.low, here);
    e.high = largest(e.high, here);
    e.bend = largest(e.bend, largest(bend, -bend));
    here = next;
    step = next_step;
  }
  return e;
}

// The same bound by turns alone, for points that are not evenly spaced. A turn by more than 45 degrees is a corner, and
// bends no arc.
double bend_by_turns(const Point* points, std::size_t count) {
  double most = 0;
  for (std::size_t k = 1; k <= count; ++k) {
    const Point in = points[k] - points[k - 1], out = points[k + 1] - points[k];
    const double turn = cross(in, out), ahead = in.x * out.x + in.y * out.y;
    if (!(std::fabs(turn) <= ahead)) continue;
    const double shorter = std::min(in.x * in.x + in.y * in.y, out.x * out.x + out.y * out.y);
    if (shorter > 0) most = std::max(most, turn * turn / shorter);
  }
  return std::sqrt(most) / 2;
}

// The largest distance of points from the chord between the first and the last one.
double distance_from_chord(const Point* points, std::size_t count) {
  const Point from = points[0], along = points[count - 1] - from;
  const double square = along.x * along.x + along.y * along.y;
  double most = 0, farthest = 0;
  for (std::size_t k = 1; k + 1 < count; ++k) {
    const double x = points[k].x - from.x, y = points[k].y - from.y;
    const double height = std::fabs(along.x * y - along.y * x);
    most = height > most ? height : most;
    const double far = x * x + y * y;
    farthest = far > farthest ? far : farthest;
  }
  return square > 0 ? most / std::sqrt(square) : std::sqrt(farthest);
}

}  // namespace

ArcBoxes::ArcBoxes(const SmoothCurve& curve) : curve_(&curve), segments_(curve.segments()) {
  size_[0] = static_cast<std::uint32_t>((segments_ + segments_a_leaf - 1) / segments_a_leaf);
  for (; size_[levels_ - 1] > 1; ++levels_) {
    begin_[levels_] = begin_[levels_ - 1] + size_[levels_ - 1];
    size_[levels_] = (size_[levels_ - 1] + 1) / 2;
  }
  constexpr std::size_t readable = 3;
  boxes_.resize(begin_[levels_ - 1] + size_[levels_ - 1] + readable);
  strips_.resize(size_[0]);
  bends_.resize(size_[0]);
}

void ArcBoxes::add(std::size_t begin, std::size_t end) {
  std::array<Point, segments_a_leaf + 3> copied;
  for (std::size_t from = begin; from < end; from += segments_a_leaf) {
    const std::size_t leaf = from / segments_a_leaf, points = this->end(leaf) - from + 1;
    const Point* window = curve_->points(static_cast<std::int64_t>(from) - 1, points + 2);
    if (window == nullptr) {
      for (std::size_t k = 0; k < points + 2; ++k) copied[k] = curve_->vertex(static_cast<std::int64_t>(from + k) - 1);
      window = copied.data();
    }
    const Extremes e = extremes_of(window, points);
    double bend = std::sqrt(e.bend[0] * e.bend[0] + e.bend[1] * e.bend[1]) / 2;
    const double extent = e.high[0] - e.low[0] + (e.high[1] - e.low[1]);
    if (bend > uneven * extent && !SmoothCurve::repeats({window, points + 2}))
      bend = std::min(bend, bend_by_turns(window, points));
    boxes_[leaf] = {{e.low[0] - bend, e.low[1] - bend, -(e.high[0] + bend), -(e.high[1] + bend)}};
    bends_[leaf] = bend;
    strips_[leaf] = {window[1], window[points], distance_from_chord(window + 1, points) + bend};
  }
}

void ArcBoxes::add_all() {
  constexpr std::size_t block = 64 * segments_a_leaf;
  for_each_block(segments_, block, [this](std::size_t begin, std::size_t end) { add(begin, end); });
  join();
}

void ArcBoxes::join() {
  for (std::uint32_t level = 1; level < levels_; ++level) {
    const Box* const below = &boxes_[begin_[level - 1]];
    for (std::uint32_t k = 0; k < size_[level]; ++k) {
      const Box& first = below[2 * std::size_t{k}];
      boxes_[begin_[level] + k] = 2 * k + 1 < size_[level - 1] ? union_of(first, (&first)[1]) : first;
    }
  }
}

}  // namespace lober::detail

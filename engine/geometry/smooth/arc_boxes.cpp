#include "engine/geometry/smooth/arc_boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/parallel/parallel.hpp"

namespace lober::detail {
namespace {

// A bend of this part of a leaf's box comes from corners, or from points that are uneven or few.
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
    if (shorter > 0) most = std::max(most, turn / shorter * turn);  // without underflow
  }
  return std::sqrt(most) / 2;
}

// A bound of the distance of points from the chord between the first and the last one. A fold leads beyond the ends of
// the chord, where its line does not measure that: by as much at most as the diagonal of the points' box is longer.
double distance_from_chord(const Point* points, std::size_t count, double diagonal) {
  const Point from = points[0], along = points[count - 1] - from;
  const double square = dot(along, along);
  if (!(square > 0)) return diagonal;
  double most = 0;
  for (std::size_t k = 1; k + 1 < count; ++k) {
    const double height = std::fabs(cross(along, points[k] - from));
    most = height > most ? height : most;
  }
  const double length = std::sqrt(square);
  return most / length + std::max(diagonal - length, 0.0);
}

// How far the arcs of `count` segments from points[1] on may lie beside where they are fitted, by the errors of their
// areas: one that grows and falls like u (1 - u) along the arc is 3/4 of that at its largest.
double largest_error(const Point* points, std::size_t count, const double* errors) {
  double most = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Point along = points[k + 2] - points[k + 1];
    const double square = dot(along, along);
    if (square > 0) most = std::max(most, errors[k] / square * errors[k]);
  }
  return std::sqrt(most);
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
  std::fill(boxes_.end() - readable, boxes_.end(), Box{});
  strips_.resize(size_[0]);
  bends_.resize(size_[0]);
}

void ArcBoxes::add(std::size_t begin, std::size_t end, const double* errors) {
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
    const double width = e.high[0] - e.low[0], height = e.high[1] - e.low[1], extent = width + height;
    if (bend > uneven * extent) {
      if (!SmoothCurve::repeats({window, points + 2})) bend = std::min(bend, bend_by_turns(window, points));
      bend +=
          errors != nullptr ? largest_error(window, points - 1, errors + (from - begin)) : error_of_leaf(leaf, window);
    }
    boxes_[leaf] = {{e.low[0] - bend, e.low[1] - bend, -(e.high[0] + bend), -(e.high[1] + bend)}};
    bends_[leaf] = bend;
    strips_[leaf] = {window[1], window[points],
                     distance_from_chord(window + 1, points, std::sqrt(width * width + height * height)) + bend};
  }
}

double ArcBoxes::error_of_leaf(std::size_t leaf, const Point* window) const {
  const std::size_t first = leaf * segments_a_leaf, last = end(leaf);
  SmoothCurve::Few few;
  curve_->fit(first, last, few);
  return largest_error(window, last - first, few.errors.data());
}

void ArcBoxes::add_all() {
  constexpr std::size_t block = 64 * segments_a_leaf;
  for_each_block(segments_, block, [this](std::size_t begin, std::size_t end) { add(begin, end, nullptr); });
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

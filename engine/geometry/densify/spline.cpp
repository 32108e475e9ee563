#include "engine/geometry/densify/spline.hpp"

#include <cmath>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/point.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t spline_block = 4096;
constexpr std::ptrdiff_t guard = 128;  // 2^-128 of the second derivative there: nothing, for any curve that has points

// Rows of one block, eliminated downwards: M_k = value - factor M_{k+1}.
struct Row {
  double factor;
  Point value;
};

class Solver {
 public:
  Solver(CurveView curve, Buffer<Point>& second)
      : curve_(curve), size_(static_cast<std::ptrdiff_t>(curve.points.size())), second_(second) {}

  // Fills second_[begin, end).
  void solve(std::ptrdiff_t begin, std::ptrdiff_t end) {
    const bool starts = !curve_.closed && begin - guard <= 1;
    const bool stops = !curve_.closed && end + guard >= size_ - 1;
    const std::ptrdiff_t low = starts ? 1 : begin - guard, high = stops ? size_ - 1 : end + guard;
    rows_.resize(static_cast<std::size_t>(high - low));
    Point before = difference(low - 1);
    double length_before = std::sqrt(dot(before, before));
    Row last{0, {}};  // the row above the first is M = 0
    for (std::ptrdiff_t k = low; k < high; ++k) {
      const Point after = difference(k);
      const double length_after = std::sqrt(dot(after, after));
      double left = length_before, middle = 2 * (length_before + length_after), right = length_after;
      const Point jump{6 * (after.x / length_after - before.x / length_before),
                       6 * (after.y / length_after - before.y / length_before)};
      if (starts && stops && size_ == 3) {
        left = right = 0;  // M is constant: a parabola
        middle = 3 * (length_before + length_after);
      } else if (starts && k == 1) {
        not_a_knot(left, middle, right);
      } else if (stops && k == size_ - 2) {
        not_a_knot(right, middle, left);
      }
      const double inverse = 1 / (middle - left * last.factor);
      last = {right * inverse, {(jump.x - left * last.value.x) * inverse, (jump.y - left * last.value.y) * inverse}};
      rows_[static_cast<std::size_t>(k - low)] = last;
      before = after;
      length_before = length_after;
    }
    Point next{};
    for (std::ptrdiff_t k = high - 1; k >= low; --k) {
      const Row& row = rows_[static_cast<std::size_t>(k - low)];
      next = {row.value.x - row.factor * next.x, row.value.y - row.factor * next.y};
      if (k >= begin && k < end) second_[static_cast<std::size_t>(k)] = next;
    }
  }

 private:
  // The spline is one cubic across the vertex next to an end: M_end = M_near + (M_near - M_far) h_end / h_far. Puts
  // that into the row of the vertex, where `ending` is the coefficient of M_end, `far` that of M_far.
  static void not_a_knot(double& ending, double& middle, double& far) {
    middle += ending * (1 + ending / far);
    far -= ending * ending / far;
    ending = 0;
  }

  [[nodiscard]] Point vertex(std::ptrdiff_t k) const {
    if (k < 0 || k >= size_) k = ((k % size_) + size_) % size_;
    return curve_.points[static_cast<std::size_t>(k)];
  }
  [[nodiscard]] Point difference(std::ptrdiff_t k) const { return vertex(k + 1) - vertex(k); }

  CurveView curve_;
  std::ptrdiff_t size_;
  Buffer<Point>& second_;
  std::vector<Row> rows_;
};

// M at an end from the not-a-knot condition; `near` and `far` are the next two vertices.
Point at_end(Point end, Point near, Point far, Point second_near, Point second_far) {
  const Point e = near - end, f = far - near;
  const double ratio = std::sqrt((e.x * e.x + e.y * e.y) / (f.x * f.x + f.y * f.y));
  return {second_near.x + ratio * (second_near.x - second_far.x),
          second_near.y + ratio * (second_near.y - second_far.y)};
}

}  // namespace

Buffer<Point> spline_second_derivatives(CurveView curve) {
  const std::span<const Point> points = curve.points;
  const std::size_t size = points.size();
  Buffer<Point> second(size);
  if (!curve.closed && size == 2) {
    second[0] = second[1] = {};
    return second;
  }
  for_each_block(size, spline_block, [&](std::size_t begin, std::size_t end) {
    if (!curve.closed) {
      begin = begin == 0 ? 1 : begin;
      end = end == size ? size - 1 : end;
      if (begin >= end) return;
    }
    Solver(curve, second).solve(static_cast<std::ptrdiff_t>(begin), static_cast<std::ptrdiff_t>(end));
  });
  if (curve.closed) return second;
  if (size == 3) {
    second[0] = second[2] = second[1];
  } else {
    second[0] = at_end(points[0], points[1], points[2], second[1], second[2]);
    second[size - 1] = at_end(points[size - 1], points[size - 2], points[size - 3], second[size - 2], second[size - 3]);
  }
  return second;
}

}  // namespace lober::detail

// A closed polygon on an integer grid fine enough to hold every one of its doubles exactly.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "kernels/point.hpp"
#include "tests/oracle/exact_number.hpp"

namespace lober::oracle {
using namespace lober::detail;

/// The polygon without repeated vertices, counter-clockwise, vertex 0 the caller's vertex 0.
/// Coordinates are x * 2^exponent; segment i starts at vertex i and runs along (dx, dy).
struct ExactCurve {
  std::vector<Point> points;  ///< the same vertices as doubles: comparing them is exact too
  std::vector<Integer> x, y, dx, dy;
  std::vector<Integer> offset;  ///< d x start, so that the side of a point takes two products
  Integer twice_area;           ///< positive unless the polygon is degenerate
  int exponent = 0;
  bool reversed = false;  ///< the caller's order was clockwise

  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] std::size_t after(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
};

/// The largest exponent e such that every coordinate of both is a multiple of 2^e.
[[nodiscard]] int common_exponent(std::span<const Point> first, std::span<const Point> second);

[[nodiscard]] ExactCurve exact_curve(std::span<const Point> points, int exponent);

/// +1 if vertex j of `other` lies to the left of the line through segment i of `curve`, 0 on it, -1 right.
[[nodiscard]] int side(const ExactCurve& curve, std::size_t i, const ExactCurve& other, std::size_t j);

/// Whether the bounding boxes of two segments have a point in common; exact, as it only compares doubles.
[[nodiscard]] bool boxes_meet(const ExactCurve& first, std::size_t i, const ExactCurve& second, std::size_t j);

/// Whether a point known to be on the line of segment i is on the segment, ends included.
[[nodiscard]] bool within_box(const ExactCurve& curve, std::size_t i, const Point& point);

/// Sign of the cross product of two segment directions.
[[nodiscard]] int turn(const ExactCurve& first, std::size_t i, const ExactCurve& second, std::size_t j);

/// Whether vertex j of `other`, which is not on `curve`, is inside.
[[nodiscard]] bool contains(const ExactCurve& curve, const ExactCurve& other, std::size_t j);

/// Whether the closed polygon is simple: at least three vertices after dropping repeated ones, no two
/// segments meet except neighbours in their common vertex. O(n^2).
[[nodiscard]] bool is_simple(std::span<const Point> points);

}  // namespace lober::oracle

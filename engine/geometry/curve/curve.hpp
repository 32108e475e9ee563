// Curves: what they are and whether they can be used.
//
// A curve is an ordered list of vertices joined by straight segments; segment k joins vertex k to vertex
// k + 1. A closed curve has one more segment, from its last vertex to its first. Consecutive equal vertices
// are legal and carry no segment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/error.hpp"
#include "kernels/point.hpp"

namespace lober {

/// One straight piece of a curve, from a to b.
struct Segment {
  Point a, b;
};

/// A curve that somebody else owns. Cheap to copy; valid as long as the points are.
struct CurveView {
  std::span<const Point> points;
  bool closed = true;

  [[nodiscard]] std::size_t segments() const {
    return closed ? points.size() : (points.empty() ? 0 : points.size() - 1);
  }
  /// Segment k < segments().
  [[nodiscard]] Segment segment(std::size_t k) const { return {points[k], points[k + 1 == points.size() ? 0 : k + 1]}; }
};

/// A curve that owns its points. `name` is the zone title or the file it came from.
struct Curve {
  std::vector<Point> points;
  bool closed = true;
  std::string name;

  operator CurveView() const { return {points, closed}; }  // NOLINT(google-explicit-constructor)
};

enum class Orientation : std::int8_t { clockwise = -1, degenerate = 0, counter_clockwise = 1 };

/// Signed area of a closed curve (an open one is closed by its chord), positive for counter-clockwise:
/// 1/2 sum (x_i y_{i+1} - x_{i+1} y_i), DESIGN section 2. Correct to 2^-52 relative to |area| + 2^-95 times
/// the square of the curve's diameter. O(N), parallel; the same bits for any number of threads.
[[nodiscard]] double signed_area(CurveView curve);

/// Throws DataError unless the curve can be used: every coordinate finite, at least three distinct vertices
/// when closed and two when open, fewer than 2^31 vertices. `name` begins the message. O(N).
void validate(CurveView curve, std::string_view name);

/// The part of `validate` that need not look at every coordinate. O(1), unless the curve begins with repeated vertices.
void require_enough_vertices(CurveView curve, std::string_view name);

/// Drops a last vertex that repeats the first (several, if several do).
void drop_closing_vertex(std::vector<Point>& points);

}  // namespace lober

// Curves, and checks whether they can be used.
//
// A curve is an ordered list of vertices joined by straight segments; segment k joins vertex k to vertex
// k + 1. A closed curve has one more segment, from its last vertex to its first. Consecutive equal vertices
// are legal and carry no segment.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "lober/base/error.hpp"
#include "lober/base/export.hpp"
#include "lober/curve/point.hpp"

namespace lober {

/// One straight piece of a curve, from a to b.
struct Segment {
  Point a, b;  ///< its ends
};

/// A curve of either kind that somebody else owns, for functions that take both. Cheap to copy; valid as long as the
/// points are. Types that own points convert to it, but not as temporaries, whose points would soon be gone: give the
/// curve a name.
struct CurveView {
  std::span<const Point> points;  ///< the vertices, which somebody else owns
  bool closed = true;             ///< whether the last vertex is joined to the first

  /// Number of segments.
  [[nodiscard]] std::size_t segments() const {
    return closed ? points.size() : (points.empty() ? 0 : points.size() - 1);
  }
  /// Segment k < segments().
  [[nodiscard]] Segment segment(std::size_t k) const { return {points[k], points[k + 1 == points.size() ? 0 : k + 1]}; }
};

namespace detail {

/// Points that are owned, shared or borrowed. A value: copies share what is owned.
class CurvePoints {
 public:
  [[nodiscard]] std::span<const Point> points() const& noexcept { return points_; }
  [[nodiscard]] std::span<const Point> points() const&& = delete;  // they may go with the curve
  [[nodiscard]] std::size_t size() const noexcept { return points_.size(); }
  [[nodiscard]] bool empty() const noexcept { return points_.empty(); }
  /// The owner that keeps the points alive; null when they are borrowed.
  [[nodiscard]] const std::shared_ptr<const void>& owner() const noexcept { return owner_; }

 protected:
  CurvePoints() = default;
  CurvePoints(std::shared_ptr<const void> owner, std::span<const Point> points) noexcept
      : owner_(std::move(owner)), points_(points) {}
  template <typename Container>
  static std::pair<std::shared_ptr<const void>, std::span<const Point>> kept(Container&& container) {
    auto owner = std::make_shared<const std::remove_cvref_t<Container>>(std::forward<Container>(container));
    return {owner, std::span<const Point>(*owner)};
  }

 private:
  std::shared_ptr<const void> owner_;
  std::span<const Point> points_;
};

template <typename Container>
concept PointContainer = requires(const std::remove_cvref_t<Container>& container) {
  { container.data() } -> std::same_as<const Point*>;
  { container.size() } -> std::convertible_to<std::size_t>;
}
&&!std::is_same_v<std::remove_cvref_t<Container>, std::span<const Point>> &&
    !std::is_same_v<std::remove_cvref_t<Container>, std::span<Point>>;

}  // namespace detail

/// A closed curve: its last point is joined to the first, which need not be repeated. A value that owns its points or
/// shares them; only `borrow` leaves them to the caller.
class ClosedCurve : public detail::CurvePoints {
 public:
  ClosedCurve() = default;
  /// Takes the points of a vector or the like: moved from an rvalue, else copied.
  template <detail::PointContainer Container>
  explicit ClosedCurve(Container&& points) : ClosedCurve(kept(std::forward<Container>(points))) {}
  /// A copy of the points.
  ClosedCurve(std::initializer_list<Point> points) : ClosedCurve(std::vector<Point>(points)) {}
  /// Shares points that `owner` keeps alive.
  ClosedCurve(std::shared_ptr<const void> owner, std::span<const Point> points) noexcept
      : CurvePoints(std::move(owner), points) {}
  /// Points that the caller keeps alive and unchanged for as long as the curve and all results made of it live.
  [[nodiscard]] static ClosedCurve borrow(std::span<const Point> points) noexcept { return {nullptr, points}; }

  /// The curve as functions take it that accept both kinds.
  operator CurveView() const& noexcept { return {points(), true}; }  // NOLINT(google-explicit-constructor)
  operator CurveView() const&& = delete;                             // NOLINT(google-explicit-constructor)

 private:
  explicit ClosedCurve(std::pair<std::shared_ptr<const void>, std::span<const Point>> kept)
      : CurvePoints(std::move(kept.first), kept.second) {}
};

/// An open curve, such as a manifold: an ordered list of points joined by segments. Otherwise like ClosedCurve.
class OpenCurve : public detail::CurvePoints {
 public:
  OpenCurve() = default;
  /// Takes the points of a vector or the like: moved from an rvalue, else copied.
  template <detail::PointContainer Container>
  explicit OpenCurve(Container&& points) : OpenCurve(kept(std::forward<Container>(points))) {}
  /// A copy of the points.
  OpenCurve(std::initializer_list<Point> points) : OpenCurve(std::vector<Point>(points)) {}
  /// Shares points that `owner` keeps alive.
  OpenCurve(std::shared_ptr<const void> owner, std::span<const Point> points) noexcept
      : CurvePoints(std::move(owner), points) {}
  /// Points that the caller keeps alive and unchanged for as long as the curve and all results made of it live.
  [[nodiscard]] static OpenCurve borrow(std::span<const Point> points) noexcept { return {nullptr, points}; }

  /// The curve as functions take it that accept both kinds.
  operator CurveView() const& noexcept { return {points(), false}; }  // NOLINT(google-explicit-constructor)
  operator CurveView() const&& = delete;                              // NOLINT(google-explicit-constructor)

 private:
  explicit OpenCurve(std::pair<std::shared_ptr<const void>, std::span<const Point>> kept)
      : CurvePoints(std::move(kept.first), kept.second) {}
};

/// A curve from a file, before its kind is known. `name` is the zone title or the file it came from.
struct Curve {
  std::vector<Point> points;             ///< the vertices
  bool closed = true;                    ///< whether the last vertex is joined to the first
  std::string name;                      ///< title of the zone, or the file
  std::optional<bool> latitude_first{};  ///< set where a file names its columns as latitude and longitude

  /// The curve as functions take it that accept both kinds.
  operator CurveView() const& { return {points, closed}; }  // NOLINT(google-explicit-constructor)
  operator CurveView() const&& = delete;                    // NOLINT(google-explicit-constructor)
};

/// The sense in which a closed curve runs; degenerate: it has no area.
enum class Orientation : std::int8_t { clockwise = -1, degenerate = 0, counter_clockwise = 1 };
/// The name of an orientation, as in the JSON.
[[nodiscard]] constexpr std::string_view name(Orientation orientation) {
  return orientation == Orientation::counter_clockwise ? "counter_clockwise"
         : orientation == Orientation::clockwise       ? "clockwise"
                                                       : "degenerate";
}

/// Signed area of a closed curve (an open one is closed by its chord), positive for counter-clockwise:
/// 1/2 sum (x_i y_{i+1} - x_{i+1} y_i), docs/conventions.md, section 2. Correct to 2^-52 relative to |area| + 2^-95
/// times the square of the curve's diameter. O(N), parallel; the same bits for any number of threads.
[[nodiscard]] LOBER_API double signed_area(CurveView curve);

/// Throws DataError unless the curve can be used: every coordinate finite, at least three distinct vertices
/// when closed and two when open, fewer than 2^31 vertices. `name` begins the message. O(N).
LOBER_API void validate(CurveView curve, std::string_view name);

/// The part of `validate` that need not look at every coordinate. O(1), unless the curve begins with repeated vertices.
LOBER_API void require_enough_vertices(CurveView curve, std::string_view name);

/// The polygon cut to the rectangle, side by side (Sutherland & Hodgman 1974): parts that lie apart are joined along
/// the sides of the rectangle by edges that run there and back, so that areas and winding numbers inside are right, for
/// a polygon that crosses itself too. Corners on the sides are rounded to double. O(N).
[[nodiscard]] LOBER_API std::vector<Point> clipped(const std::vector<Point>& polygon, const Rectangle& rectangle);

/// Drops a last vertex that repeats the first (several, if several do).
LOBER_API void drop_closing_vertex(std::vector<Point>& points);

}  // namespace lober

// A curve made of smooth segments (private to smooth/).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "kernels/smooth_segment.hpp"
#include "lober/curve/curve.hpp"

namespace lober::detail {

/// Numbers of vertices and segments of a closed curve wrap. An open one goes on beyond its ends in straight segments so
/// long that no fit makes use of them.
class SmoothCurve {
 public:
  /// A curve whose segments all stay straight, if `straight`; so do those of curves of fewer vertices than a segment
  /// looks at.
  explicit SmoothCurve(CurveView view, bool straight = false)
      : view_(view),
        size_(static_cast<std::int64_t>(view.points.size())),
        straight_(straight || view.points.size() < around_a_segment) {}

  [[nodiscard]] const CurveView& view() const { return view_; }
  [[nodiscard]] std::size_t segments() const { return view_.segments(); }
  [[nodiscard]] Point vertex(std::int64_t k) const {
    if (k >= 0 && k < size_) return view_.points[static_cast<std::size_t>(k)];
    return beyond(k);
  }
  /// Vertices from k on if they lie in a row; else nothing.
  [[nodiscard]] const Point* points(std::int64_t k, std::size_t count) const {
    return k < 0 || k + static_cast<std::int64_t>(count) > size_ ? nullptr : view_.points.data() + k;
  }
  /// Whether two neighbours coincide.
  [[nodiscard]] static bool repeats(std::span<const Point> points) {
    return std::adjacent_find(points.begin(), points.end()) != points.end();
  }
  /// The eight vertices about a segment if they lie in a row; else nothing, and segment() has to look for them, as it
  /// has where two neighbours among them coincide.
  [[nodiscard]] const Point* window(std::int64_t k) const {
    return straight_ || k < 3 || k + 4 >= size_ ? nullptr : view_.points.data() + (k - 3);
  }
  [[nodiscard]] SmoothSegment segment(std::int64_t k) const {
    if (straight_) {
      const Point a = vertex(k), b = vertex(k + 1);
      SmoothSegment straight;
      straight.chord = {b.x - a.x, b.y - a.y};
      return straight;
    }
    std::array<Point, 8> around;
    if (const Point* from = window(k); from != nullptr && !repeats({from, 8})) {
      std::copy_n(from, around.size(), around.begin());
      return fit_smooth_segment(around);
    }
    around[3] = vertex(k);
    around[4] = vertex(k + 1);
    if (around[3] == around[4]) return {};  // as fit_smooth_segment; its neighbours may be far away
    for (std::int64_t j = 2, at = k; j >= 0; --j) around[static_cast<std::size_t>(j)] = next_distinct(at, -1);
    for (std::int64_t j = 5, at = k + 1; j < 8; ++j) around[static_cast<std::size_t>(j)] = next_distinct(at, 1);
    return fit_smooth_segment(around);
  }

  /// The chord_area(1) and the error of the segments from `begin` on, at most `most`, and whether they are smooth:
  /// those of segment() for each, to the bit.
  struct Few {
    static constexpr std::size_t most = 256;
    std::array<double, most> areas, errors;
    std::array<std::uint8_t, most> smooth;
    std::size_t straight;  ///< segments of positive length that are not
  };
  void fit(std::size_t begin, std::size_t end, Few& few) const {
    const std::size_t count = end - begin;
    std::array<Point, Few::most + 7> copied;
    std::span<const Point> points;
    if (!straight_ && begin >= 3 && end + 4 <= view_.points.size()) {
      points = view_.points.subspan(begin - 3, count + 7);
    } else if (!straight_) {
      const auto first = static_cast<std::int64_t>(begin) - 3;
      for (std::size_t k = 0; k < count + 7; ++k) copied[k] = vertex(first + static_cast<std::int64_t>(k));
      points = std::span(copied).first(count + 7);
    }
    if (!straight_) {
      const StraightSegments found =
          smooth_chord_areas(points.data(), count, few.areas.data(), few.errors.data(), few.smooth.data());
      few.straight = found.count;
      if (!found.no_length) return;
    }
    few.straight = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const auto at = static_cast<std::int64_t>(begin + k);
      const SmoothSegment one = segment(at);
      few.areas[k] = one.chord_area(1);
      few.errors[k] = one.error;
      few.smooth[k] = one.kind == SmoothSegment::Kind::smooth;
      few.straight += few.smooth[k] == 0 && !(vertex(at) == vertex(at + 1));
    }
  }

 private:
  [[nodiscard, gnu::noinline]] Point beyond(std::int64_t k) const {
    if (view_.closed) return view_.points[static_cast<std::size_t>((k % size_ + size_) % size_)];
    constexpr double much_longer = 1024;
    const std::int64_t end = k < 0 ? 0 : size_ - 1, inward = k < 0 ? 1 : -1;
    std::int64_t other = end;
    while (vertex(other) == vertex(end)) other += inward;
    const Point from = vertex(other), to = vertex(end);
    const double times = much_longer * static_cast<double>(k < 0 ? -k : k - end);
    return {to.x + times * (to.x - from.x), to.y + times * (to.y - from.y)};
  }

  // Moves on from a vertex to the next one at another point: repeated vertices carry no segment.
  [[nodiscard]] Point next_distinct(std::int64_t& at, int direction) const {
    const Point from = vertex(at);
    Point to;
    do {
      at += direction;
      to = vertex(at);
    } while (to == from);
    return to;
  }

  static constexpr std::size_t around_a_segment = 8;

  CurveView view_;
  std::int64_t size_;
  bool straight_;
};

/// A position on a smooth curve. `segment` may lie a few segments outside the curve, so that positions near the first
/// vertex keep their order.
struct SmoothPosition {
  std::int64_t segment = 0;
  double u = 0;
};

}  // namespace lober::detail

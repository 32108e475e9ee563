// How many parts the criteria ask for (private to densify/).
#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/densify/densify.hpp"
#include "engine/densify/interpolant.hpp"

namespace lober {

/// Throws UsageError for a value that is not positive (`shortest`: negative), not a number, or for an angle criterion
/// without `shortest`.
void require_sensible(const Criteria& criteria);

/// What a segment needs.
struct Need {
  std::uint32_t parts = 1;
  bool too_short = false;  ///< more parts would be shorter than Criteria::shortest
};

/// Judges the segments of an interpolated curve.
class Judge {
 public:
  /// `extent`: the largest coordinate, which says what length is nothing.
  Judge(const Interpolant& interpolant, const Criteria& criteria, double extent);

  /// From the polyline given alone; for linear interpolation the final answer. O(1).
  [[nodiscard]] Need estimate(std::size_t segment) const;

  /// By looking at the points that come from `parts` of this segment and of its neighbours. Never less than
  /// parts[segment]. O(parts[segment]).
  [[nodiscard]] Need judge(std::size_t segment, const Buffer<std::uint32_t>& parts) const;

 private:
  [[nodiscard]] Need grown(std::uint32_t parts, double growth, double chord) const;
  [[nodiscard]] double growth_by_points(std::size_t segment, const Buffer<std::uint32_t>& parts) const;
  [[nodiscard]] Point vertex(std::size_t k) const { return curve_.points[k == curve_.points.size() ? 0 : k]; }
  [[nodiscard]] Point before(std::size_t segment, const Buffer<std::uint32_t>& parts) const;
  [[nodiscard]] Point after(std::size_t segment, const Buffer<std::uint32_t>& parts) const;
  [[nodiscard]] bool has_before(std::size_t segment) const { return curve_.closed || segment > 0; }
  [[nodiscard]] bool has_after(std::size_t segment) const { return curve_.closed || segment + 1 < curve_.segments(); }

  const Interpolant& interpolant_;
  CurveView curve_;
  Criteria criteria_;
  double floor_;
  bool angles_;
};

/// By how many times the longest of angle and distance x angle is broken at a vertex a -> b -> c for the segment whose
/// length is `mine`; 1 or less when both hold. The angle concerns a segment that has half the length of its neighbour.
[[nodiscard]] double excess_at_vertex(const Criteria& criteria, Point a, Point b, Point c, double mine, double other);

}  // namespace lober

// The number of parts that the criteria ask for (private to densify/).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "engine/geometry/densify/interpolant.hpp"
#include "lober/curve/densify.hpp"

namespace lober::detail {

/// Throws UsageError for a value that is not positive (`min_length`: negative), not a number, or for an angle criterion
/// without `min_length`.
void require_sensible(const Criteria& criteria);

/// The requirement of one vertex on a segment that ends there.
struct VertexRequirement {
  double growth = 0;  ///< how many times as many parts; 1 or less when the criteria hold
  bool corner = false;
  VertexRequirement& operator+=(const VertexRequirement& other) {
    growth = std::max(growth, other.growth);
    corner = corner || other.corner;
    return *this;
  }
};

/// A cheap test that the angle criteria hold at vertex b between a and c, for a segment of length `mine`; false says
/// nothing.
[[nodiscard]] bool angle_surely_holds(const Criteria& criteria, Point a, Point b, Point c, double mine);

/// The requirement of a segment of length `mine` that meets one of length `other` at this angle, of which `corner`
/// remains however fine the parts are, while the rest falls with their length. The angle alone concerns the longer of
/// the two segments, and the other too if it has half that length.
[[nodiscard]] VertexRequirement requirement_at_vertex(const Criteria& criteria, double angle, double corner,
                                                      double mine, double other);

/// The requirement of a segment.
struct Requirement {
  std::uint32_t parts = 1;
  bool too_short = false;  ///< more parts would be shorter than Criteria::min_length
  bool corner = false;     ///< at one of its ends is a corner, which no number of parts makes as flat as asked for
  /// In an estimate: with this number of parts the bounds hold for all points but those next to the ends.
  std::uint32_t enough = 0;
};

/// Judges the segments of an interpolated curve.
class Judge {
 public:
  /// `extent`: the largest coordinate, which says what length is nothing.
  Judge(const Interpolant& interpolant, const Criteria& criteria, double extent);

  /// The requirement by bounds of the segment's own piece and the angles of the given polyline. Final where no angle
  /// counts (with one part a cubic is its chord) and for linear interpolation. O(1).
  [[nodiscard]] Requirement estimate(std::size_t segment) const;
  [[nodiscard]] bool estimate_is_final() const { return !angles_ || interpolant_.kind() == Interpolation::linear; }

  /// The requirement by the points that come from `parts` of this segment and of its neighbours; by those next to its
  /// ends only, where bounds hold for the others: from `enough` parts on (see Requirement). Never less than
  /// parts[segment]. O(parts[segment]).
  [[nodiscard]] Requirement judge(std::size_t segment, const Buffer<std::uint32_t>& parts, std::uint32_t enough) const;

 private:
  [[nodiscard]] Requirement grown(std::uint32_t parts, VertexRequirement requirement, double chord) const;
  [[nodiscard]] double parts_by_bounds(const CubicPiece& piece, double chord) const;
  [[nodiscard]] VertexRequirement requirement_by_points(std::size_t segment, const Buffer<std::uint32_t>& parts,
                                                        std::uint32_t enough) const;
  [[nodiscard]] double corner_at(std::size_t vertex) const;
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

}  // namespace lober::detail

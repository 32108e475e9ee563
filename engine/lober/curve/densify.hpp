// More points on a curve where it is coarse, fewer where it is over-resolved.
//
// Points come from an interpolation through the vertices given (`densify`, `densify_near`) or from the exact crossings
// with another curve (`insert_crossings`); where a function knows the curve, `images_of` follows it. Vertices given
// stay, bit for bit and in order; only consecutive equal ones, which carry no segment, are merged first. Every pass is
// linear in the number of points that come out, parallel, and gives the same bits for any number of threads: how many
// points a segment gets is counted, the counts are summed up, and each block of the result is written once; nothing is
// ever moved.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "lober/base/buffer.hpp"
#include "lober/base/export.hpp"
#include "lober/curve/curve.hpp"

namespace lober {

/// The curve on which points are inserted.
enum class Interpolation : std::uint8_t {
  linear,     ///< on the chords: the curve stays the same set of points, to rounding
  dritschel,  ///< Dritschel's local cubic (1988), kernels/interpolation.hpp: order 3 to 4, looks at four vertices; its
              ///< tangents at a vertex agree to third order only, which leaves corners on coarse curves
  spline,     ///< the cubic spline over chord length: periodic, or not-a-knot at the ends of an open curve: order 4
};
/// All kinds of interpolation.
inline constexpr std::array<Interpolation, 3> all_interpolations{Interpolation::linear, Interpolation::dritschel,
                                                                 Interpolation::spline};
[[nodiscard]] LOBER_API std::string_view name(Interpolation interpolation);  ///< as on the command line

/// When a curve is fine enough. Lengths in units of the coordinates, angles in radians; infinity switches one off.
/// `max_length` alone is the distance criterion. `angle`, `distance_angle` and `min_length` are those of Hobson (J.
/// Comput. Phys. 104, 1993) as Mancho, Small, Wiggins and Ide use them for manifolds (Physica D 182, 2003, 188-222):
/// the angle alpha is that between successive segments, d the length of a segment. All that are set have to hold.
struct Criteria {
  /// The bound of a criterion that is switched off.
  static constexpr double off = std::numeric_limits<double>::infinity();
  double max_length = off;      ///< tau: d <= tau
  double angle = off;           ///< alpha <= this bound at every vertex
  double distance_angle = off;  ///< d alpha <= this bound for a segment and the angles at its two ends
  /// delta: a segment is not cut into parts shorter than this. It must be positive where an angle criterion is set,
  /// because a corner stays one at any length; below 2^-50 of the largest coordinate it has no effect.
  double min_length = 0;
};

/// Hobson's criteria with a choice of values of ours, relative to E, the longer side of the curve's box: alpha <= 0.3,
/// d alpha <= 1e-3 E, delta = 1e-6 E. Throws DataError as `validate` does. O(N).
[[nodiscard]] LOBER_API Criteria hobson_criteria(CurveView curve);

/// Why a criterion could not be met.
enum class DiagnosticCause : std::uint8_t {
  min_length,  ///< parts would be shorter than `min_length`
  corner,      ///< the tangents of the interpolation meet at a larger angle than `angle`, so no refinement helps
  max_points,  ///< the result would have too many points
  max_rounds,  ///< still not met after the last round
};
inline constexpr std::array<DiagnosticCause, 4> all_diagnostic_causes{
    ///< all causes
    DiagnosticCause::min_length, DiagnosticCause::corner, DiagnosticCause::max_points, DiagnosticCause::max_rounds};
/// The name of the cause.
[[nodiscard]] LOBER_API std::string_view name(DiagnosticCause cause);

/// Segments first, ..., first + count - 1 of the result: at least one of them breaks a criterion.
struct Diagnostic {
  std::uint32_t first;    ///< number of the first segment
  std::uint32_t count;    ///< number of segments
  DiagnosticCause cause;  ///< why the criterion is not met
  /// Whether all members are equal.
  friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

/// A curve of many points, with the criteria that could not be met.
struct DensifiedCurve {
  Buffer<Point> points;                 ///< the vertices
  bool closed = true;                   ///< whether the last vertex is joined to the first
  std::vector<Diagnostic> diagnostics;  ///< in order along the curve
  std::uint32_t rounds = 0;             ///< number of rounds in which points were inserted or removed

  /// The curve as functions take it that accept both kinds.
  operator CurveView() const& { return {points, closed}; }  // NOLINT(google-explicit-constructor)
  operator CurveView() const&& = delete;                    // NOLINT(google-explicit-constructor)
};

/// Options of densify.
struct DensifyOptions {
  Interpolation interpolation = Interpolation::linear;  ///< the curve on which points are inserted
  std::size_t max_points = 100'000'000;  ///< points of the result at most; the last round is trimmed evenly to fit
  std::uint32_t max_rounds = 32;         ///< number of rounds at most
};

/// Cuts every segment into equal parts (of its parameter) until the criteria hold: as few as needed, up to a factor
/// that depends on how uneven the segment's own curve is. Linear interpolation takes one round; cubics are estimated
/// first, then judged on the points themselves and refined where they fail. Throws UsageError for criteria or options
/// that make no sense, among them `angle` with linear interpolation, which turns no corner; DataError as `validate`
/// does. O(points of the result) a round.
[[nodiscard]] LOBER_API DensifiedCurve densify(CurveView curve, const Criteria& criteria,
                                               const DensifyOptions& options = {});

// ------------------------------------------------------------------------------------- near another curve

/// Options of densify_near.
struct NearOptions {
  int passes = 1;                                       ///< number of passes
  int points = 10;                                      ///< inserted into a segment in each pass
  Interpolation interpolation = Interpolation::linear;  ///< the curve on which points are inserted
  std::size_t max_points = 100'000'000;                 ///< points of the result at most; DataError beyond
};

/// Passes near the intersections with another curve (Naik, Lekien & Ross 2017, section 4; -DENS of Lober 1.8): each
/// pass puts `points` equally spaced points into every segment that meets the other curve; the next pass does the same
/// in the parts that meet it. After all passes an intersection lies in a part of (points + 1)^-passes of a segment.
/// Segments are taken without their last vertex, so an intersection at a vertex refines the segment after it; arcs that
/// both curves share vertex by vertex are refined at their beginning only. Either curve may be open or cross itself.
/// Linear interpolation keeps the intersections where they are; with any other interpolation each pass finds the
/// intersections of the new curve. Throws UsageError, DataError (too many points). O(N + M + intersections * passes *
/// points) and the search.
[[nodiscard]] LOBER_API DensifiedCurve densify_near(CurveView curve, CurveView other, const NearOptions& options);

/// The two curves with a vertex at each point where they meet and had none, the same bits in both: a crossing is
/// rounded to double, a vertex of one curve that lies on the other is taken as it is. The order is exact along each
/// segment; an open curve's last vertex counts. Either curve may cross itself, but not along an arc shared with the
/// other.
[[nodiscard]] LOBER_API std::array<DensifiedCurve, 2> insert_crossings(CurveView first, CurveView second);

/// The parameters in (0, 1) that `passes` passes of `points` points insert into one segment, appended in ascending
/// order. `meetings` are the parameters in [0, 1) where it meets the other curve, ascending. Stops where parts become
/// shorter than 2^-52. O(points) a meeting and pass.
LOBER_API void parameters_near(std::span<const double> meetings, int passes, int points,
                               std::vector<double>& parameters);

// ------------------------------------------------------------------------------------------- fewer points

/// Options of simplify.
struct SimplifyOptions {
  double tolerance = 0;               ///< how far a removed vertex may lie from the curve that remains
  double max_length = Criteria::off;  ///< no new segment is longer than this
};

/// Removes vertices where the curve is over-resolved. No vertex given lies farther than `tolerance` from the segment
/// that spans it (to rounding). Works in rounds, each of which removes no two neighbours; a segment carries a bound for
/// what was removed in it, so that rounds do not add up to more than the tolerance. These stay: the ends of an open
/// curve; of a closed one the first vertex, the one farthest from it, and the one farthest from the line through these
/// two. O(N), parallel. Throws UsageError, DataError.
[[nodiscard]] LOBER_API DensifiedCurve simplify(CurveView curve, const SimplifyOptions& options);

}  // namespace lober

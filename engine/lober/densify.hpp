// More points on a curve where it is coarse, fewer where it is over-resolved.
//
// Points come from an interpolation through the vertices given (`densify`, `densify_near`), from the exact crossings
// with another curve (`insert_crossings`), or from a function that knows the curve (`densify_sampled`). Vertices given
// stay, bit for bit and in order; only consecutive equal ones, which carry no segment, are merged first. Every pass is
// linear in the number of points that come out, parallel, and gives the same bits for any number of threads: how many
// points a segment gets is counted, the counts are summed up, and each block of the result is written once; nothing is
// ever moved.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "lober/buffer.hpp"
#include "lober/curve.hpp"
#include "lober/export.hpp"

namespace lober {

enum class Interpolation : std::uint8_t {
  linear,     ///< on the chords: the curve stays the same set of points, to rounding
  dritschel,  ///< Dritschel's local cubic (1988), kernels/interpolation.hpp: order 3 to 4, looks at four vertices; its
              ///< tangents at a vertex agree to third order only, which leaves corners on coarse curves
  spline,     ///< the cubic spline over chord length: periodic, or not-a-knot at the ends of an open curve: order 4
};
[[nodiscard]] LOBER_API std::string_view name(Interpolation interpolation);  ///< as on the command line

/// When a curve is fine enough. Lengths in units of the coordinates, angles in radians; infinity switches one off.
/// `longest` alone is the distance criterion. `angle`, `distance_angle` and `shortest` are those of Hobson (J. Comput.
/// Phys. 104, 1993) as Mancho, Small, Wiggins and Ide use them for manifolds (Physica D 182, 2003, 188-222): the angle
/// alpha is that between successive segments, d the length of a segment. All that are set have to hold.
struct Criteria {
  static constexpr double off = std::numeric_limits<double>::infinity();
  double longest = off;         ///< tau: d <= tau
  double angle = off;           ///< alpha <= this at every vertex
  double distance_angle = off;  ///< d alpha <= this for a segment and the angles at its two ends
  /// delta: a segment is not cut into parts shorter than this. Must be positive where an angle criterion is set,
  /// because a corner stays one at any length; below 2^-50 of the largest coordinate it has no effect.
  double shortest = 0;
};

/// Hobson's criteria with a choice of values of ours, relative to E, the longer side of the curve's box: alpha <= 0.3,
/// d alpha <= 1e-3 E, delta = 1e-6 E. Throws DataError as `validate` does. O(N).
[[nodiscard]] LOBER_API Criteria hobson_criteria(CurveView curve);

/// Why a criterion could not be met.
enum class FlawCause : std::uint8_t {
  shortest,     ///< parts would be shorter than `shortest`
  corner,       ///< the tangents of the interpolation meet at a larger angle than `angle`, so no refinement helps
  most_points,  ///< the result would have too many points
  most_rounds,  ///< still not met after the last round
  spacing,      ///< neighbouring parameters are too close (densify_sampled)
  not_finite,   ///< the function gave infinity or NaN for the new point (densify_sampled)
};
[[nodiscard]] LOBER_API std::string_view name(FlawCause cause);

/// Segments first, ..., first + count - 1 of the result: at least one of them breaks a criterion.
struct Flaw {
  std::uint32_t first;
  std::uint32_t count;
  FlawCause cause;
  friend bool operator==(const Flaw&, const Flaw&) = default;
};

/// A curve of many points, with what could not be done.
struct DensifiedCurve {
  Buffer<Point> points;
  bool closed = true;
  std::vector<Flaw> flaws;   ///< in order along the curve
  std::uint32_t rounds = 0;  ///< in which points were inserted or removed

  operator CurveView() const { return {points, closed}; }  // NOLINT(google-explicit-constructor)
};

struct DensifyOptions {
  Interpolation interpolation = Interpolation::linear;
  std::size_t most_points = 1'000'000'000;  ///< of the result; the last round is trimmed evenly to what fits
  std::uint32_t most_rounds = 32;
};

/// Cuts every segment into equal parts (of its parameter) until the criteria hold, as few as are needed to a factor
/// that the unevenness of the segment's own curve decides. Linear interpolation takes one round; cubics are estimated
/// first, then judged on the points themselves and refined where they fail. Throws UsageError for criteria or options
/// that make no sense, among them `angle` with linear interpolation, which turns no corner; DataError as `validate`
/// does. O(points of the result) a round.
[[nodiscard]] LOBER_API DensifiedCurve densify(CurveView curve, const Criteria& criteria,
                                               const DensifyOptions& options = {});

// ------------------------------------------------------------------------------------- near another curve

struct NearOptions {
  int passes = 1;
  int points = 10;  ///< inserted into a segment in each pass
  Interpolation interpolation = Interpolation::linear;
  std::size_t most_points = 100'000'000;  ///< of the result; DataError beyond
};

/// Passes near the intersections with another curve (section 4 of the paper, the -DENS of the published program): each
/// pass puts `points` points, equally spaced, into every segment that meets the other curve, and the next pass does so
/// in those of its parts that do. After all passes an intersection lies in a part of (points + 1)^-passes of a segment.
/// Segments are taken without their last vertex, so an intersection at a vertex refines the segment after it; arcs that
/// both curves share vertex by vertex are refined at their beginning only. Either curve may be open or cross itself.
/// Linear interpolation keeps the intersections where they are; for the others each pass finds those of the curve as it
/// has become. Throws UsageError, DataError (too many points). O(N + M + intersections * passes * points) and the
/// search.
[[nodiscard]] LOBER_API DensifiedCurve densify_near(CurveView curve, CurveView other, const NearOptions& options);

/// The two curves with a vertex at each point where they meet and had none, the same bits in both: a crossing is
/// rounded to double, a vertex of one curve that lies on the other is taken as it is. In exact order along each
/// segment; an open curve's last vertex counts. Either curve may cross itself, but not along an arc shared with the
/// other.
[[nodiscard]] LOBER_API std::array<DensifiedCurve, 2> insert_crossings(CurveView first, CurveView second);

/// The parameters in (0, 1) that `passes` passes of `points` points insert into one segment, appended in ascending
/// order. `meetings` are the parameters in [0, 1) where it meets the other curve, ascending. Stops where parts become
/// shorter than 2^-52. O(points) a meeting and pass.
LOBER_API void parameters_near(std::span<const double> meetings, int passes, int points,
                               std::vector<double>& parameters);

// ------------------------------------------------------------------------------------------- fewer points

struct ThinOptions {
  double tolerance = 0;            ///< how far a removed vertex may lie from the curve that remains
  double longest = Criteria::off;  ///< no segment longer than this comes into being
};

/// Removes vertices where the curve is over-resolved. No vertex given lies farther than `tolerance` from the segment
/// that spans it (to rounding). Works in rounds, each of which removes no two neighbours; a segment carries a bound for
/// what was removed in it, so that rounds do not add up to more than the tolerance. The ends of an open curve stay; of
/// a closed one the first vertex, the one farthest from it, and the one farthest from the line through these. O(N),
/// parallel. Throws UsageError, DataError.
[[nodiscard]] LOBER_API DensifiedCurve thin(CurveView curve, const ThinOptions& options);

// ---------------------------------------------------------------------------------- points from a function

/// Writes the point of each parameter. Called for several batches at the same time, so it must be safe to call from
/// several threads and must give a parameter the same point whatever batch it comes in. What it throws passes through.
using CurveFunction = std::function<void(std::span<const double> parameters, std::span<Point> points)>;

struct SampledOptions {
  Criteria criteria;
  double period = 0;         ///< closed curve: its first point again at parameters.front() + period; 0: open
  double least_spacing = 0;  ///< neighbouring parameters come no closer
  std::size_t most_points = 1'000'000'000;
  std::uint32_t most_rounds = 64;
  std::size_t batch = 1024;  ///< parameters handed to the function at once, at most
};

struct SampledCurve : DensifiedCurve {
  Buffer<double> parameters;  ///< of each point, strictly ascending
};

/// Samples a curve that a function knows, from the given strictly ascending parameters on, until the criteria hold:
/// segments that break one are halved at the mean of their parameters, round by round. Where the angle at a vertex is
/// too large, the longer of its two segments is halved, and the shorter too if it has at least half that length. Every
/// point of the result is f of its parameter. A segment whose new point is not finite is left alone. Segments that
/// cannot be refined further are listed in `flaws`. Throws UsageError (criteria, fewer than two parameters or not
/// ascending, period too short), DataError when f gives a point that is not finite for one of the parameters given.
/// O(points of the result) a round, besides f.
[[nodiscard]] LOBER_API SampledCurve densify_sampled(std::span<const double> parameters, const CurveFunction& function,
                                                     const SampledOptions& options);

}  // namespace lober

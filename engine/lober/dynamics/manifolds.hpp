// Invariant manifolds grown from their saddle, and images of closed curves, with a given bound on the distance between
// the polygon and the curve.
//
// Every vertex is F^k(P(s)) for its own s on the local manifold P; nothing is interpolated. Generation 0 is the local
// manifold itself; generation k is the image of the outermost fundamental segment, reach / |lambda| < s <= reach, under
// k steps. The images of the points of one generation show where the next one needs points (trace.hpp); each of those
// is computed once, from its parameter, with k steps for a point of generation k, as a bare loop over the final points
// would do. A manifold of an inverse saddle (lambda < 0) swaps sides in each step; it is grown with two steps in one.
//
//   const lober::LocalManifold local = lober::local_manifold(map, saddle, lober::ManifoldSide::unstable);
//   const lober::GrownManifold u = lober::grow(map, local, lober::Branch::plus, {.tolerance = 1e-6, .length = 30});
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string_view>
#include <vector>

#include "lober/base/buffer.hpp"
#include "lober/base/export.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/densify.hpp"
#include "lober/curve/point.hpp"
#include "lober/dynamics/local_manifold.hpp"

namespace lober {

/// One of the two branches of a manifold: s > 0 or s < 0 (LocalManifold).
enum class Branch : std::int8_t { minus = -1, plus = 1 };
/// The branch that leaves the saddle to the same side as `direction`.
[[nodiscard]] LOBER_API Branch branch_towards(const LocalManifold& local, Point direction);

/// Why points could not be put where the tolerance asks for them.
enum class GrowthDiagnosticCause : std::uint8_t {
  failed,      ///< the map fails there: the orbit escapes to infinity or the integration does not go through. Points
               ///< that have no image are left out; the segment joins the last point before with the first one after
  spacing,     ///< parameters of neighbouring points are as close as rounding allows
  max_rounds,  ///< the tolerance is still not met after the last round
  left_box,    ///< a fact rather than a fault: the curve is outside the box there and is followed coarsely
};
inline constexpr std::array<GrowthDiagnosticCause, 4> all_growth_causes{
    ///< all causes
    GrowthDiagnosticCause::failed, GrowthDiagnosticCause::spacing, GrowthDiagnosticCause::max_rounds,
    GrowthDiagnosticCause::left_box};
/// The name of the cause.
[[nodiscard]] LOBER_API std::string_view name(GrowthDiagnosticCause cause);

/// Segments first, ..., first + count - 1 of the result.
struct GrowthDiagnostic {
  std::size_t first;            ///< number of the first segment
  std::size_t count;            ///< number of segments
  GrowthDiagnosticCause cause;  ///< why the tolerance is not met
  /// Whether all members are equal.
  friend bool operator==(const GrowthDiagnostic&, const GrowthDiagnostic&) = default;
};

/// Why growing ended.
enum class GrowthStop : std::uint8_t {
  iterates,   ///< done
  length,     ///< done
  points,     ///< max_points, max_memory or max_images reached
  work,       ///< max_work reached
  ended,      ///< two generations added less than the tolerance: the branch ends in a fixed point
  failed,     ///< no point of the last generation has an image in the box
  cancelled,  ///< by `progress`
};
/// The name of the reason.
[[nodiscard]] LOBER_API std::string_view name(GrowthStop stop);

/// The state of a growing manifold.
struct GrowthProgress {
  int iterates = 0;          ///< done
  std::size_t points = 0;    ///< points of the finished part
  double length = 0;         ///< length of the finished part
  std::uint64_t images = 0;  ///< steps of the map taken
};

/// At least one of `iterates` and `length` has to be set.
struct GrowthOptions {
  double tolerance = 1e-5;  ///< e: how far the curve may lie from its polygon, as for tangles of systems
  int iterates = -1;        ///< ends at F^iterates of the end of the local manifold
  /// Ends where the polygon has this arc length, not counting parts outside the box: at most a billionth beyond, as far
  /// as parameters can be told apart.
  double length = std::numeric_limits<double>::infinity();
  double max_length = 0;                 ///< no segment is longer; 0: a fiftieth of the extent of the local manifold
  std::size_t max_points = 100'000'000;  ///< points of the result at most
  std::size_t max_memory = std::numeric_limits<std::size_t>::max();      ///< bytes, roughly; 120 are needed a point
  std::uint64_t max_images = std::numeric_limits<std::uint64_t>::max();  ///< steps of the map in all
  /// Evaluations of the vector field (PlanarMap::work) in all; for maps given by formulas the steps.
  double max_work = std::numeric_limits<double>::infinity();
  /// Where points or images would run out within a piece (a part of a generation), none of it is computed; if false,
  /// the part of it that fits.
  bool whole_pieces = false;
  /// Only the part of the curve in it has to meet the tolerance. Default: the square around the saddle of 200 extents
  /// of the local manifold.
  Rectangle box = {};
  std::function<bool(const GrowthProgress&)> progress = {};  ///< false stops; called from the calling thread
};

/// The result of grow.
struct GrownManifold {
  Buffer<Point> points;                       ///< points from LocalManifold::saddle itself on
  Buffer<double> parameters;                  ///< s: vertex i is F^(k steps)(P(s)), k its generation
  std::vector<std::size_t> generation_begin;  ///< the first vertex of each generation, and the number of points
  std::vector<GrowthDiagnostic> diagnostics;  ///< in order
  GrowthStop stop = GrowthStop::iterates;     ///< why growing ended
  double length = 0;                          ///< length of the polygon inside the box
  std::uint64_t images = 0;                   ///< steps of the map taken in all

  /// The curve as functions take it that accept both kinds.
  operator CurveView() const& { return {points, false}; }  // NOLINT(google-explicit-constructor)
  operator CurveView() const&& = delete;                   // NOLINT(google-explicit-constructor)
};

/// Grows one branch. All that was computed is kept, whatever stops it. Throws UsageError for options that make no
/// sense. The same bits for any number of threads. A vertex of generation k costs k steps of the map, and the guides
/// cost one step for each vertex of the generation before.
[[nodiscard]] LOBER_API GrownManifold grow(const PlanarMap& map, const LocalManifold& local, Branch branch,
                                           const GrowthOptions& options);

// ------------------------------------------------------------------------------------------- images of curves

/// Writes the point of each parameter. Called for several batches at the same time, so it must be safe to call from
/// several threads and must give a parameter the same point in every batch. Its exceptions pass through.
using CurveFunction = std::function<void(std::span<const double> parameters, std::span<Point> points)>;

/// Options of image_of and images_of.
struct ImageOptions {
  double tolerance = 1e-5;                                      ///< how far the image may lie from its polygon
  double max_length = std::numeric_limits<double>::infinity();  ///< length of a segment of the image at most
  std::size_t max_points = 100'000'000;                         ///< points of an image at most
  /// Evaluations of the vector field (PlanarMap::work) for all images of a curve together; for maps given by formulas
  /// the steps. The image at which it is reached has no points.
  double max_work = std::numeric_limits<double>::infinity();
  Rectangle box = {};  ///< default: the plane
  /// False stops; called from the calling thread.
  std::function<bool(const GrowthProgress&)> progress = {};
};

/// An image of a curve.
struct CurveImage {
  Buffer<Point> points;       ///< the vertices
  Buffer<double> parameters;  ///< parameter of each point; on a polygon: number of the segment + fraction
  bool closed = true;         ///< whether the last vertex is joined to the first
  int iterate = 0;            ///< set by `images_of` from `first` to `last`
  /// In order. Where the map fails at the first point of a closed curve, the last one belongs to the closing segment.
  std::vector<GrowthDiagnostic> diagnostics;
  GrowthStop stop = GrowthStop::iterates;  ///< why the work ended
  std::uint64_t images = 0;                ///< steps of the map taken

  /// The curve as functions take it that accept both kinds.
  operator CurveView() const& { return {points, closed}; }  // NOLINT(google-explicit-constructor)
  operator CurveView() const&& = delete;                    // NOLINT(google-explicit-constructor)
};

/// F^iterates of the closed curve c(t), which the function gives for corners.front() <= t <= corners.back() and which
/// has the same point at both. The parameters in `corners` (at least two, ascending) become vertices; between them the
/// curve has to be smooth. Throws UsageError, DataError (a corner without an image), Cancelled.
[[nodiscard]] LOBER_API CurveImage image_of(const PlanarMap& map, int iterates, const CurveFunction& curve,
                                            std::span<const double> corners, const ImageOptions& options);

/// F^iterates of a polygon, open or closed. Its vertices stay; new ones are images of points on its segments.
[[nodiscard]] LOBER_API CurveImage image_of(const PlanarMap& map, int iterates, CurveView curve,
                                            const ImageOptions& options);

/// F^first, ..., F^last of a curve, first <= last, either of which may be negative; each is as `image_of` gives it.
/// The curve is traced once in each direction. Where points run out (`stop`), images further out are left out.
[[nodiscard]] LOBER_API std::vector<CurveImage> images_of(const PlanarMap& map, int first, int last,
                                                          const CurveFunction& curve, std::span<const double> corners,
                                                          const ImageOptions& options);
/// The same for a polygon, open or closed.
[[nodiscard]] LOBER_API std::vector<CurveImage> images_of(const PlanarMap& map, int first, int last, CurveView curve,
                                                          const ImageOptions& options);

/// A curve of at least two points.
struct ImagePart {
  Buffer<Point> points;  ///< the vertices
  bool closed = false;   ///< whether the last vertex is joined to the first
};
/// The image without the segments that span points without an image: one curve where the map fails nowhere, else open
/// curves in order. O(N).
[[nodiscard]] LOBER_API std::vector<ImagePart> parts_of(const CurveImage& image);

/// Writes the points of curve k = 0, 1, ... of a sequence at the parameters; safe to call from several threads.
using CurveSequence = std::function<void(int curve, std::span<const double> parameters, std::span<Point> points)>;

/// A sequence of closed curves with one parameter, each the image of the one before under some map, such as the
/// crossings of one family of trajectories with a section. Each shows where the next one needs points. The sequence
/// ends after the first curve for which `goes_on` is false, or where points run out. Corners, options and errors as for
/// `image_of`. The first curve is sampled at `guide` to begin with: ascending parameters, the corners among them; a few
/// between corners when that is empty.
[[nodiscard]] LOBER_API std::vector<CurveImage> images_of(const CurveSequence& curves, std::span<const double> corners,
                                                          const ImageOptions& options,
                                                          const std::function<bool(const CurveImage&)>& goes_on,
                                                          std::span<const double> guide = {});

}  // namespace lober

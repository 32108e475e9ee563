// The interior function of a closed curve, and the areas of two curves computed from it (Naik, Lekien & Ross 2017,
// section 4).
//
//   J(z) = Im of the integral of dz' / (z' - z) along the curve = 2 pi times the winding number of the curve about z.
//
// Inside, outside and on are decided exactly, by counting the crossings of a ray. Nothing here knows the overlay:
// areas found this way are an independent check of it.
//
//   const lober::IndexedCurve boundary(curve);
//   if (lober::winding(boundary, point).number != 0) use(point);
//   double flux = lober::interior_areas(c1, c2).areas.c1_minus_c2;
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "lober/base/buffer.hpp"
#include "lober/base/export.hpp"
#include "lober/base/progress.hpp"
#include "lober/curve/curve.hpp"
#include "lober/overlay/areas.hpp"
#include "lober/overlay/crossings.hpp"
#include "lober/overlay/index.hpp"

namespace lober {

// ------------------------------------------------------------------------------------------ winding numbers and J

/// How often a closed curve winds round a point, counter-clockwise positive.
struct Winding {
  std::int32_t number = 0;  ///< 0 if the point lies on the curve
  bool on = false;          ///< the point lies on the curve
  /// Whether both members are equal.
  friend bool operator==(const Winding&, const Winding&) = default;
};

/// The winding number of a closed curve of any shape, self-intersecting or not, about a point, which must be finite.
/// Exact. Throws UsageError for an open curve, as everything that follows does. A ray to the right is followed through
/// the box tree: a box that it misses is skipped, one that lies wholly to the right of the point counts by the heights
/// of its two ends. Takes about log N for a curve whose boxes overlap little.
[[nodiscard]] LOBER_API Winding winding(const IndexedCurve& curve, Point point);

/// The winding numbers about many points, in parallel; the same for any number of threads.
[[nodiscard]] LOBER_API std::vector<Winding> windings(const IndexedCurve& curve, std::span<const Point> points);

/// J at a point.
struct InteriorValue {
  double j = 0;     ///< on the curve: the principal value, half a turn less or more than on either side (at a vertex:
                    ///< by the angle there)
  bool on = false;  ///< exact
};

/// J by way of the box tree: an arc whose box excludes the point contributes the angle between its two ends as seen
/// from there, which is right because a box is convex; so do neighbouring arcs together that lie on one side of the
/// point. Angles near half a turn get their sign from an exact predicate, so J / 2 pi is the winding number up to the
/// rounding of these few angles (each right to about 2^-51). About log N. docs/conventions.md, section 5.
[[nodiscard]] LOBER_API InteriorValue interior_function(const IndexedCurve& curve, Point point);

/// J at many points, in parallel; the same bits for any number of threads.
[[nodiscard]] LOBER_API std::vector<InteriorValue> interior_function(const IndexedCurve& curve,
                                                                     std::span<const Point> points);

/// J as Naik, Lekien & Ross (2017) compute it, for reference: a difference of two arc tangents for every segment
/// (section "Computation of J_i"), in plain double. O(N). Wrong by a turn where rounding puts the point on the other
/// side of a segment, or on it.
[[nodiscard]] LOBER_API double interior_function_direct(CurveView curve, Point point);

// ------------------------------------------------------------------------------------------ labels of vertices

/// Where a point lies with respect to the region of a simple closed curve.
enum class Side : std::uint8_t { outside, on, inside };

/// The label of one point, by its winding number: the point is inside when that is not zero. Exact, about log N.
[[nodiscard]] LOBER_API Side locate(const IndexedCurve& curve, Point point);

/// The label of each point, by a query for each. Parallel.
[[nodiscard]] LOBER_API Buffer<Side> label_points(const IndexedCurve& curve, std::span<const Point> points);

/// The label of each vertex of curve `curve` (1 or 2) with respect to the other one. Sides change at nodes only, where
/// the order of the half-edges gives the new side; nothing is searched. Agrees with `label_points`. O(N), with one
/// point query, O(N), when there is no node.
[[nodiscard]] LOBER_API Buffer<Side> label_vertices(const Crossings& nodes, int curve);

/// A position on a curve from which on it lies on another side of the other curve (or on the same one again, after a
/// touch).
struct SideChange {
  Position at;     ///< the position
  bool at_vertex;  ///< `at` is the first vertex of its segment
  Point point;     ///< the point there, rounded
  Side side;       ///< side of the boundary arc that follows
};

/// The changes of side of curve `curve` (1 or 2) in order along it, from its first vertex on, in the direction of the
/// input: one for each point where the curves meet, two for each shared arc. Empty when there is no node. O(nodes).
[[nodiscard]] LOBER_API std::vector<SideChange> side_changes(const Crossings& nodes, int curve);

/// Each pass puts `points` points, equally spaced, into every segment that holds an intersection; the next pass does so
/// in the parts that hold one. The distance to the nearest points falls by points + 1 a pass (-DENS of Lober 1.8).
struct EndsDensification {
  int passes = 0;  ///< number of passes
  int points = 0;  ///< points that each pass inserts into a segment
};

/// A point of a curve and its label.
struct LabelledPoint {
  Point point;  ///< the point
  Side side;    ///< with respect to the other curve
};

/// Curve `curve` (1 or 2) from its first vertex on, with the points where it meets the other one and the inserted ones.
/// Throws DataError when there would be more than InteriorOptions::max_points. O(N + points inserted).
[[nodiscard]] LOBER_API std::vector<LabelledPoint> labelled_points(const Crossings& nodes, int curve,
                                                                   const EndsDensification& densification = {});

// ------------------------------------------------------------------------------------------ areas

/// How the integrals along the curves are weighted with I = +1 outside, 0 on, -1 inside of the other curve.
enum class InteriorMethod : std::uint8_t {
  split,  ///< segments are split where the curves meet, exactly; each part has the weight of its side
  ends,   ///< a segment has the mean weight of its two ends, as with -DENS 0
};
/// Both methods.
inline constexpr std::array<InteriorMethod, 2> all_interior_methods{InteriorMethod::split, InteriorMethod::ends};
/// The name of the method.
[[nodiscard]] constexpr std::string_view name(InteriorMethod method) {
  return method == InteriorMethod::split ? "split" : "ends";
}

/// Options of interior_areas.
struct InteriorOptions {
  InteriorMethod method = InteriorMethod::split;  ///< how integrals are weighted
  /// For `ends`, the option -DENS <passes> <points>: each pass divides the segments whose ends have different labels
  /// by `points` equally spaced points, the next one the parts whose ends still differ, until neighbours are 2^-52 of
  /// the segment apart. Nothing is inserted if either is 0.
  int passes = 0;
  int points = 0;                          ///< points that each pass inserts into a segment
  std::size_t max_points = 100'000'000;    ///< points of one curve and its inserted ones at most; DataError beyond
  IndexKind index = IndexKind::automatic;  ///< index that proposes which segments can meet; results do not depend on it
  bool check_simple = true;  ///< refuse curves that are not simple; false when the caller knows that they are
  Progress progress{};       ///< called with the fraction done, between phases
};

/// Counts of the work of interior_areas.
struct InteriorStatistics {
  IndexKind index = IndexKind::tree;     ///< the one that was used
  ContactCounts counts;                  ///< counts of the search of C1 against C2
  SearchCounts check_simple;             ///< counts of the searches of each curve against itself
  std::uint64_t check_simple_pairs = 0;  ///< pairs of segments decided exactly in those searches
  std::uint64_t arcs = 0;                ///< parts that the curves were split into
  std::uint64_t queries = 0;             ///< winding numbers that were computed
  std::uint64_t points_inserted = 0;     ///< points inserted by `passes` and `points`
};

/// Seconds of wall time of each phase.
struct InteriorTiming {
  /// Each phase, and all of them.
  double index = 0, check = 0, crossings = 0, order = 0, labels = 0, sums = 0, total = 0;
};

/// The result of interior_areas.
struct InteriorAreas {
  /// Integrals over both curves, counter-clockwise, of w = 1/2 (x dy - y dx) with weights I, (I + 1) / 2 and
  /// (1 - I) / 2 (docs/conventions.md, section 6): the symmetric difference, the union and the intersection.
  double q1 = 0, q2 = 0, q3 = 0;
  /// 1/4 |q2 - q3 - q1|, which Lober 1.8 reports beside its areas. Zero by algebra: it measures the rounding of the
  /// three sums and nothing else.
  double delta = 0;
  Areas areas;      ///< the areas
  Areas rounding;   ///< bounds on the rounding of double-double; for `split` on |computed - exact area of the polygons|
  Crossings nodes;  ///< where the curves meet
  InteriorStatistics statistics;                              ///< counts of the work
  InteriorTiming timing;                                      ///< seconds of each phase
  Orientation orientation1 = Orientation::counter_clockwise;  ///< orientations of the input
  Orientation orientation2 = Orientation::counter_clockwise;  ///< orientation of C2 in the input
};

/// Areas of two simple closed curves of either orientation from Q1, Q2, Q3. For `split` each part of a curve between
/// two contacts is labelled by the exact winding number of the other curve about one of its vertices; a straight part,
/// which has none inside, by the exact side on which it leaves its first end. On shared parts I = 0, so that each curve
/// brings half of them. Sums are in double-double about one common origin. Throws UsageError (an open curve), DataError
/// (validate; also an area beyond the range of double), NotSimpleError, Cancelled. O(n + m + contacts log N) and the
/// search, parallel; the same bits for any number of threads. Areas are as good as those of `overlay`: relative error
/// below 1e-15 where they exceed 1e-12 of the bounding box.
[[nodiscard]] LOBER_API InteriorAreas interior_areas(const ClosedCurve& c1, const ClosedCurve& c2,
                                                     const InteriorOptions& options = {});

/// The same for curves that are indexed already (and validated by the caller).
[[nodiscard]] LOBER_API InteriorAreas interior_areas(const IndexedCurve& c1, const IndexedCurve& c2,
                                                     const InteriorOptions& options = {});

}  // namespace lober

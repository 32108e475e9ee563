// The tangle of two manifolds: primary and secondary intersections, lobes, boundary, turnstile.
//
// U is the unstable manifold of p-, S the stable manifold of p+ (the same fixed point when homoclinic), both open
// curves, simple, ordered outward from their fixed point. docs/conventions.md, sections 8 and 9, has the definitions;
// sources are Rom-Kedar & Wiggins (Arch. Rational Mech. Anal. 109, 1990) and Naik, Lekien & Ross (2017). All of it
// follows from the crossings, exactly ordered along both curves, and from sums along the curves up to each:
//
//   pips      a crossing is a pip if none before it along U comes before it along S: the records of one sweep.
//   arcs      the pips q_0, q_1, ... follow each other outward along U and inward along S. They cut U into arcs
//             U_k from q_k to q_k+1 and S into arcs S_k between the same pips. Lobe k is bounded by U_k and S_k.
//   gap       D(x) = S_U(x) - S_S(x), twice the area swept by U up to x minus that swept by S up to x.
//   lobe      its signed area is (D(q_k+1) - D(q_k)) / 2: U_k and S_k never meet but in the pips.
//   overlap   of lobes i and j, with orientations o_i, o_j: o_i o_j / 2 times the sum of rho(x) D(x) over the crossings
//             of U_i with S_j and of U_j with S_i. One pass over the crossings gives all overlaps of all lobes.
//   boundary  B(q_b) = U[p-, q_b] and S[q_b, p+], closed by a path from p+ to p-: by the chord unless another one is
//             given. The part of a lobe inside it is a sum of the same kind.
//
//   lober::Tangle found = lober::tangle(u, s);
//   for (const lober::Lobe& lobe : found.lobes) use(lobe.area, lobe.inside);
//   for (const lober::LobeOverlap& both : lober::overlaps(found)) use(both.i, both.j, both.area);
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/base/progress.hpp"
#include "lober/curve/curve.hpp"
#include "lober/overlay/crossings.hpp"
#include "lober/overlay/index.hpp"

namespace lober {

/// A primary intersection. rho as in docs/conventions.md, section 3: +1 if S passes from the right of U to its left.
struct Pip {
  std::uint32_t node;           ///< its number in Tangle::nodes
  Point at;                     ///< rounded to double; with TangleOptions::smooth where the smooth curves cross
  Position u, s;                ///< position on U and on S
  int rho = 0;                  ///< +1 if S passes from the right of U to its left, else -1
  double gap = 0, gap_low = 0;  ///< D, see above, as a double-double; about U's first vertex
  /// With TangleOptions::smooth, estimate of the error of D.
  double gap_error = 0;
};

/// Lobe k, between pips k and k + 1. It is on the left of U_k when its area is positive.
struct Lobe {
  double area = 0;          ///< signed
  double polygon_area = 0;  ///< signed area of the polygon; differs with TangleOptions::smooth only
  /// With TangleOptions::smooth, an estimate of |area - area between the smooth curves|, on the safe side; else zero
  /// (see lobe_shapes).
  double smooth_error = 0;
  /// Areas of its parts inside and outside the boundary; they add up to |area| to rounding. NaN without a boundary.
  double inside = 0, outside = 0;
  /// With TangleOptions::smooth, what the boundary adds to `smooth_error` in each of both.
  double boundary_error = 0;
  /// Whether U_k and S_k meet nowhere but at the pips. They cannot cross there; where they touch or share an arc the
  /// lobe falls into pieces.
  bool simple = true;
  bool meets_closure = false;  ///< the path that closes the boundary meets U_k or S_k
  /// +1 if it is on the left of U_k, else -1.
  [[nodiscard]] int orientation() const { return area > 0 ? 1 : -1; }
};

/// B(q): U from p- to the bip and S on to p+, closed by a path from p+ to p- (of no length when homoclinic and both
/// curves begin at the same point; TangleOptions::closure).
struct Boundary {
  std::size_t bip = 0;          ///< number of the pip
  double area = 0;              ///< area that it encloses; where it crosses itself, of what it winds round
  double smooth_error = 0;      ///< with TangleOptions::smooth, as Lobe::smooth_error
  int orientation = 1;          ///< +1: U[p-, q] runs counter-clockwise round it
  bool crosses_itself = false;  ///< the closure meets the rest of it; areas are then those of nonzero winding number
  /// With TangleOptions::smooth, whether the polygons leave it open how the smooth curves lie where the closure meets
  /// them, so that areas of the polygons stand for theirs, with errors as large as what lies between.
  bool of_polygons = false;
};

/// The role of lobe k under the map: a lobe of L_from,to(n) lies in region `from` and is in region `to` n iterates
/// later (n <= 0: it has been there for -n iterates); regions are 1, inside the boundary, and 2, outside (Rom-Kedar &
/// Wiggins).
struct LobeLabel {
  int from = 0, to = 0;  ///< the two regions
  int n = 0;             ///< number of iterates
};
[[nodiscard]] LOBER_API std::string text(const LobeLabel& label);  ///< "L12(1)"; empty where from is 0

/// Pairing under the map: f takes pip k to pip k + period and lobe k to lobe k + period.
struct Images {
  std::uint32_t period = 0;  ///< pips from one to its image; 0: not known, see `reason`
  bool given = false;        ///< whether the caller gave the period; else it is inferred from the areas
  std::string reason;        ///< why the data do not determine the period; empty if they do
  std::string misfit;        ///< why the period that was given cannot be that of these lobes; empty if it can
  /// Consistency, both relative to the mean |area| of a lobe: the largest difference in signed area of a lobe and its
  /// image (0 if no image is seen), and the largest sum of signed areas over one period. Both vanish for a map that
  /// preserves area, except for the discretisation.
  double area_change = 0, turnstile_sum = 0;
  std::size_t compared = 0;       ///< lobes whose image is seen too
  std::vector<LobeLabel> labels;  ///< role of each lobe; empty where the period is not known

  /// The lobes between f^-1(q) and q, `turnstile_begin` to `turnstile_end`, if they are all there.
  std::size_t turnstile_begin = 0, turnstile_end = 0;
  double lobe_area12 = 0, lobe_area21 = 0;  ///< sums of the turnstile lobes by direction, each lobe counted fully
};

/// Options of tangle.
struct TangleOptions {
  IndexKind index = IndexKind::automatic;  ///< index that proposes which segments can meet; results do not depend on it
  std::optional<std::size_t> bip{};        ///< number of the pip; default floor(n / 2)
  /// Instead of `bip`, the pip nearest to this point; not one that is nearer to where both manifolds begin.
  std::optional<Point> bip_near{};
  /// Corners of the path from p+ to p- that closes the boundary, without p+ and p-: walls, an axis; none: the chord.
  std::vector<Point> closure{};
  std::uint32_t period = 0;  ///< pips from one to its image; 0: infer it
  bool check_simple = true;  ///< refuse manifolds that cross themselves
  bool parts = true;         ///< the area of the boundary, and of lobes inside and outside it; else zero
  /// Areas, of lobes, boundary and overlaps, and pips are those of smooth curves through the points, with errors of
  /// order h^6 (engine/lober/overlay/smooth.hpp). The polygons decide which crossings there are.
  bool smooth = false;
  Progress progress{};  ///< called with the fraction done, between phases
};

/// Seconds of wall time of each phase.
struct TangleTiming {
  /// Each phase, and all of them.
  double index = 0, check = 0, crossings = 0, order = 0, pips = 0, areas = 0, total = 0;
};

namespace detail {
struct TangleCurves;  // private: engine/geometry/tangle/curves.hpp
}  // namespace detail

/// The result of tangle.
struct Tangle {
  Crossings nodes;          ///< where U (curve 1) and S (curve 2) meet, in order along U; order2() is the order along S
  std::vector<Pip> pips;    ///< primary intersections, outward along U
  std::vector<Lobe> lobes;  ///< the lobes between neighbouring pips
  std::optional<Boundary> boundary;                        ///< none without a pip
  std::vector<Point> closure;                              ///< as in TangleOptions
  Images images;                                           ///< pairing of pips and lobes under the map
  std::vector<std::string> remarks;                        ///< remarks on unusual input, one sentence each
  IndexKind index = IndexKind::tree;                       ///< the index that was used
  SimpleCheck check_simple;                                ///< cost of the proof that the manifolds are simple
  std::uint64_t fallback_segments = 0, fallback_pips = 0;  ///< with `smooth`: those that stay as in the polygons
  TangleTiming timing;                                     ///< seconds of each phase

  std::shared_ptr<const detail::TangleCurves> curves;  ///< for the library itself
  /// The unstable manifold.
  [[nodiscard]] const CurveView& u() const& { return nodes.curve1(); }
  [[nodiscard]] const CurveView& u() const&& = delete;  // the points may go with the result
  /// The stable manifold.
  [[nodiscard]] const CurveView& s() const& { return nodes.curve2(); }
  [[nodiscard]] const CurveView& s() const&& = delete;
  /// Bound on |computed - exact value| of an area of the polygons.
  [[nodiscard]] LOBER_API double rounding(double area) const;
};

/// The tangle of two manifolds. The result keeps alive what they own. Throws DataError (validate; a closure that is not
/// finite), NotSimpleError,
/// UsageError (a bip that does not exist), Cancelled. Takes the time of the crossing search and of the sums up to the
/// pips and to the crossings of the boundary with lobes; parallel; the same bits for any number of threads and any
/// index.
[[nodiscard]] LOBER_API Tangle tangle(const OpenCurve& u, const OpenCurve& s, const TangleOptions& options = {});

/// The same for open curves that are indexed already. Throws the same, and UsageError for a closed one.
[[nodiscard]] LOBER_API Tangle tangle(const IndexedCurve& u, const IndexedCurve& s, const TangleOptions& options = {});

// ------------------------------------------------------------------- more about a result, computed when asked for

/// Where a crossing is in the tangle. On arc k of U: between pips k and k + 1 (the last arc, k = pips - 1, leads to the
/// end of U); on arc j of S: between pips j + 1 and j (j = -1: beyond pip 0, to the end of S; j = pips - 1: from p+).
/// Pip k is on arcs k of both. For a sip, j < k: it lies on both lobes k (by U) and j (by S).
struct ArcsAt {
  std::int32_t u, s;  ///< numbers of the arcs
  /// How far apart these lobes are; 0 for pips. With period P, a sip of generation g shows that lobe j, after
  /// ceil(g / P) iterates or fewer, meets lobes of its own time again.
  [[nodiscard]] std::int32_t generation() const { return u - s; }
};
/// The arcs at every node, also at nodes that are not crossings. O(nodes).
[[nodiscard]] LOBER_API std::vector<ArcsAt> arcs_at_nodes(const Tangle& tangle);

/// An area that two lobes have in common.
struct LobeOverlap {
  std::uint32_t i, j;  ///< i < j in one tangle
  double area;         ///< area of the common part
  /// With TangleOptions::smooth, an estimate of the error, as Lobe::smooth_error; else a bound on rounding.
  double error = 0;
  double perimeter = 0;  ///< perimeter of their common region
};
/// The area that two lobes have in common, for every pair that has any; ordered by i, then j. O(crossings + N + M).
[[nodiscard]] LOBER_API std::vector<LobeOverlap> overlaps(const Tangle& tangle);

/// The result of overlaps_with_copy.
struct CopyOverlaps {
  std::vector<LobeOverlap> overlaps;  ///< ordered by i, then j
  /// Pips of one tangle or the other that are not pips of both together, because the U of one crosses the S of the
  /// other before them. Overlaps of lobes between such pips are not reliable.
  std::vector<std::uint32_t> hidden_pips;
};
/// The area that lobe i of a tangle and lobe j of a copy of it, moved by a vector, have in common, for every such pair
/// (also j <= i): for planes that repeat themselves, where manifolds do not cross their own copies. Two searches of one
/// curve against the other, and O(N + M). Throws UsageError for a zero translation, DataError where coordinates leave
/// the range in which squares are numbers.
[[nodiscard]] LOBER_API CopyOverlaps overlaps_with_copy(const Tangle& tangle, Point translation);

/// The boundary of a lobe as a closed polygon: pip k, along U to pip k + 1, back along S. Where S_k and U_k touch it
/// touches itself. It is always that of the polygons. O(its vertices).
[[nodiscard]] LOBER_API std::vector<Point> lobe_outline(const Tangle& tangle, std::size_t lobe);
/// Length of a closed polygon such as a lobe_outline.
[[nodiscard]] LOBER_API double perimeter(const std::vector<Point>& polygon);
/// U[p-, q] and S[q, p+], q a pip, as an open polyline. O(its vertices).
[[nodiscard]] LOBER_API std::vector<Point> boundary_arcs(const Tangle& tangle, std::size_t pip);
/// The boundary as a closed polygon: from p- along U to the bip, along S to p+ and along the closure back to p-.
/// O(its vertices).
[[nodiscard]] LOBER_API std::vector<Point> boundary_outline(const Tangle& tangle);
/// A remark for users where the boundary crosses itself, so that it bounds no region; empty where it does not, and
/// where there is none.
[[nodiscard]] LOBER_API std::string remark_on_boundary(const Tangle& tangle);
/// The result of swept_area.
struct SweptArea {
  double area = 0, error = 0;  ///< the area, and its error bar
};
/// Signed area enclosed by U[p-, q], S[q, p+] and the closure from p+ to p-, q a pip, each part counted with its
/// winding number; that of the smooth curves if the tangle is made of them. The error is as Lobe::smooth_error.
/// O(corners of the closure).
[[nodiscard]] LOBER_API SweptArea swept_area(const Tangle& tangle, std::size_t pip);
/// The simple polygons of which a lobe consists, as areas; one unless the lobe is not simple.
[[nodiscard]] LOBER_API std::vector<double> lobe_pieces(const Tangle& tangle, std::size_t lobe);

/// Lengths in units of the coordinates.
struct LobeShape {
  Point centroid;        ///< centroid of the area
  double perimeter = 0;  ///< length of its boundary
  double width = 0;      ///< mean width of a thin lobe, 2 |area| / perimeter
  /// Estimate of the area that the polygon loses against smooth curves through the same points (kernels/sagitta.hpp).
  double discretisation = 0;
};
/// One pass over the arcs of all lobes, parallel.
[[nodiscard]] LOBER_API std::vector<LobeShape> lobe_shapes(const Tangle& tangle);
/// The same estimate for the area of the boundary, whose closure consists of straight lines. O(its vertices).
[[nodiscard]] LOBER_API double boundary_discretisation(const Tangle& tangle);

}  // namespace lober

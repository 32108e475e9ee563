// The overlay of two simple closed curves: areas and pieces of A1 \ A2, A2 \ A1, A1 n A2 and A1 u A2.
//
// The result is the regularised one: a piece is a connected component of the interior of the region. Two components
// that meet in a vertex only are two pieces; no piece has zero area; corridors of zero width do not join. A hole of a
// piece is a bounded component of the interior of its complement.
//
//   lober::Overlay result = lober::overlay(c1, c2);
//   double flux = result.areas.c1_minus_c2;
//   for (const lober::Piece lobe : result.pieces(lober::Pairing::c1_minus_c2)) use(lobe.area, lobe.crossings);
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "lober/base/element_iterator.hpp"
#include "lober/base/export.hpp"
#include "lober/base/progress.hpp"
#include "lober/curve/curve.hpp"
#include "lober/overlay/areas.hpp"
#include "lober/overlay/crossings.hpp"
#include "lober/overlay/index.hpp"

namespace lober {

/// A combination of the two regions.
enum class Pairing : std::uint8_t { c1_minus_c2, c2_minus_c1, intersection, union_ };
/// All pairings.
inline constexpr std::array<Pairing, 4> all_pairings{Pairing::c1_minus_c2, Pairing::c2_minus_c1, Pairing::intersection,
                                                     Pairing::union_};
[[nodiscard]] LOBER_API std::string_view name(Pairing pairing);  ///< as in the JSON: "c1_minus_c2", ..., "union"

/// A boundary of a piece is a list of steps: (node << 1 | curve of the arc that follows it), the curve 0 or 1; or one
/// step for a whole curve without any node.
inline constexpr std::uint32_t whole_curve1 = 0xfffffffe, whole_curve2 = 0xffffffff;
/// A hole of a piece.
struct PieceHole {
  std::uint32_t piece;               ///< number of the piece
  std::vector<std::uint32_t> steps;  ///< its boundary
};

/// Numbers of the nodes on the boundary of a piece in the order of a walk that keeps the piece on the left, outer
/// boundary first. A node occurs as often as the walk passes it: twice for a piece that touches both ends of a shared
/// arc, or itself in a point. A view of the result, valid as long as the result is.
class PieceCrossings {
 public:
  /// For the library itself.
  PieceCrossings(std::span<const std::uint32_t> outer, std::span<const PieceHole> holes)
      : outer_(outer), holes_(holes) {}

  /// Runs over the numbers of the nodes.
  class Iterator {
   public:
    using value_type = std::uint32_t;        ///< a number of a node
    using difference_type = std::ptrdiff_t;  ///< distance of two positions
    Iterator() = default;
    /// The number of the node.
    std::uint32_t operator*() const { return boundary_[at_] >> 1; }
    /// Goes one step on.
    Iterator& operator++() {
      ++at_;
      skip();
      return *this;
    }
    /// Goes one step on; returns the position before.
    Iterator operator++(int) {
      Iterator before = *this;
      ++*this;
      return before;
    }
    /// Whether both are at the same step.
    bool operator==(const Iterator& other) const { return hole_ == other.hole_ && at_ == other.at_; }

   private:
    friend class PieceCrossings;
    Iterator(std::span<const std::uint32_t> boundary, std::span<const PieceHole> holes, std::size_t hole)
        : boundary_(boundary), holes_(holes), hole_(hole) {
      skip();
    }
    // Moves to a step at a node: over the end of a boundary to the next one.
    void skip() {
      while (at_ >= boundary_.size() || boundary_[at_] >= whole_curve1) {
        at_ = 0;
        if (hole_ > holes_.size()) return;
        if (hole_ < holes_.size()) boundary_ = holes_[hole_].steps;
        if (hole_++ == holes_.size()) return;
      }
    }
    std::span<const std::uint32_t> boundary_;
    std::span<const PieceHole> holes_;
    std::size_t hole_ = 0, at_ = 0;  // the number of the next hole, and the step of the present boundary
  };
  /// The first step at a node.
  [[nodiscard]] Iterator begin() const { return {outer_, holes_, 0}; }
  /// The end of all boundaries.
  [[nodiscard]] Iterator end() const { return {{}, holes_, holes_.size()}; }
  /// Number of nodes, each as often as it occurs. O(nodes).
  [[nodiscard]] std::size_t size() const {
    std::size_t count = 0;
    for (Iterator at = begin(); at != end(); ++at) ++count;
    return count;
  }

 private:
  std::span<const std::uint32_t> outer_;
  std::span<const PieceHole> holes_;
};

/// One connected component of the region.
struct Piece {
  double area = 0;           ///< its area
  std::uint32_t holes = 0;   ///< number of holes
  PieceCrossings crossings;  ///< nodes on its boundary
};

namespace detail {
struct PiecesData;  // private: engine/geometry/overlay/pieces_data.hpp
}  // namespace detail

/// The pieces of one pairing: a range of Piece with random access, stored compactly (12 to 20 bytes a piece, 4 a
/// crossing). Nothing is allocated to look at them. Cheap to copy; a copy keeps alive what its pieces show.
class Pieces {
 public:
  LOBER_API Pieces();  ///< none
  /// For the library itself.
  explicit Pieces(std::shared_ptr<const detail::PiecesData> data) : data_(std::move(data)) {}

  /// Number of pieces.
  [[nodiscard]] std::size_t size() const { return areas().size(); }
  /// A piece by its number.
  [[nodiscard]] LOBER_API Piece operator[](std::size_t piece) const&;
  [[nodiscard]] Piece operator[](std::size_t piece) const&& = delete;  // its crossings would be a view of a temporary
  /// The areas of all pieces.
  [[nodiscard]] LOBER_API std::span<const double> areas() const&;
  [[nodiscard]] std::span<const double> areas() const&& = delete;

  using Iterator = ElementIterator<Pieces>;  ///< a position in the range
  /// The first piece.
  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  /// The end of the pieces.
  [[nodiscard]] Iterator end() const { return {*this, size()}; }

  /// For the library itself.
  [[nodiscard]] const detail::PiecesData& data() const { return *data_; }

 private:
  std::shared_ptr<const detail::PiecesData> data_;
};

/// Counts of the work of overlay.
struct OverlayStatistics {
  IndexKind index = IndexKind::tree;     ///< the one that was used
  ContactCounts counts;                  ///< counts of the search of C1 against C2
  SearchCounts check_simple;             ///< counts of the searches of each curve against itself
  std::uint64_t check_simple_pairs = 0;  ///< pairs of segments decided exactly in those searches
  std::size_t index_bytes = 0;           ///< bytes of both indexes
};

/// Seconds of wall time of each phase.
struct OverlayTiming {
  double index = 0, check = 0, crossings = 0, order = 0, areas = 0, total = 0;  ///< each phase, and all of them
};

/// Options of overlay.
struct OverlayOptions {
  IndexKind index = IndexKind::automatic;  ///< index that proposes which segments can meet; results do not depend on it
  bool pieces = true;                      ///< false: totals only, no polygon is ever formed
  bool check_simple = true;  ///< refuse curves that are not simple; false when the caller knows that they are
  Progress progress{};       ///< called with the fraction done, between phases
};

/// The result of overlay.
struct Overlay {
  Areas areas;      ///< the areas
  Crossings nodes;  ///< where the curves meet
  /// For each node its equivalence class under sigma (Naik, Lekien & Ross 2017, section 3), numbered from 0 in order
  /// along C1; no_class for touches. Each class bounds one piece of A1 \ A2, unless a touch splits it or joins two.
  std::vector<std::uint32_t> classes;
  std::size_t class_count = 0;                           ///< number of classes
  static constexpr std::uint32_t no_class = 0xffffffff;  ///< the class of a touch
  Areas rounding;                ///< bounds on |computed - exact area of the polygons|; 0 for empty regions
  OverlayStatistics statistics;  ///< counts of the work
  OverlayTiming timing;          ///< seconds of each phase
  Orientation orientation1 = Orientation::counter_clockwise;  ///< orientations of the input
  Orientation orientation2 = Orientation::counter_clockwise;  ///< orientation of C2 in the input
  double largest_coordinate = 0;                              ///< the largest |coordinate| of both curves
  double longest_segment = 0;                                 ///< bound on the length of any segment of either curve

  std::array<Pieces, 4> all_pieces;  ///< in the order of all_pairings; empty without OverlayOptions::pieces
  /// The pieces of a pairing.
  [[nodiscard]] const Pieces& pieces(Pairing pairing) const& { return all_pieces[static_cast<std::size_t>(pairing)]; }
  /// For a temporary: a copy, which a loop keeps alive.
  [[nodiscard]] Pieces pieces(Pairing pairing) const&& { return pieces(pairing); }
};

/// Overlays two simple closed curves of either orientation. The result computes coordinates of nodes from their points
/// when asked, and keeps alive what the curves own. Throws DataError (validate; also an area beyond the range of
/// double), NotSimpleError, Cancelled. About one pass over the points plus work in proportion to the segments near
/// crossings; parallel; the same bits for any number of threads and any index. Areas, of pieces and in total, have
/// relative error below 1e-15 where they exceed 1e-12 of the bounding box.
[[nodiscard]] LOBER_API Overlay overlay(const ClosedCurve& c1, const ClosedCurve& c2,
                                        const OverlayOptions& options = {});

/// The same for closed curves that are indexed already (and validated by the caller). Throws UsageError for an open
/// one.
[[nodiscard]] LOBER_API Overlay overlay(const IndexedCurve& c1, const IndexedCurve& c2,
                                        const OverlayOptions& options = {});

// ------------------------------------------------------------------- more about a result, computed when asked for

/// The boundary of a piece as closed polygons: the outer one first, counter-clockwise, then the holes, clockwise.
/// O(vertices of the boundary).
[[nodiscard]] LOBER_API std::vector<std::vector<Point>> outline(const Overlay& result, Pairing pairing,
                                                                std::size_t piece);

/// A crossing p, and the crossings that follow it on the boundary of A1 \ A2 or A2 \ A1 (Naik, Lekien & Ross 2017,
/// section 3; docs/conventions.md, section 4). Both curves are taken counter-clockwise.
struct SigmaStep {
  std::uint32_t crossing = 0;  ///< number of the node
  int rho = 0;                 ///< as in Node
  std::uint32_t along1 = 0;    ///< the next crossing along C1: forward for A1 \ A2 (A+_C1 is 1), backward for A2 \ A1
  std::uint32_t along2 = 0;    ///< the next crossing along C2: backward for A1 \ A2 (A-_C2 is 1), forward for A2 \ A1
  std::uint32_t sigma = 0;     ///< along1 if rho = +1, along2 if rho = -1: where gamma is 1
  std::uint32_t class_number = 0;  ///< number of its class in this pairing, from 0 in order along C1
  double s = 0;                    ///< S(p), the integral of x dy - y dx from p to sigma(p); it depends on the origin
};

/// The steps of all crossings in order along C1; touches are left out. Half the sum of S over a class does not depend
/// on the origin: it is the area of the piece that the class bounds, or of several where touches split it. Throws
/// UsageError for another pairing. O(N).
[[nodiscard]] LOBER_API std::vector<SigmaStep> sigma_steps(const Overlay& result, Pairing pairing);

/// Centroids of all pieces of a pairing, in double-double, so that thin pieces keep theirs. One pass over the points
/// of both curves, parallel.
[[nodiscard]] LOBER_API std::vector<Point> centroids(const Overlay& result, Pairing pairing);
/// The centroid of one piece.
[[nodiscard]] LOBER_API Point centroid(const Overlay& result, Pairing pairing, std::size_t piece);

/// Slivers: pieces no wider than the rounding of their vertices, area <= 2 perimeter ulp, ulp the unit in the last
/// place of the largest coordinate of the two curves. Where curves share an arc up to rounding, these are the noise
/// between them. Perimeters are computed only for pieces small enough to be in question.
struct Slivers {
  std::vector<std::uint32_t> pieces;  ///< ascending
  double area = 0;                    ///< their total
};
/// The slivers among the pieces of a pairing.
[[nodiscard]] LOBER_API Slivers find_slivers(const Overlay& result, Pairing pairing);

namespace detail {
struct DiscretisationData;  // private: engine/geometry/overlay/discretisation.cpp
}  // namespace detail

/// The contribution of one curve to `discretisation_error`: running sums of the areas between its segments and the
/// smooth curve through its vertices. The points must stay alive. O(N), parallel; 9 bytes a point, 33 of a short one.
class DiscretisationSums {
 public:
  /// Sums of a curve whose points stay alive.
  LOBER_API explicit DiscretisationSums(CurveView curve);
  [[nodiscard]] LOBER_API std::size_t memory() const;  ///< bytes
  /// For the library itself.
  [[nodiscard]] const detail::DiscretisationData& data() const { return *data_; }

 private:
  std::shared_ptr<const detail::DiscretisationData> data_;
};

/// Estimate, for each area, of |polygon - smooth curve through the same points|: the area between each segment and the
/// local cubic through its two ends and their neighbours, added up over the arcs that bound the region. Right to the
/// leading order for smooth curves (error per segment of order h^5 against h^3). The smooth curves cross elsewhere:
/// each crossing adds the area where the parabolas over its two segments have come to the other side of each other and
/// the segments have not. Where curves are nearly tangent, and a lens no thicker than arcs are high, that is most of
/// it. If the curves do not cross at all, the area in which arcs have done so is added, from above, since a lens may be
/// missing in the polygons; lenses that are missing beside others are not looked for. The true error of 4500 nearly
/// tangent pairs of circles that cross was up to 4.2 times the estimate, and in one of a hundred more than 1.03 times
/// that. One pass over the points, parallel.
[[nodiscard]] LOBER_API Areas discretisation_error(const Overlay& result);

/// The same estimate, bit for bit, for curves that occur in many pairs, whose sums are known already. O(contacts); for
/// curves that do not cross, O(pairs of 16 segments that come nearer than arcs bend), and N once for each curve.
[[nodiscard]] LOBER_API Areas discretisation_error(const Overlay& result, const DiscretisationSums& first,
                                                   const DiscretisationSums& second);

}  // namespace lober

// Regions of closed curves that may cross, touch and overlap themselves: the area of each pair of winding numbers, and
// the regions that a rule makes of them.
//
// The winding number of a curve about a point counts how often the curve runs round it, positive counter-clockwise. It
// is the same all over a face of the arrangement of both curves. A rule says which winding numbers are inside; then
// there are the four pairings of overlay/, with areas and pieces as regularised as there: a piece is a connected
// component of the interior of the region, so faces that share an edge belong together, faces that meet in a vertex
// only do not. For simple curves that run counter-clockwise every rule but `negative` gives what overlay() gives.
//
//   lober::Regions result = lober::regions(c1, c2);
//   for (const lober::WindingArea& entry : result.table()) use(entry.w1, entry.w2, entry.area);
//   double flux = result.areas(lober::FillRule::nonzero).c1_minus_c2;
//   const lober::RegionPieces lobes = result.pieces(lober::FillRule::nonzero, lober::Pairing::c1_minus_c2);
//   for (const lober::RegionPiece lobe : lobes) use(lobe.area, lobe.holes);
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "lober/base/element_iterator.hpp"
#include "lober/base/export.hpp"
#include "lober/base/progress.hpp"
#include "lober/overlay/overlay.hpp"

namespace lober {

/// The winding numbers that are inside: those that are not zero, odd, positive or negative.
enum class FillRule : std::uint8_t { nonzero, evenodd, positive, negative };
/// All fill rules.
inline constexpr std::array<FillRule, 4> all_fill_rules{FillRule::nonzero, FillRule::evenodd, FillRule::positive,
                                                        FillRule::negative};
/// The name of the rule.
[[nodiscard]] LOBER_API std::string_view name(FillRule rule);
/// Whether a winding number is inside. Zero never is.
[[nodiscard]] LOBER_API bool inside(FillRule rule, int winding);

/// The area where C1 winds w1 times and C2 winds w2 times.
struct WindingArea {
  int w1, w2;   ///< winding numbers of C1 and C2
  double area;  ///< area of all faces with them
};

/// One connected component of a region. A hole is a bounded component of the interior of its complement.
struct RegionPiece {
  double area = 0;          ///< its area
  std::uint32_t holes = 0;  ///< number of holes
};

/// Counts of the work of regions.
struct RegionCounts {
  std::uint64_t nodes = 0;  ///< points where edge chains meet or a spike ends
  std::uint64_t edges = 0;  ///< edge chains between nodes, those that coincide counted once; 1 for a curve without node
  std::uint64_t faces = 0;  ///< the unbounded one included
  std::uint64_t self1 = 0, self2 = 0, mutual = 0;  ///< pairs of edge chains that meet in a point, by curve
  IndexKind index = IndexKind::tree;               ///< used for C1 against C2
  SearchCounts search;                             ///< counts of the searches
  PredicateCounts predicates;                      ///< counts of the predicates
  std::uint64_t exact_parameters = 0;              ///< parameters of crossings computed in exact arithmetic
  std::uint64_t exact_orders = 0;                  ///< pairs of crossings ordered in exact arithmetic
};

/// Seconds of wall time of each phase.
struct RegionTiming {
  double index = 0, search = 0, nodes = 0, graph = 0, faces = 0, total = 0;  ///< each phase, and all of them
};

/// Options of regions.
struct RegionOptions {
  IndexKind index = IndexKind::automatic;  ///< index that proposes which segments can meet; results do not depend on it
  Progress progress{};                     ///< called with the fraction done, between phases
};

namespace detail {
struct Arrangement;  // private: engine/geometry/regions/arrangement.hpp
struct RegionPiecesData;
}  // namespace detail

/// The pieces of one region, in the order in which their faces come along C1, then C2: a range of RegionPiece with
/// random access. Cheap to copy.
class RegionPieces {
 public:
  LOBER_API RegionPieces();  ///< none
  /// For the library itself.
  explicit RegionPieces(std::shared_ptr<const detail::RegionPiecesData> data) : data_(std::move(data)) {}

  /// Number of pieces.
  [[nodiscard]] std::size_t size() const { return areas().size(); }
  /// The areas of all pieces.
  [[nodiscard]] LOBER_API std::span<const double> areas() const&;
  [[nodiscard]] std::span<const double> areas() const&& = delete;  // a view of data that goes with the temporary
  /// A piece by its number.
  [[nodiscard]] LOBER_API RegionPiece operator[](std::size_t piece) const;
  using Iterator = ElementIterator<RegionPieces>;  ///< a position in the range
  /// The first piece.
  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  /// The end of the pieces.
  [[nodiscard]] Iterator end() const { return {*this, size()}; }
  /// The boundary of a piece as closed polygons: the outer one first, counter-clockwise, then the holes, clockwise.
  /// Polygons do not cross, but may touch each other, and the outer one itself, in vertices. O(vertices).
  [[nodiscard]] LOBER_API std::vector<std::vector<Point>> outline(std::size_t piece) const;

 private:
  std::shared_ptr<const detail::RegionPiecesData> data_;
};

/// Cheap to copy; keeps alive what the curves own.
class Regions {
 public:
  LOBER_API Regions();  ///< the regions of no curve
  /// For the library itself.
  explicit Regions(std::shared_ptr<const detail::Arrangement> arrangement) : arrangement_(std::move(arrangement)) {}

  /// All pairs of winding numbers that occur, ascending, without (0, 0).
  [[nodiscard]] LOBER_API std::span<const WindingArea> table() const&;
  [[nodiscard]] std::span<const WindingArea> table() const&& = delete;  // data that goes with the temporary
  /// Signed areas of C1 and C2: the sums of winding number times area.
  [[nodiscard]] LOBER_API std::array<double, 2> signed_areas() const;
  /// As in Overlay::areas; c1 is the area of the region of C1 under the rule.
  [[nodiscard]] LOBER_API Areas areas(FillRule rule) const;
  /// Bounds on |computed - exact area of the region of the polygons|.
  [[nodiscard]] LOBER_API Areas rounding(FillRule rule) const;
  /// The bound for an area of the table or of a piece.
  [[nodiscard]] LOBER_API double rounding(double area) const;
  /// O(faces + edges). With one curve, C2 is empty: c1_minus_c2 is the region of C1.
  [[nodiscard]] LOBER_API RegionPieces pieces(FillRule rule, Pairing pairing) const;

  /// Counts of the work.
  [[nodiscard]] LOBER_API const RegionCounts& counts() const&;
  /// Counts of the work, of a temporary.
  [[nodiscard]] RegionCounts counts() const&& { return counts(); }
  /// Seconds of each phase.
  [[nodiscard]] LOBER_API const RegionTiming& timing() const&;
  /// Seconds of each phase, of a temporary.
  [[nodiscard]] RegionTiming timing() const&& { return timing(); }

 private:
  std::shared_ptr<const detail::Arrangement> arrangement_;
};

/// The regions of one or two closed curves of any shape; the orientation of the input is kept. Result and
/// pieces keep alive what the curves own. Throws DataError (validate; also an area beyond the range of double),
/// Cancelled. Time in proportion to the points (one pass) and to the pairs that the search of both curves against
/// themselves and each other meets; memory besides the box trees in proportion to the points where edge chains meet.
/// Areas that exceed 1e-12 of the bounding box have a relative error below 1e-15, smaller ones an error below 1e-27 of
/// the box. All decisions are exact; the same bits for any number of threads and any index. Where k edge chains run
/// along each other, k^2 / 2 pairs meet at each of their vertices.
[[nodiscard]] LOBER_API Regions regions(const ClosedCurve& c1, const RegionOptions& options = {});
/// The regions of two closed curves of any shape.
[[nodiscard]] LOBER_API Regions regions(const ClosedCurve& c1, const ClosedCurve& c2,
                                        const RegionOptions& options = {});

/// The same for closed curves that are indexed already (and validated by the caller). Throws UsageError for an open
/// one.
[[nodiscard]] LOBER_API Regions regions(const IndexedCurve& c1, const RegionOptions& options = {});
/// The regions of two closed curves that are indexed already.
[[nodiscard]] LOBER_API Regions regions(const IndexedCurve& c1, const IndexedCurve& c2,
                                        const RegionOptions& options = {});

}  // namespace lober

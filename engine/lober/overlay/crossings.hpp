// The nodes of two closed curves: crossings, touches and shared arcs, decided exactly and ordered along both curves.
//
// Two simple closed curves meet in finitely many connected sets, each a point or an arc that they share: the *nodes*.
// At a node C2 either passes from one side of C1 to the other (a crossing, rho = +1 or -1) or stays on one side
// (a touch, rho = 0). A shared arc is a node like any other: C1 crosses C2 along it or only touches.
// So crossings are always even in number and their signs alternate along either curve (docs/conventions.md, section 3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/curve/curve.hpp"
#include "lober/overlay/counts.hpp"
#include "lober/overlay/index.hpp"
#include "lober/overlay/segment_pair.hpp"

namespace lober {

/// A position on a curve: `t` in [0, 1) along segment `segment` (rounded, so 1 may occur), in the vertex order of the
/// caller's curve.
struct Position {
  std::uint32_t segment = 0;  ///< number of the segment
  double t = 0;               ///< position along it
  /// Whether both members are equal.
  friend bool operator==(const Position&, const Position&) = default;
};

/// A connected set where the curves meet. For a point `begin` and `end` are equal.
struct Node {
  Position begin1, end1;  ///< along C1 as the caller's vertices run; end1 comes after begin1 (cyclically)
  Position begin2, end2;  ///< the same two points on C2
  Point begin, end;       ///< the same two points, rounded to double
  int rho = 0;            ///< +1: C1 leaves A2; -1: C1 enters A2; 0: a touch
  int shared = 0;         ///< 0: a point; +1: an arc shared in the same direction; -1: in opposite directions
                          ///< (both curves taken counter-clockwise)
};

namespace detail {
struct CrossingsData;  // private: engine/geometry/crossings/crossings_data.hpp
}  // namespace detail

/// The nodes of two curves in order along C1, from its first vertex on. Cheap to copy; keeps alive what the curves own.
class Crossings {
 public:
  LOBER_API Crossings();  ///< none
  /// For the library itself.
  explicit Crossings(std::shared_ptr<const detail::CrossingsData> data) : data_(std::move(data)) {}

  /// Number of nodes.
  [[nodiscard]] LOBER_API std::size_t size() const;
  /// A node by its number.
  [[nodiscard]] LOBER_API Node operator[](std::size_t node) const;
  /// Node numbers in order along C2, from its first vertex on.
  [[nodiscard]] LOBER_API std::span<const std::uint32_t> order2() const&;
  [[nodiscard]] std::span<const std::uint32_t> order2() const&& = delete;  // a view of data that goes with the result
  /// The index of a node in order2().
  [[nodiscard]] LOBER_API std::uint32_t rank2(std::size_t node) const;
  /// Rho of a node, without its coordinates.
  [[nodiscard]] LOBER_API int rho(std::size_t node) const;
  [[nodiscard]] LOBER_API std::size_t crossings() const;    ///< nodes with rho != 0: always even
  [[nodiscard]] LOBER_API std::size_t touches() const;      ///< points with rho == 0
  [[nodiscard]] LOBER_API std::size_t shared_arcs() const;  ///< arcs; 1 when the curves are one and the same
  /// Whether both curves are the same set of points.
  [[nodiscard]] LOBER_API bool same_curve() const;
  [[nodiscard]] LOBER_API const ContactCounts& counts() const&;  ///< counts of the search
  /// Counts of the search, of a temporary.
  [[nodiscard]] ContactCounts counts() const&& { return counts(); }
  /// C1.
  [[nodiscard]] LOBER_API const CurveView& curve1() const&;
  [[nodiscard]] const CurveView& curve1() const&& = delete;
  /// C2.
  [[nodiscard]] LOBER_API const CurveView& curve2() const&;
  [[nodiscard]] const CurveView& curve2() const&& = delete;
  /// Whether C1 runs clockwise.
  [[nodiscard]] LOBER_API bool clockwise1() const;
  /// Whether C2 runs clockwise.
  [[nodiscard]] LOBER_API bool clockwise2() const;

  /// For the library itself.
  [[nodiscard]] const detail::CrossingsData& data() const { return *data_; }

 private:
  std::shared_ptr<const detail::CrossingsData> data_;
};

/// The cost of require_simple.
struct SimpleCheck {
  SearchCounts search;      ///< counts of the search
  std::uint64_t pairs = 0;  ///< pairs of segments decided
};
/// Throws NotSimpleError unless the closed curve is simple: no two segments meet except neighbours in their common
/// vertex. `number` is what the error calls the curve (1 or 2). Decided exactly; monotone runs are skipped, so a smooth
/// curve costs next to nothing. Parallel; names the first pair of segments in curve order.
LOBER_API SimpleCheck require_simple(const IndexedCurve& curve, int number);

/// A point that two curves have in common: a proper crossing of two segments, or a vertex of one on the other.
struct CommonPoint {
  Position first, second;                 ///< along each curve, as its vertices run
  Point at;                               ///< rounded to double; exact at a vertex
  bool vertex1 = false, vertex2 = false;  ///< at the vertex where the segment begins
};
/// All common points, in order along the first curve. A shared arc gives its vertices; a long common run counts once.
/// Curves may be open or closed, and cross themselves. The last vertex of an open curve is not looked at. Uses the
/// search of overlay.
[[nodiscard]] LOBER_API std::vector<CommonPoint> common_points(const IndexedCurve& first, const IndexedCurve& second);

/// The result of self_meetings.
struct SelfMeetings {
  std::vector<SegmentPair> pairs;  ///< the pairs that were found
  SimpleCheck check;               ///< the cost
};
/// Pairs of segments that meet where those of a simple curve do not, in curve order: the first `most` of each block of
/// the search, and at most `most` in all. Costs what require_simple costs; without such pairs `check` is its result.
[[nodiscard]] LOBER_API SelfMeetings self_meetings(const IndexedCurve& curve, std::size_t most);

}  // namespace lober

// Where two closed curves meet: crossings, touches and shared arcs, decided exactly and ordered along both curves.
//
// Two simple closed curves meet in finitely many connected sets, each a point or an arc that they share: the *nodes*.
// At a node C2 either passes from one side of C1 to the other (a crossing, rho = +1 or -1) or stays on one side
// (a touch, rho = 0). A shared arc is a node like any other: C1 crosses C2 along it or only touches.
// So crossings are always even in number and their signs alternate along either curve (DESIGN section 2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/geometry/crossings/node_graph.hpp"
#include "engine/geometry/curve/curve.hpp"
#include "kernels/point.hpp"

namespace lober {

/// A place on a curve: `t` in [0, 1) along segment `segment` (rounded, so 1 may occur), in the vertex order of the
/// caller's curve.
struct Position {
  std::uint32_t segment = 0;
  double t = 0;
  friend bool operator==(const Position&, const Position&) = default;
};

/// One place where the curves meet. For a point `begin` and `end` are equal.
struct Node {
  Position begin1, end1;  ///< along C1 as the caller's vertices run; end1 comes after begin1 (cyclically)
  Position begin2, end2;  ///< the same two points on C2
  Point begin, end;       ///< the same two points, rounded to double
  int rho = 0;            ///< +1: C1 leaves A2; -1: C1 enters A2; 0: a touch
  int shared = 0;         ///< 0: a point; +1: an arc shared in the same direction; -1: in opposite directions
                          ///< (both curves taken counter-clockwise)
};

/// The nodes of two curves in order along C1, from its first vertex on. The points of both must stay alive.
class Crossings {
 public:
  Crossings() = default;
  Crossings(NodeGraph graph, CurveView c1, CurveView c2, Orientation orientation1, Orientation orientation2);

  [[nodiscard]] std::size_t size() const { return graph_.size(); }
  [[nodiscard]] Node operator[](std::size_t node) const;
  /// Node numbers in order along C2, from its first vertex on.
  [[nodiscard]] std::span<const std::uint32_t> order2() const { return graph_.along2(); }
  [[nodiscard]] int rho(std::size_t node) const;
  [[nodiscard]] std::size_t crossings() const { return crossings_; }  ///< nodes with rho != 0: always even
  [[nodiscard]] std::size_t touches() const { return touches_; }      ///< points with rho == 0
  [[nodiscard]] std::size_t shared_arcs() const {
    return shared_arcs_;
  }  ///< arcs; 1 when the curves are one and the same
  [[nodiscard]] bool same_curve() const { return graph_.same_curve != 0; }
  /// The contact rounded to double: exact at a vertex, else right to about an ulp.
  [[nodiscard]] Point place(const Contact& contact) const;
  /// The same nodes on curves with the same vertices at another scale.
  [[nodiscard]] Crossings on(CurveView c1, CurveView c2) && {
    c1_ = c1;
    c2_ = c2;
    return std::move(*this);
  }
  [[nodiscard]] const NodeGraph& graph() const { return graph_; }
  [[nodiscard]] const CurveView& curve1() const { return c1_; }
  [[nodiscard]] const CurveView& curve2() const { return c2_; }
  [[nodiscard]] bool clockwise1() const { return clockwise1_; }
  [[nodiscard]] bool clockwise2() const { return clockwise2_; }

 private:
  NodeGraph graph_;
  CurveView c1_, c2_;
  bool clockwise1_ = false, clockwise2_ = false;
  std::size_t crossings_ = 0, touches_ = 0, shared_arcs_ = 0;
};

/// Throws NotSimpleError unless the closed curve is simple: no two segments meet except neighbours in their common
/// vertex. `number` is what the error calls the curve (1 or 2). Decided exactly; monotone runs are skipped, so a smooth
/// curve costs next to nothing. Parallel; names the first pair of segments in curve order. `exponent`: the coordinates
/// are the caller's times 2^exponent, who is told the place in his own.
struct SimpleCheck {
  SearchCounts search;
  std::uint64_t pairs = 0;  ///< pairs of segments decided
};
SimpleCheck require_simple(const IndexedCurve& curve, int number, int exponent = 0);

/// Pairs of segments that meet where a simple curve's do not, in curve order: the first `most` of each block of the
/// search, and no more than that in all. The cost of require_simple.
[[nodiscard]] std::vector<SegmentPair> self_meetings(const IndexedCurve& curve, std::size_t most);

}  // namespace lober

// Areas of regions by winding numbers, of the smooth curves, where the path that closes the boundary of a tangle meets
// the manifolds (private to tangle/).
//
// Let g be 1 where the boundary winds, or where both the boundary and a lobe do, and 0 elsewhere. Its integral is that
// of (x dy - y dx) / 2 along U, S and the closure, each arc between crossings weighted with c = g on its left less g on
// its right. Where curve a crosses curve b the weight of a changes by as much as that of b, the other way, so that
//   2 area = sum over crossings of J (S_a - S_b),   J = c of a before less c of a behind,
// with the sums S along both curves up to the crossing (engine/lober/tangle/tangle.hpp), and what the closure adds
// where it ends. The polygons say which crossings there are, and how often each curve winds beside them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/geometry/index/sums_along.hpp"
#include "engine/geometry/tangle/closing_path.hpp"
#include "engine/geometry/tangle/curves.hpp"
#include "lober/base/measured.hpp"

namespace lober::detail {

class WindingSums {
 public:
  /// The tangle is one of smooth curves, and has a boundary, which the path closes. O(N + M).
  WindingSums(const Tangle& tangle, const ClosingPath& path);

  /// The area where the smooth boundary winds, given that of the polygon. Nothing where the polygons do not determine
  /// how the smooth curves lie: the closure touches them or runs along them, or crossings change their order.
  [[nodiscard]] std::optional<Measured> boundary(double polygon_area) const { return measure({}, polygon_area); }
  /// The area of the part of a lobe inside it, likewise.
  [[nodiscard]] std::optional<Measured> inside(std::size_t lobe, double polygon_area) const {
    return measure(lobe, polygon_area);
  }

 private:
  enum Curve : std::uint8_t { on_u, on_s, on_path, curves };
  struct Node {
    std::array<Curve, 2> curve;
    int sign;                              // +1: the second curve passes from the right of the first one to its left
    std::array<std::uint32_t, 2> rank;     // number along each curve
    std::array<double, 2> at, error;       // where the smooth curves cross, and the sum of errors up to there
    Point point;                           // at the scale of TangleCurves
    double polygons, smooth, uncertainty;  // S of the first less S of the second: of polygons, and what is to be added
    [[nodiscard]] std::size_t side(Curve of) const { return curve[0] == of ? 0 : 1; }
  };
  // Winding numbers on both sides of an arc.
  struct Sides {
    int left = 0, right = 0;
    friend bool operator==(const Sides&, const Sides&) = default;
  };
  // Those of one closed curve, for each arc of U, S and the closure. Arc k ends at node k of its curve.
  using Windings = std::array<std::vector<Sides>, curves>;
  // How often it runs along each arc, as the curves run.
  using Runs = std::array<std::vector<int>, curves>;

  void add_nodes(const IndexedCurve& first, const IndexedCurve& second, const NodeGraph& graph, Curve a, Curve b,
                 const std::vector<std::uint32_t>& numbers, const SmoothGaps& smooth);
  void add_manifold_nodes();
  void add_path_nodes();
  void sort_nodes();
  [[nodiscard]] bool find_boundary();
  [[nodiscard]] std::optional<int> left_of_first_arc() const;
  [[nodiscard]] Runs no_runs() const;
  [[nodiscard]] std::optional<Windings> windings_of(std::size_t lobe) const;
  void carry(const Runs& runs, Curve curve, Sides first, Windings& windings) const;
  [[nodiscard]] bool consistent(const Windings& windings) const;
  [[nodiscard]] double twice_turned_over(const Node& one, const Node& other, Curve curve) const;
  [[nodiscard]] std::optional<Measured> measure(std::optional<std::size_t> lobe, double polygon_area) const;

  const Tangle& tangle_;
  const TangleCurves& curves_;
  bool usable_ = true;
  const ClosingPath& path_;
  std::vector<Node> nodes_;
  std::vector<std::array<PrecisePosition, 2>> positions_;  // by node
  std::array<std::vector<std::uint32_t>, curves> along_;   // nodes in order along each curve
  std::vector<std::uint32_t> pip_nodes_;                   // by pip
  DD path_end_;                                            // S of the closure where it ends
  Windings boundary_;
};

}  // namespace lober::detail

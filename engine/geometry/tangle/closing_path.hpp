// The path that closes the boundary, and where it meets the manifolds (private to tangle/).
#pragma once

#include <optional>
#include <vector>

#include "engine/geometry/crossings/node_graph.hpp"
#include "engine/geometry/tangle/curves.hpp"

namespace lober::detail {

/// That path, from p+ to p-, at the scale of TangleCurves.
[[nodiscard]] std::vector<Point> closing_path(const Tangle& tangle);

/// The same with where it meets itself, U and S. O(N + M) at most, less where it is short and keeps away.
class ClosingPath {
 public:
  explicit ClosingPath(const Tangle& tangle);

  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  /// Whether it has any length; else it meets nothing, and there is no index of it.
  [[nodiscard]] bool has_length() const { return index_.has_value(); }
  [[nodiscard]] const IndexedCurve& index() const { return *index_; }
  /// Whether both its ends are one point, and it has others: the boundary then touches itself there.
  [[nodiscard]] bool is_loop() const { return has_length() && points_.front() == points_.back(); }
  /// Whether it meets itself but where its segments join, and where both its ends are one point.
  [[nodiscard]] bool meets_itself() const { return meets_itself_; }
  /// Where U and S, curve 1 of these graphs, meet it, curve 2.
  [[nodiscard]] const NodeGraph& on_u() const { return on_u_; }
  [[nodiscard]] const NodeGraph& on_s() const { return on_s_; }
  /// Whether a contact of one of them lies where the manifold begins, whose first vertex may be repeated, and the path
  /// has a vertex.
  [[nodiscard]] static bool at_start(const IndexedCurve& manifold, const Contact& contact);

 private:
  std::vector<Point> points_;
  std::optional<IndexedCurve> index_;
  bool meets_itself_ = false;
  NodeGraph on_u_, on_s_;
};

}  // namespace lober::detail

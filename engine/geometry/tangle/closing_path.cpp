#include "engine/geometry/tangle/closing_path.hpp"

#include <algorithm>
#include <cmath>

namespace lober::detail {
namespace {

bool path_meets_itself(const std::vector<Point>& path) {
  if (path.size() < 4) return false;  // two segments meet where they join, or run back along each other
  std::vector<Point> round = path;
  const bool closed = path.front() == path.back();
  if (closed) round.pop_back();
  return !self_meetings(IndexedCurve(CurveView{round, closed}), 1).pairs.empty();
}

}  // namespace

std::vector<Point> closing_path(const Tangle& tangle) {
  const TangleCurves& curves = *tangle.curves;
  std::vector<Point> path{curves.s().view().points[0]};
  for (const Point corner : tangle.closure)
    path.push_back({std::ldexp(corner.x, curves.exponent), std::ldexp(corner.y, curves.exponent)});
  path.push_back(curves.u().view().points[0]);
  return path;
}

ClosingPath::ClosingPath(const Tangle& tangle) : points_(closing_path(tangle)) {
  if (points_.size() == 2 && points_[0] == points_[1]) return;
  meets_itself_ = path_meets_itself(points_);
  index_.emplace(CurveView{points_, false});
  on_u_ = build_node_graph(tangle.curves->u(), *index_, IndexKind::tree);
  on_s_ = build_node_graph(tangle.curves->s(), *index_, IndexKind::tree);
}

bool ClosingPath::at_start(const IndexedCurve& manifold, const Contact& contact) {
  const auto points = manifold.view().points.first(contact.segment1 + 1);
  return contact.vertex1 && contact.vertex2 &&
         std::all_of(points.begin(), points.end(), [&](Point p) { return p == points[0]; });
}

}  // namespace lober::detail

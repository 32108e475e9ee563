#include "engine/geometry/crossings/crossings.hpp"

namespace lober {

Crossings::Crossings(NodeGraph graph, CurveView c1, CurveView c2, Orientation orientation1, Orientation orientation2)
    : graph_(std::move(graph)),
      c1_(c1),
      c2_(c2),
      clockwise1_(orientation1 == Orientation::clockwise),
      clockwise2_(orientation2 == Orientation::clockwise) {
  for (std::uint32_t k = 0; k < graph_.size(); ++k) {
    const bool arc = graph_.span(k).direction != 0;
    const bool crossing = graph_.order[k] < first_touch;
    if (crossing) ++crossings_;
    if (arc) ++shared_arcs_;
    if (!crossing && !arc) ++touches_;
  }
  if (same_curve()) shared_arcs_ = 1;
}

int Crossings::rho(std::size_t node) const {
  const std::uint8_t order = graph_.order[node];
  if (order >= first_touch) return 0;
  return (order == rightward_to_left) == (clockwise1_ == clockwise2_) ? 1 : -1;
}

Point Crossings::place(const Contact& contact) const {
  return place_of(contact, c1_, c2_);
}

Node Crossings::operator[](std::size_t number) const {
  const NodeSpan span = graph_.span(static_cast<std::uint32_t>(number));
  const Contact first = graph_.contacts[span.first], last = graph_.contacts[span.last];
  Node node;
  node.begin1 = {first.segment1, first.t1.hi};
  node.end1 = {last.segment1, last.t1.hi};
  node.begin2 = {first.segment2, first.t2.hi};
  node.end2 = {last.segment2, last.t2.hi};
  node.begin = place(first);
  node.end = span.first == span.last ? node.begin : place(last);
  node.rho = rho(number);
  node.shared = clockwise1_ == clockwise2_ ? span.direction : -span.direction;
  return node;
}

}  // namespace lober

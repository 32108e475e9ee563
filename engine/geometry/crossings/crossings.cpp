#include "lober/overlay/crossings.hpp"

#include "engine/base/parallel/running_sums.hpp"
#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/curve/scaled.hpp"

namespace lober {
using namespace detail;

namespace {

void set_curves(CrossingsData& data, const IndexedCurve& c1, const IndexedCurve& c2) {
  data.c1 = c1.view();
  data.c2 = c2.view();
  data.owner1 = c1.owner();
  data.owner2 = c2.owner();
  data.exponent = scaling_exponent(union_of(c1.tree().box(), c2.tree().box()));
}

}  // namespace

Crossings detail::make_crossings(NodeGraph graph, const IndexedCurve& c1, const IndexedCurve& c2,
                                 Orientation orientation1, Orientation orientation2) {
  auto data = std::make_shared<CrossingsData>();
  data->graph = std::move(graph);
  set_curves(*data, c1, c2);
  data->clockwise1 = orientation1 == Orientation::clockwise;
  data->clockwise2 = orientation2 == Orientation::clockwise;
  const NodeGraph& nodes = data->graph;
  data->crossings = nodes.size();
  if (!nodes.spans.empty()) {
    const auto crosses = [&](std::size_t k) { return nodes.order[k] < first_touch; };
    const auto is_arc = [&](std::size_t k) { return nodes.spans[k].direction != 0; };
    data->crossings = sum_of(nodes.size(), crosses);
    data->shared_arcs = sum_of(nodes.size(), is_arc);
    data->touches = sum_of(nodes.size(), [&](std::size_t k) { return !crosses(k) && !is_arc(k); });
  }
  if (data->graph.same_curve != 0) data->shared_arcs = 1;
  return Crossings(std::move(data));
}

Crossings detail::moved_to(const Crossings& nodes, const IndexedCurve& c1, const IndexedCurve& c2) {
  auto data = std::make_shared<CrossingsData>(nodes.data());
  set_curves(*data, c1, c2);
  return Crossings(std::move(data));
}

Crossings::Crossings() {
  static const auto none = std::make_shared<const CrossingsData>();
  data_ = none;
}

std::size_t Crossings::size() const {
  return data_->graph.size();
}
std::span<const std::uint32_t> Crossings::order2() const& {
  return data_->graph.along2();
}
std::uint32_t Crossings::rank2(std::size_t node) const {
  return data_->graph.rank2[node];
}
const ContactCounts& Crossings::counts() const& {
  return data_->graph.counts;
}
std::size_t Crossings::crossings() const {
  return data_->crossings;
}
std::size_t Crossings::touches() const {
  return data_->touches;
}
std::size_t Crossings::shared_arcs() const {
  return data_->shared_arcs;
}
bool Crossings::same_curve() const {
  return data_->graph.same_curve != 0;
}
const CurveView& Crossings::curve1() const& {
  return data_->c1;
}
const CurveView& Crossings::curve2() const& {
  return data_->c2;
}
bool Crossings::clockwise1() const {
  return data_->clockwise1;
}
bool Crossings::clockwise2() const {
  return data_->clockwise2;
}

int Crossings::rho(std::size_t node) const {
  const std::uint8_t order = data_->graph.order[node];
  if (order >= first_touch) return 0;
  return (order == rightward_to_left) == (data_->clockwise1 == data_->clockwise2) ? 1 : -1;
}

Node Crossings::operator[](std::size_t number) const {
  const NodeGraph& graph = data_->graph;
  const NodeSpan span = graph.span(static_cast<std::uint32_t>(number));
  const Contact first = graph.contacts[span.first], last = graph.contacts[span.last];
  Node node;
  node.begin1 = {first.segment1, first.t1.hi};
  node.end1 = {last.segment1, last.t1.hi};
  node.begin2 = {first.segment2, first.t2.hi};
  node.end2 = {last.segment2, last.t2.hi};
  node.begin = contact_point(*this, first);
  node.end = span.first == span.last ? node.begin : contact_point(*this, last);
  node.rho = rho(number);
  node.shared = data_->clockwise1 == data_->clockwise2 ? span.direction : -span.direction;
  return node;
}

std::vector<CommonPoint> common_points(const IndexedCurve& first, const IndexedCurve& second) {
  const ContactList contacts = find_contacts(first, second, choose_index(first, second)).list;
  std::vector<CommonPoint> points(contacts.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Contact contact = contacts[k];
    points[k] = {{contact.segment1, contact.t1.hi},
                 {contact.segment2, contact.t2.hi},
                 contact_point(contact, first.view(), second.view()),
                 contact.vertex1,
                 contact.vertex2};
  }
  return points;
}

}  // namespace lober

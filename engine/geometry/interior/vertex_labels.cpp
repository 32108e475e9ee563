// Labels carried along a curve: they change at nodes only.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

#include "engine/geometry/crossings/crossings_data.hpp"
#include "lober/overlay/interior.hpp"

namespace lober {
using namespace detail;
namespace {

// The side of the arc that leaves a node. The region of a counter-clockwise curve lies between its way
// out and its way in, turning counter-clockwise.
Side side_after(const Crossings& nodes, int curve, std::uint32_t node) {
  using enum HalfEdge;
  const std::array<HalfEdge, 4>& order = rotations[graph_of(nodes).order[node]];
  const auto index_of = [&](HalfEdge half_edge) { return std::find(order.begin(), order.end(), half_edge); };
  // Half-edges are listed from forward1 on, so a turn from forward2 meets backward1 before it comes round to forward1
  // if backward1 is listed after it.
  const bool on_left = curve == 1 ? index_of(backward2) < index_of(forward2) : index_of(forward2) < index_of(backward1);
  const bool clockwise = curve == 1 ? nodes.clockwise2() : nodes.clockwise1();
  return on_left != clockwise ? Side::inside : Side::outside;
}

}  // namespace

std::vector<SideChange> side_changes(const Crossings& nodes, int curve) {
  const NodeGraph& graph = graph_of(nodes);
  constexpr std::uint8_t unchanged = 0xff;
  std::vector<std::uint8_t> after(graph.contacts.size(), unchanged);
  for (std::uint32_t node = 0; node < graph.size(); ++node) {
    const NodeSpan span = graph.span(node);
    const bool along = curve == 1 || span.direction >= 0;
    after[along ? span.first : span.last] = static_cast<std::uint8_t>(Side::on);
    after[along ? span.last : span.first] = static_cast<std::uint8_t>(side_after(nodes, curve, node));
  }
  std::vector<SideChange> changes;
  changes.reserve(graph.size());
  for (std::uint32_t index = 0; index < graph.contacts.size(); ++index) {
    const std::uint32_t number = curve == 1 ? index : graph.contacts2[index];
    if (after[number] == unchanged) continue;
    const Contact contact = graph.contacts[number];
    const auto side = static_cast<Side>(after[number]);
    if (curve == 1) {
      changes.push_back({{contact.segment1, contact.t1.hi}, contact.vertex1, contact_point(nodes, contact), side});
    } else {
      changes.push_back({{contact.segment2, contact.t2.hi}, contact.vertex2, contact_point(nodes, contact), side});
    }
  }
  return changes;
}

Buffer<Side> label_vertices(const Crossings& nodes, int curve) {
  const CurveView& own = curve == 1 ? nodes.curve1() : nodes.curve2();
  const CurveView& other = curve == 1 ? nodes.curve2() : nodes.curve1();
  const auto size = static_cast<std::uint32_t>(own.points.size());
  Buffer<Side> labels(size);
  const auto fill = [&](std::size_t begin, std::size_t end, Side side) {
    if (begin < end) std::memset(labels.data() + begin, static_cast<int>(side), end - begin);
  };
  if (nodes.same_curve()) {
    fill(0, size, Side::on);
    return labels;
  }
  const std::vector<SideChange> changes = side_changes(nodes, curve);
  if (changes.empty()) {
    fill(0, size, locate(IndexedCurve(other), own.points[0]));
    return labels;
  }
  fill(0, changes.front().at.segment + std::size_t{1}, changes.back().side);
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const std::size_t end = k + 1 < changes.size() ? changes[k + 1].at.segment + std::size_t{1} : size;
    fill(changes[k].at.segment + std::size_t{1}, end, changes[k].side);
  }
  for (const SideChange& change : changes) {
    if (!change.at_vertex) continue;
    // Among vertices at one point only the last begins a segment; the copies before it are on the other curve as
    // well.
    std::uint32_t vertex = change.at.segment;
    do {
      labels[vertex] = Side::on;
      vertex = vertex == 0 ? size - 1 : vertex - 1;
    } while (own.points[vertex] == change.point && labels[vertex] != Side::on);
  }
  return labels;
}

}  // namespace lober

#include "engine/geometry/regions/faces.hpp"

#include <algorithm>
#include <vector>

#include "kernels/shoelace.hpp"

namespace lober::detail {
namespace {

constexpr std::uint32_t unknown = 0xffffffff;

// Calls visit(half) along the closed walk that keeps a face on the left.
template <typename Visit>
void walk_round(const HalfEdges& graph, std::uint32_t start, const Visit& visit) {
  std::uint32_t half = start;
  do {
    visit(half);
    half = graph.next(half);
  } while (half != start);
}

// A component of the graph whose outer walk bounds a face of the other one, or the unbounded face.
struct Guest {
  std::uint32_t outer;  // the lowest half-edge of that walk
  std::uint32_t host;   // a half-edge of the walk of the other component around it, or no_half_edge
  std::uint32_t face = RegionFaces::unbounded;
};

std::vector<Guest> guests_of(const EdgeChains& edge_chains, const Events& events, const HalfEdges& graph,
                             bool curves_meet, const IndexedCurve& c1, const IndexedCurve* c2,
                             PredicateCounts& counts) {
  const auto lowest = [&](std::size_t curve) {
    std::uint32_t found = graph.outer[curve];
    walk_round(graph, found, [&](std::uint32_t half) { found = std::min(found, half); });
    return found;
  };
  const auto extreme = [&](std::size_t curve) { return point_of(edge_chains, events[events.extreme[curve]]); };
  if (c2 == nullptr) return {{lowest(0), no_half_edge}};
  if (curves_meet) {
    const Point p = extreme(0), q = extreme(1);
    const bool first = p.x > q.x || (p.x == q.x && p.y >= q.y);
    return {{lowest(first ? 0 : 1), no_half_edge}};
  }
  const auto half_edge_around = [&](std::size_t curve) {
    const int other = curve == 0 ? 1 : 0;
    return half_edge_right_of(extreme(curve), edge_chains, events, graph, other == 0 ? c1 : *c2, other, counts);
  };
  return {{lowest(0), half_edge_around(0)}, {lowest(1), half_edge_around(1)}};
}

class FaceMaker {
 public:
  // By Euler's formula: each guest is a component of the graph, each node and each edge counts once.
  FaceMaker(const HalfEdges& graph, const Events& events, const EdgeSums& sums, std::vector<Guest> guests)
      : graph_(graph),
        sums_(sums),
        guests_(std::move(guests)),
        count_(std::size_t{events.size()} - graph.merged - events.nodes + 1 + guests_.size()) {}

  RegionFaces make() {
    walk_faces();
    place_guests();
    label_faces();
    return std::move(faces_);
  }

 private:
  // Walks along `start`, gives its half-edges the number of the face and returns the shoelace sum.
  DD take_walk(std::uint32_t start, std::uint32_t face) {
    RunningSum sum;
    walk_round(graph_, start, [&](std::uint32_t half) {
      faces_.of[half] = face;
      const DD edge = sums_[half / 2];
      sum.add(half % 2 == 0 ? edge : -edge);
    });
    return sum.value();
  }

  // Every walk but the outer ones has a face of its own, in the order of their lowest half-edges.
  void walk_faces() {
    faces_.of.assign(graph_.size(), unknown);
    faces_.twice_area.reserve(count_);
    start_.reserve(count_);
    faces_.twice_area.push_back({});
    start_.push_back(unknown);
    for (const Guest& guest : guests_) take_walk(guest.outer, RegionFaces::unbounded);
    for (std::uint32_t start = 0; start < graph_.size(); ++start) {
      if (faces_.of[start] != unknown || !graph_.stands(start)) continue;
      faces_.twice_area.push_back(take_walk(start, faces_.size()));
      start_.push_back(start);
    }
  }

  // The outer walk of a curve inside a face of the other one bounds that face.
  void place_guests() {
    for (Guest& guest : guests_) {
      if (guest.host != no_half_edge) guest.face = faces_.of[guest.host];
    }
    for (const Guest& guest : guests_) {
      if (guest.face != RegionFaces::unbounded) faces_.twice_area[guest.face] += take_walk(guest.outer, guest.face);
    }
  }

  // Winding numbers, from face to face across the edges between them.
  void label_faces() {
    faces_.labels.assign(faces_.size(), {{0, 0}, unknown, unknown});
    faces_.labels[RegionFaces::unbounded].rank = 0;
    Buffer<std::uint32_t> queue(faces_.size());
    queue[0] = RegionFaces::unbounded;
    std::uint32_t reached = 1;
    const auto cross_edges = [&](std::uint32_t start, Windings here) {
      walk_round(graph_, start, [&](std::uint32_t half) {
        const std::uint32_t beyond = faces_.of[half ^ 1U];
        FaceLabel& label = faces_.labels[beyond];
        if (label.rank != unknown) return;
        const Multiplicity edge = graph_.multiplicity(half / 2);
        const std::int32_t sign = half % 2 == 0 ? -1 : 1;  // from the left of the edge to its right, or back
        label = {{here.of1 + sign * edge.of1, here.of2 + sign * edge.of2}, half ^ 1U, reached};
        queue[reached++] = beyond;
      });
    };
    for (std::uint32_t k = 0; k < reached; ++k) {
      const std::uint32_t face = queue[k];
      const Windings here = faces_.labels[face].windings;
      if (face != RegionFaces::unbounded) cross_edges(start_[face], here);
      for (const Guest& guest : guests_) {
        if (guest.face == face) cross_edges(guest.outer, here);
      }
    }
  }

  const HalfEdges& graph_;
  const EdgeSums& sums_;
  std::vector<Guest> guests_;
  std::size_t count_;            // number of faces
  Buffer<std::uint32_t> start_;  // by face: the lowest half-edge of its own walk
  RegionFaces faces_;
};

}  // namespace

RegionFaces make_faces(const EdgeChains& edge_chains, const Events& events, const HalfEdges& graph,
                       const EdgeSums& sums, bool curves_meet, const IndexedCurve& c1, const IndexedCurve* c2,
                       PredicateCounts& counts) {
  return FaceMaker(graph, events, sums, guests_of(edge_chains, events, graph, curves_meet, c1, c2, counts)).make();
}

}  // namespace lober::detail

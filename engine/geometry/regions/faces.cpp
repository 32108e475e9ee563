#include "engine/geometry/regions/faces.hpp"

#include <vector>

#include "kernels/shoelace.hpp"

namespace lober::detail {
namespace {

constexpr std::uint32_t unknown = 0xffffffff;

// The closed walks that keep a face on the left, numbered in the order of their lowest half-edges.
struct Walks {
  Buffer<std::uint32_t> of;     // by half-edge
  Buffer<std::uint32_t> start;  // a half-edge of each
  Buffer<DD> twice_area;
};

Walks walk_half_edges(const HalfEdges& graph, const Buffer<DD>& sums) {
  Walks walks;
  walks.of.assign(graph.size(), unknown);
  for (std::uint32_t start = 0; start < graph.size(); ++start) {
    if (walks.of[start] != unknown || !graph.stands(start)) continue;
    const auto number = static_cast<std::uint32_t>(walks.start.size());
    RunningSum sum;
    std::uint32_t half = start;
    do {
      walks.of[half] = number;
      sum.add(half % 2 == 0 ? sums[half / 2] : -sums[half / 2]);
      half = graph.next(half);
    } while (half != start);
    walks.start.push_back(start);
    walks.twice_area.push_back(sum.value());
  }
  return walks;
}

// A component of the graph whose outer walk bounds a face of the other one, or the unbounded face.
struct Guest {
  std::uint32_t outer;  // walk
  std::uint32_t host;   // walk of the other component around it, or unknown
};

std::vector<Guest> guests_of(const EdgeChains& edge_chains, const Events& events, const HalfEdges& graph,
                             const Walks& walks, bool curves_meet, const IndexedCurve& c1, const IndexedCurve* c2,
                             PredicateCounts& counts) {
  const std::array<std::uint32_t, 2> outer{walks.of[graph.outer[0]], walks.of[graph.outer[1]]};
  const auto extreme = [&](std::size_t curve) { return point_of(edge_chains, events.list[events.extreme[curve]]); };
  if (c2 == nullptr) return {{outer[0], unknown}};
  if (curves_meet) {
    const Point p = extreme(0), q = extreme(1);
    const bool first = p.x > q.x || (p.x == q.x && p.y >= q.y);
    return {{outer[first ? 0 : 1], unknown}};
  }
  const auto walk_around = [&](std::size_t curve) {
    const int other = curve == 0 ? 1 : 0;
    const std::uint32_t half =
        half_edge_right_of(extreme(curve), edge_chains, events, graph, other == 0 ? c1 : *c2, other, counts);
    if (half == no_half_edge) return unknown;
    const std::uint32_t walk = walks.of[half];
    return walk == outer[static_cast<std::size_t>(other)] ? unknown : walk;
  };
  return {{outer[0], walk_around(0)}, {outer[1], walk_around(1)}};
}

}  // namespace

RegionFaces make_faces(const EdgeChains& edge_chains, const Events& events, const HalfEdges& graph,
                       const Buffer<DD>& sums, bool curves_meet, const IndexedCurve& c1, const IndexedCurve* c2,
                       PredicateCounts& counts) {
  Walks walks = walk_half_edges(graph, sums);
  const std::vector<Guest> guests = guests_of(edge_chains, events, graph, walks, curves_meet, c1, c2, counts);

  // Every walk but the outer ones has a face of its own.
  Buffer<std::uint32_t> face_of(walks.start.size(), unknown);
  for (const Guest& guest : guests) face_of[guest.outer] = RegionFaces::unbounded;
  RegionFaces faces;
  faces.twice_area.push_back({});
  Buffer<std::uint32_t> start{0};  // a half-edge of the face's own walk
  for (std::size_t walk = 0; walk < walks.start.size(); ++walk) {
    if (face_of[walk] == RegionFaces::unbounded) continue;
    face_of[walk] = faces.size();
    faces.twice_area.push_back(walks.twice_area[walk]);
    start.push_back(walks.start[walk]);
  }
  for (const Guest& guest : guests) {
    if (guest.host == unknown) continue;
    face_of[guest.outer] = face_of[guest.host];
    faces.twice_area[face_of[guest.host]] += walks.twice_area[guest.outer];
  }
  faces.of = std::move(walks.of);
  for (std::uint32_t& walk : faces.of) {
    if (walk != unknown) walk = face_of[walk];
  }

  faces.windings.resize(faces.size());
  faces.entry.resize(faces.size());
  faces.rank.assign(faces.size(), unknown);
  Buffer<std::uint32_t> queue{RegionFaces::unbounded};
  faces.windings[RegionFaces::unbounded] = {0, 0};
  faces.entry[RegionFaces::unbounded] = unknown;
  faces.rank[RegionFaces::unbounded] = 0;
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const std::uint32_t face = queue[k];
    const Windings here = faces.windings[face];
    const auto cross_edges = [&](std::uint32_t first) {
      std::uint32_t half = first;
      do {
        const std::uint32_t beyond = faces.of[half ^ 1U];
        if (faces.rank[beyond] == unknown) {
          const Multiplicity edge = graph.multiplicity[half / 2];
          const std::int32_t sign = half % 2 == 0 ? -1 : 1;  // from the left of the edge to its right, or back
          faces.windings[beyond] = {here.of1 + sign * edge.of1, here.of2 + sign * edge.of2};
          faces.entry[beyond] = half ^ 1U;
          faces.rank[beyond] = static_cast<std::uint32_t>(queue.size());
          queue.push_back(beyond);
        }
        half = graph.next(half);
      } while (half != first);
    };
    if (face != RegionFaces::unbounded) cross_edges(start[face]);
    for (const Guest& guest : guests) {
      if (face_of[guest.outer] == face) cross_edges(walks.start[guest.outer]);
    }
  }
  return faces;
}

}  // namespace lober::detail

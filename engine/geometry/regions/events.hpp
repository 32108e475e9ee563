// Nodes of the arrangement, and where along the curves they lie (private to regions/).
//
// An *event* is a position on a curve where something happens: another edge chain meets it there, or a spike ends, or
// it is the extreme vertex of its curve. Events that are one point of the plane make a *node*. No coordinates are
// compared to find out: each two edge chains through a point are a pair whose incidence is known and joins their
// events, and events of one edge chain are compared by their exact order along it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/geometry/regions/incidences.hpp"

namespace lober::detail {

/// Every incidence has its point within 2^-91 of the scene (crossing_parameters.hpp), so where several make one
/// event the parameter of any of them will do.
struct Event {
  enum class Kind : std::uint8_t {
    at_start,     ///< the first end of the segment
    at_vertex,    ///< inside the segment, the first end of `other`
    at_crossing,  ///< inside both the segment and `other`
  };
  DD t;
  std::uint32_t segment;
  std::uint32_t other;  ///< one of the suitable segments, the same for any order of incidences
  std::int8_t rho;      ///< at a crossing: +1 if `other` passes from right to left of the segment, else -1
  Kind kind;
};

/// An event is stored as the number of a candidate, 2 k + 0 or 1 for either segment of incidence k; those that no
/// incidence shows, ends of spikes and extreme vertices, come behind.
struct Events {
  Buffer<Incidence> incidences;
  std::array<Buffer<DD>, 2> parameters;
  std::vector<std::uint32_t> isolated;     ///< segments whose first ends are events without an incidence
  Buffer<std::uint32_t> candidate;         ///< that each event is, in order along C1, then along C2
  Buffer<std::uint32_t> node;              ///< the first event of the node of each event, by which nodes are named
  Buffer<std::uint32_t> next_at_node;      ///< another event of the same node, all round it
  std::array<std::uint32_t, 3> begin{};    ///< events of curve c (0, 1): begin[c] .. begin[c + 1]; at least one each
  std::uint32_t nodes = 0;                 ///< how many
  std::uint32_t degree2 = 0;               ///< nodes where nothing meets and no spike ends
  std::array<std::uint32_t, 2> extreme{};  ///< the event at the vertex of each curve that is greatest by x, then y
  std::uint64_t exact_orders = 0;          ///< pairs of events compared in exact arithmetic

  [[nodiscard]] Event of_candidate(std::uint32_t number) const {
    if (number >= 2 * incidences.size()) {
      const std::uint32_t segment = isolated[number - 2 * incidences.size()];
      return {{}, segment, segment, 0, Event::Kind::at_start};
    }
    const Incidence& incidence = incidences[number / 2];
    const bool first = number % 2 == 0;
    const bool starts = first ? incidence.starts1 : incidence.starts2;
    const bool other_starts = first ? incidence.starts2 : incidence.starts1;
    const std::uint32_t segment = first ? incidence.first : incidence.second;
    if (starts) return {{}, segment, segment, 0, Event::Kind::at_start};
    return {parameters[number % 2][number / 2], segment, first ? incidence.second : incidence.first,
            static_cast<std::int8_t>(first ? incidence.rho : -incidence.rho),
            other_starts ? Event::Kind::at_vertex : Event::Kind::at_crossing};
  }
  [[nodiscard]] std::uint32_t segment_of(std::uint32_t number) const {
    if (number >= 2 * incidences.size()) return isolated[number - 2 * incidences.size()];
    const Incidence& incidence = incidences[number / 2];
    return number % 2 == 0 ? incidence.first : incidence.second;
  }
  [[nodiscard]] Event operator[](std::uint32_t event) const { return of_candidate(candidate[event]); }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(candidate.size()); }
  /// The events before and after an event along its curve, cyclically.
  [[nodiscard]] std::uint32_t next(std::uint32_t event) const {
    const std::size_t curve = event < begin[1] ? 0 : 1;
    return event + 1 == begin[curve + 1] ? begin[curve] : event + 1;
  }
  [[nodiscard]] std::uint32_t previous(std::uint32_t event) const {
    const std::size_t curve = event < begin[1] ? 0 : 1;
    return event == begin[curve] ? begin[curve + 1] - 1 : event - 1;
  }
};

/// `extreme`: the segments whose first ends are the extreme vertices. O(incidences), parallel where it is long.
[[nodiscard]] Events make_events(const EdgeChains& edge_chains, Incidences incidences,
                                 std::array<std::uint32_t, 2> extreme);

/// The event as a point along its segment, for compare_along.
[[nodiscard]] ImplicitPoint implicit_point(const EdgeChains& edge_chains, const Event& event);

/// The event rounded to double: exact if it is a vertex, else right to about an ulp.
[[nodiscard]] Point point_of(const EdgeChains& edge_chains, const Event& event);

}  // namespace lober::detail

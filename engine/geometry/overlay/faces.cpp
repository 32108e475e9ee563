#include "engine/geometry/overlay/faces.hpp"

#include <array>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/shoelace.hpp"

namespace lober::detail {
namespace {

using enum HalfEdge;

constexpr std::size_t nodes_a_block = std::size_t{1} << 14;

// The turn of a walk that arrives along a half-edge, its face on the left: the half-edge it leaves by and the side
// of each curve (as the input runs) that the face lies on.
struct Turn {
  HalfEdge leave;
  bool left1, left2;
};

constexpr std::array<std::array<Turn, 4>, 6> make_turns() {
  std::array<std::array<Turn, 4>, 6> turns{};
  for (std::size_t order = 0; order < 6; ++order) {
    std::array<unsigned, 4> rank{};
    for (unsigned k = 0; k < 4; ++k) rank[index_of(rotations[order][k])] = k;
    for (unsigned arrive = 0; arrive < 4; ++arrive) {
      const unsigned sector = (rank[arrive] + 3) % 4;  // the face lies between half-edge `sector` and the next
      const auto left_of = [&](HalfEdge out, HalfEdge in) {
        const unsigned first = rank[index_of(out)];
        return (sector + 4 - first) % 4 < (rank[index_of(in)] + 4 - first) % 4;
      };
      turns[order][arrive] = {rotations[order][sector], left_of(forward1, backward1), left_of(forward2, backward2)};
    }
  }
  return turns;
}
constexpr std::array<std::array<Turn, 4>, 6> turns = make_turns();

using Arrivals = std::array<std::uint8_t, 6>;

// The half-edges along which a walk with the wanted face on its left can arrive at a node, as bits, for each rotation.
constexpr Arrivals make_arrivals(Orientations orientations, Membership wanted) {
  Arrivals bits{};
  for (std::size_t order = 0; order < 6; ++order) {
    for (unsigned arrive = 0; arrive < 4; ++arrive) {
      const Turn& turn = turns[order][arrive];
      const Membership here{turn.left1 != orientations.clockwise1, turn.left2 != orientations.clockwise2};
      if (here == wanted) bits[order] = static_cast<std::uint8_t>(bits[order] | 1U << arrive);
    }
  }
  return bits;
}

// The half-edges that a node has in a set of them. Four bits need no instruction that older processors lack.
constexpr std::array<std::uint8_t, 16> sizes{0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};

constexpr bool on_second(HalfEdge half_edge) {
  return half_edge == forward2 || half_edge == backward2;
}

// The walks round the faces of one membership at a node, for each rotation.
struct Corners {
  Arrivals arrive{}, leave{};              // half-edges, as bits
  std::array<std::int8_t, 6> times_gap{};  // what they collect there, where it is a point: a multiple of its gap
};
constexpr Corners make_corners(Orientations orientations, Membership wanted) {
  Corners corners{.arrive = make_arrivals(orientations, wanted)};
  for (std::size_t order = 0; order < 6; ++order) {
    for (unsigned bits = corners.arrive[order]; bits != 0; bits &= bits - 1) {
      const HalfEdge arrive = first_of(bits), leave = turns[order][index_of(arrive)].leave;
      corners.leave[order] = static_cast<std::uint8_t>(corners.leave[order] | bit_of(leave));
      corners.times_gap[order] =
          static_cast<std::int8_t>(corners.times_gap[order] + on_second(leave) - on_second(arrive));
    }
  }
  return corners;
}

constexpr std::size_t number_of(bool first, bool second) {
  return 2 * static_cast<std::size_t>(first) + static_cast<std::size_t>(second);
}
constexpr std::array<std::array<Corners, 4>, 4> make_all_corners() {
  std::array<std::array<Corners, 4>, 4> all{};
  for (const bool clockwise1 : {false, true}) {
    for (const bool clockwise2 : {false, true}) {
      for (const bool inside1 : {false, true}) {
        for (const bool inside2 : {false, true}) {
          all[number_of(clockwise1, clockwise2)][number_of(inside1, inside2)] =
              make_corners({clockwise1, clockwise2}, {inside1, inside2});
        }
      }
    }
  }
  return all;
}
// They are few, and small curves have few nodes.
constexpr std::array<std::array<Corners, 4>, 4> all_corners = make_all_corners();

const Corners& corners_of(Orientations orientations, Membership wanted) {
  return all_corners[number_of(orientations.clockwise1, orientations.clockwise2)]
                    [number_of(wanted.inside1, wanted.inside2)];
}
const Arrivals& arrivals(Orientations orientations, Membership wanted) {
  return corners_of(orientations, wanted).arrive;
}

// The end of a shared arc at which a half-edge is.
bool at_last(HalfEdge half_edge, int direction) {
  switch (half_edge) {
    case backward1:
      return false;
    case forward1:
      return true;
    case backward2:
      return direction < 0;
    case forward2:
      return direction > 0;
  }
  return false;
}

// The sum that a walk collects at a node: S1 - S2 where it comes along C1 and goes on along C2, S2 - S1 the other way
// round (ends of a shared arc apart, its first vertex included).
DD at_node(const NodeGraph& graph, const ArcSums& sums, std::uint32_t node, HalfEdge arrive, HalfEdge leave) {
  const bool came2 = on_second(arrive), goes2 = on_second(leave);
  const NodeSpan span = graph.span(node);
  if (span.direction == 0) return came2 == goes2 ? DD{} : goes2 ? sums.gap[span.first] : -sums.gap[span.first];
  const bool from = at_last(arrive, span.direction), to = at_last(leave, span.direction);
  DD sum;
  if (goes2) sum += sums.gap[to ? span.last : span.first];
  if (came2) sum -= sums.gap[from ? span.last : span.first];
  if (node == sums.wraps_inside && from != to) sum += to ? sums.total1 : -sums.total1;
  return sum;
}

// The product, which is exact.
DD times(int factor, DD sum) {
  if (factor == 1) return sum;
  if (factor == 0) return {};
  return factor == -1 ? -sum : DD{static_cast<double>(factor), 0} * sum;
}

// How often a set of walks passes the first vertex of each curve, forward less back.
struct Turns {
  int round1 = 0, round2 = 0;
  [[nodiscard]] DD sum(const ArcSums& sums) const { return times(round1, sums.total1) + times(round2, sums.total2); }
};

}  // namespace

void fail_not_simple() {
  throw DataError("the curves cannot be overlaid: at least one of them crosses or touches itself");
}

int sectors_at(std::uint8_t rotation, Orientations orientations, Membership wanted) {
  return sizes[arrivals(orientations, wanted)[rotation]];
}

namespace {

// Walks all faces that have an arrival in `open`; those that begin with an arrival in `second` are the second kind.
void walk_all(const NodeGraph& graph, const ArcSums& sums, std::uint8_t* open, const Arrivals& second,
              std::array<Faces, 2>& faces) {
  const std::uint32_t count = graph.size();
  const std::uint32_t *along2 = graph.along2().data(), *rank2 = graph.rank2.data();
  const std::uint8_t* order = graph.order.data();
  std::array<std::uint32_t*, 2> next_step{faces[0].steps.data(), faces[1].steps.data()};
  const std::array<const std::uint32_t*, 2> end_step{next_step[0] + faces[0].steps.size(),
                                                     next_step[1] + faces[1].steps.size()};
  for (std::uint32_t start = 0; start < count; ++start) {
    while (open[start] != 0) {
      std::uint32_t node = start;
      HalfEdge arrive = first_of(open[start]);
      const std::size_t kind = second[order[start]] >> index_of(arrive) & 1U;
      std::uint32_t* step = next_step[kind];
      RunningSum twice_area;
      Turns rounds;
      do {
        open[node] = static_cast<std::uint8_t>(open[node] & ~bit_of(arrive));
        const HalfEdge leave = turns[order[node]][index_of(arrive)].leave;
        twice_area.add(at_node(graph, sums, node, arrive, leave));
        if (step == end_step[kind]) fail_not_simple();
        *step++ = pack({node, on_second(leave)});
        switch (leave) {
          case forward1:
            rounds.round1 += node == sums.wraps1;
            node = node + 1 == count ? 0 : node + 1;
            arrive = backward1;
            break;
          case backward1:
            node = node == 0 ? count - 1 : node - 1;
            rounds.round1 -= node == sums.wraps1;
            arrive = forward1;
            break;
          case forward2: {
            const std::uint32_t rank = rank2[node];
            rounds.round2 += rank == sums.wraps2;
            node = along2[rank + 1 == count ? 0 : rank + 1];
            arrive = backward2;
            break;
          }
          case backward2: {
            const std::uint32_t rank = rank2[node] == 0 ? count - 1 : rank2[node] - 1;
            rounds.round2 -= rank == sums.wraps2;
            node = along2[rank];
            arrive = forward2;
            break;
          }
        }
      } while ((open[node] & bit_of(arrive)) != 0);
      if (rounds.round1 != 0 || rounds.round2 != 0) twice_area.add(rounds.sum(sums));
      const DD sum = twice_area.value();
      faces[kind].area.push_back(0.5 * (sum.hi + sum.lo));
      faces[kind].begin.push_back(static_cast<std::uint32_t>(step - faces[kind].steps.data()));
      next_step[kind] = step;
    }
  }
}

// One step round a cycle of the numbers below a count, onwards or back.
struct Stride {
  Stride(bool forward, std::uint32_t count)
      : by(forward ? 1 : 0xffffffff), end(forward ? count : 0xffffffff), begin(forward ? 0 : count - 1) {}
  // Adds to `rounds` where it passes from the last number to the first one, or back.
  LOBER_INLINE std::uint32_t next(std::uint32_t number, int& rounds) const {
    const std::uint32_t beyond = number + by;
    if (beyond != end) return beyond;
    rounds += static_cast<int>(by);
    return begin;
  }
  [[nodiscard]] bool forward() const { return by == 1; }
  std::uint32_t by, end, begin;
};

// The faces of one membership where all nodes are proper crossings, of either order by turns along each curve, as those
// of simple curves are. Then walks have no choice: a face is made of arcs of C1, each from a node to its neighbour,
// with an arc of C2 from one to the next. Nothing has to be looked up but the gaps and where the arcs of C2 lead.
class CrossingWalk {
 public:
  CrossingWalk(const NodeGraph& graph, const ArcSums& sums, const Corners& corners, Faces& faces)
      : CrossingWalk(graph, sums, corners, faces,
                     on_second(first_of(corners.leave[rightward_to_left])) ? leftward_to_right : rightward_to_left) {}

  // Arcs join node k and the next one: those that bound the faces of this membership have even k, or odd k.
  [[nodiscard]] bool arcs_are_even() const { return arcs_are_even_; }
  // The face at node 0, where that is the upper end of an arc: of the last one, past the first vertex. Returns false
  // where the nodes do not alternate along C2.
  bool walk_from_first() { return along1_.forward() ? walk<false>(0, count_ - 1) : walk<true>(0, 0); }
  // The face whose first node is the lower end of an arc, if no walk has passed it yet. To be called in order.
  LOBER_INLINE bool walk_from(std::uint32_t lower) {
    if (done_[lower / 2] != 0) return true;
    return along1_.forward() ? walk<true>(lower, lower) : walk<false>(lower, lower + 1);
  }

  // To be called in the end.
  void finish() {
    const auto count = static_cast<std::size_t>(area_ - faces_.area.data());
    faces_.area.resize(count);
    faces_.begin.resize(count + 1);
  }

 private:
  CrossingWalk(const NodeGraph& graph, const ArcSums& sums, const Corners& corners, Faces& faces,
               RotationSystem changes_to1)
      : sums_(sums),
        order2_(graph.along2().data()),
        rank2_(graph.rank2.data()),
        count_(graph.size()),
        along1_(first_of(corners.leave[changes_to1]) == forward1, count_),
        along2_(first_of(corners.leave[1 - changes_to1]) == forward2, count_),
        arcs_are_even_((graph.order[0] == changes_to1) == along1_.forward()),
        done_(count_ / 2),
        faces_(faces) {
    std::fill(done_.begin(), done_.end(), std::uint8_t{0});
    faces_.steps.resize(count_);  // each membership has one sector at each crossing
    faces_.area.resize(count_ / 2);
    faces_.begin.resize(count_ / 2 + 1);
    faces_.begin[0] = 0;
    step_ = faces_.steps.data();
    area_ = faces_.area.data();
    begin_ = faces_.begin.data() + 1;
  }

  // Walks from node `start`, where an arc of C1 begins or else ends. `last` is where the arc begins that closes the
  // walk.
  template <bool arc_begins>
  LOBER_INLINE bool walk(std::uint32_t start, std::uint32_t last) {
    const Stride along1 = along1_, along2 = along2_;
    const DD* const gap = sums_.gap.data();
    const std::uint32_t *const order2 = order2_, *const rank2 = rank2_;
    std::uint8_t* const done = done_.data();
    std::uint32_t* step = step_;
    RunningSum twice_area;
    Turns rounds;
    // From the node where the walk changes to C1 to the other end of the arc.
    const auto along_arc = [&](std::uint32_t from) {
      *step++ = pack({from, 0});
      twice_area.add(-gap[from]);
      const std::uint32_t to = along1.next(from, rounds.round1);
      done[(along1.forward() ? from : to) / 2] = 1;
      return to;
    };
    // From there along C2 to the next arc.
    const auto to_next_arc = [&](std::uint32_t from) {
      *step++ = pack({from, 1});
      twice_area.add(gap[from]);
      return order2[along2.next(rank2[from], rounds.round2)];
    };
    std::uint32_t at = start;
    if constexpr (arc_begins) {
      do {
        at = to_next_arc(along_arc(at));
        if (((at ^ start) & 1U) != 0) return false;
      } while (at != start);
    } else {
      for (at = to_next_arc(start); at != last; at = to_next_arc(along_arc(at))) {
        if (((at ^ last) & 1U) != 0) return false;
      }
      along_arc(last);
    }
    if ((rounds.round1 | rounds.round2) != 0) twice_area.add(rounds.sum(sums_));
    const DD sum = twice_area.value();
    *area_++ = 0.5 * (sum.hi + sum.lo);
    *begin_++ = static_cast<std::uint32_t>(step - faces_.steps.data());
    step_ = step;
    return true;
  }

  const ArcSums& sums_;
  const std::uint32_t *order2_, *rank2_;
  std::uint32_t count_;
  Stride along1_, along2_;
  bool arcs_are_even_;
  Buffer<std::uint8_t> done_;  // the arcs, in order along C1, that a walk has passed
  Faces& faces_;
  std::uint32_t *step_, *begin_;
  double* area_;
};

// Walks the faces of two memberships so, if that is possible.
bool walk_crossings(const NodeGraph& graph, const ArcSums& sums, const Corners& first, const Corners& second,
                    std::array<Faces, 2>& faces) {
  const std::uint32_t count = graph.size();
  if (!graph.spans.empty() || count % 2 != 0) return false;
  const std::uint8_t* order = graph.order.data();
  unsigned alternate = 1;
  for (std::uint32_t node = 1; node < count; ++node) alternate &= static_cast<unsigned>(order[node] ^ order[node - 1]);
  if (alternate == 0) return false;
  CrossingWalk walk1(graph, sums, first, faces[0]), walk2(graph, sums, second, faces[1]);
  const bool swapped = !walk1.arcs_are_even();
  CrossingWalk &even = swapped ? walk2 : walk1, &odd = swapped ? walk1 : walk2;
  if (!even.arcs_are_even() || odd.arcs_are_even() || !odd.walk_from_first()) return false;
  for (std::uint32_t node = 0; node < count; node += 2) {
    if (!even.walk_from(node) || !odd.walk_from(node + 1)) return false;
  }
  walk1.finish();
  walk2.finish();
  return true;
}

}  // namespace

std::array<Faces, 2> walk_faces(const NodeGraph& graph, const ArcSums& sums, Orientations orientations,
                                const std::array<Membership, 2>& wanted) {
  std::array<Faces, 2> faces;
  if (walk_crossings(graph, sums, corners_of(orientations, wanted[0]), corners_of(orientations, wanted[1]), faces)) {
    return faces;
  }
  const std::uint32_t count = graph.size();
  const std::array arrive{arrivals(orientations, wanted[0]), arrivals(orientations, wanted[1])};
  Arrivals arrive_either{};
  for (std::size_t order = 0; order < 6; ++order)
    arrive_either[order] = static_cast<std::uint8_t>(arrive[0][order] | arrive[1][order]);

  Buffer<std::uint8_t> open(count);  // arrivals that no walk has used yet
  std::array<std::size_t, 6> nodes_of_order{};
  for (std::uint32_t node = 0; node < count; ++node) {
    open[node] = arrive_either[graph.order[node]];
    ++nodes_of_order[graph.order[node]];
  }
  for (std::size_t kind = 0; kind < 2; ++kind) {
    std::size_t corners = 0;
    for (std::size_t order = 0; order < 6; ++order) {
      corners += nodes_of_order[order] * sizes[arrive[kind][order]];
    }
    faces[kind].steps.resize(corners);
    faces[kind].area.clear();
    faces[kind].area.reserve(corners / 2 + 1);
    faces[kind].begin.reserve(corners / 2 + 2);
    faces[kind].begin = {0};
  }
  walk_all(graph, sums, open.data(), arrive[1], faces);
  return faces;
}

namespace {

// Several sums over the nodes at once: of_block(begin, end) adds them up over a block, and blocks are joined in order.
template <std::size_t sums, typename SumsOfBlock>
std::array<DD, sums> sums_over_nodes(std::size_t count, const SumsOfBlock& of_block) {
  const auto sums_of = [&](std::size_t begin, std::size_t end) {
    const std::array<RunningSum, sums> block =
        of_block(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
    std::array<DD, sums> values;
    for (std::size_t k = 0; k < sums; ++k) values[k] = block[k].value();
    return values;
  };
  if (count <= nodes_a_block) return sums_of(0, count);
  std::vector<std::array<DD, sums>> partial((count + nodes_a_block - 1) / nodes_a_block);
  for_each_block(count, nodes_a_block,
                 [&](std::size_t begin, std::size_t end) { partial[begin / nodes_a_block] = sums_of(begin, end); });
  std::array<DD, sums> total{};
  for (const std::array<DD, sums>& part : partial) {
    for (std::size_t k = 0; k < sums; ++k) total[k] += part[k];
  }
  return total;
}

// Where all nodes are points, what the walks of a membership collect at one depends on its rotation only. Sums of the
// gaps over the nodes of either order of a proper crossing: curves that meet in points that need no span have no
// others.
std::array<DD, 2> gaps_by_order(const NodeGraph& graph, const ArcSums& sums) {
  return sums_over_nodes<2>(graph.size(), [&](std::uint32_t begin, std::uint32_t end) {
    RunningSum to_left, to_right;
    for (std::uint32_t node = begin; node < end; ++node) {
      (graph.order[node] == rightward_to_left ? to_left : to_right).add(sums.gap[node]);
    }
    return std::array{to_left, to_right};
  });
}

using ThreeCorners = std::array<const Corners*, 3>;  ///< those of three memberships

// The same with shared arcs, node by node, for each membership.
std::array<DD, 3> collected_at_nodes(const NodeGraph& graph, const ArcSums& sums, const ThreeCorners& corners) {
  return sums_over_nodes<3>(graph.size(), [&](std::uint32_t begin, std::uint32_t end) {
    std::array<RunningSum, 3> sum;
    for (std::uint32_t node = begin; node < end; ++node) {
      const std::uint8_t order = graph.order[node];
      for (std::size_t m = 0; m < 3; ++m) {
        for (unsigned bits = corners[m]->arrive[order]; bits != 0; bits &= bits - 1) {
          const HalfEdge arrive = first_of(bits);
          sum[m].add(at_node(graph, sums, node, arrive, turns[order][index_of(arrive)].leave));
        }
      }
    }
    return sum;
  });
}

}  // namespace

FaceTotals total_of_faces(const NodeGraph& graph, const ArcSums& sums, Orientations orientations) {
  constexpr std::array<Membership, 3> memberships{{{true, false}, {false, true}, {true, true}}};
  const std::uint32_t count = graph.size();
  ThreeCorners corners;
  for (std::size_t m = 0; m < 3; ++m) corners[m] = &corners_of(orientations, memberships[m]);
  std::array<DD, 3> total{};
  if (graph.spans.empty()) {
    const std::array<DD, 2> gaps = gaps_by_order(graph, sums);
    for (std::size_t m = 0; m < 3; ++m) {
      for (const std::uint8_t order : {rightward_to_left, leftward_to_right})
        total[m] += times(corners[m]->times_gap[order], gaps[order]);
    }
  } else {
    total = collected_at_nodes(graph, sums, corners);
  }
  for (std::size_t m = 0; m < 3; ++m) {
    // Whole turns: a walk goes along the way past the first vertex if it leaves the node before by that way, and back
    // if it leaves the node after.
    const auto leaving = [&](std::uint32_t node, HalfEdge by) {
      return static_cast<int>(corners[m]->leave[graph.order[node]] >> index_of(by) & 1U);
    };
    const auto next = [&](std::uint32_t rank) { return rank + 1 == count ? 0 : rank + 1; };
    Turns rounds;
    if (sums.wraps1 != ArcSums::nowhere) {
      rounds.round1 = leaving(sums.wraps1, forward1) - leaving(next(sums.wraps1), backward1);
    }
    if (sums.wraps2 != ArcSums::nowhere) {
      rounds.round2 =
          leaving(graph.along2()[sums.wraps2], forward2) - leaving(graph.along2()[next(sums.wraps2)], backward2);
    }
    total[m] += rounds.sum(sums);
  }
  return {total[0], total[1], total[2]};
}

}  // namespace lober::detail

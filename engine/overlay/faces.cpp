#include "engine/overlay/faces.hpp"

#include <array>
#include <bit>

#include "engine/parallel/parallel.hpp"
#include "kernels/shoelace.hpp"

namespace lober {
namespace {

constexpr std::size_t grain = std::size_t{1} << 14;

// What happens to a walk that arrives along an arm, its face on the left: the arm it leaves by and the side of each
// curve (as the input runs) that the face lies on.
struct Turn {
  Arm leave;
  bool left1, left2;
};

constexpr std::array<std::array<Turn, 4>, 6> make_turns() {
  std::array<std::array<Turn, 4>, 6> turns{};
  for (std::size_t order = 0; order < 6; ++order) {
    std::array<unsigned, 4> place{};
    for (unsigned k = 0; k < 4; ++k) place[arm_orders[order][k]] = k;
    for (unsigned arrive = 0; arrive < 4; ++arrive) {
      const unsigned sector = (place[arrive] + 3) % 4;  // the face lies between arm `sector` and the next
      const auto left_of = [&](Arm out, Arm in) {
        return (sector + 4 - place[out]) % 4 < (place[in] + 4 - place[out]) % 4;
      };
      turns[order][arrive] = {arm_orders[order][sector], left_of(out1, in1), left_of(out2, in2)};
    }
  }
  return turns;
}
constexpr std::array<std::array<Turn, 4>, 6> turns = make_turns();

// The arms along which a walk with the wanted face on its left can arrive at a node, as bits, for each arm order.
std::array<std::uint8_t, 6> arrivals(Handedness hands, Membership wanted) {
  std::array<std::uint8_t, 6> bits{};
  for (std::size_t order = 0; order < 6; ++order) {
    for (unsigned arrive = 0; arrive < 4; ++arrive) {
      const Turn& turn = turns[order][arrive];
      const Membership here{turn.left1 != hands.clockwise1, turn.left2 != hands.clockwise2};
      if (here == wanted) bits[order] = static_cast<std::uint8_t>(bits[order] | 1U << arrive);
    }
  }
  return bits;
}

// At which end of a shared arc an arm is.
bool at_last(Arm arm, int direction) {
  switch (arm) {
    case in1:
      return false;
    case out1:
      return true;
    case in2:
      return direction < 0;
    case out2:
      return direction > 0;
  }
  return false;
}

// The part of the boundary that runs along the shared arc of the node, if any.
DD along_shared(const NodeGraph& graph, const ArcSums& sums, std::uint32_t node, Arm arrive, Arm leave) {
  const int direction = graph.spans[node].direction;
  if (direction == 0) return {};
  const bool from = at_last(arrive, direction), to = at_last(leave, direction);
  if (from == to) return {};
  return to ? sums.via[node] : -sums.via[node];
}

}  // namespace

int sectors_at(std::uint8_t arm_order, Handedness hands, Membership wanted) {
  return std::popcount(arrivals(hands, wanted)[arm_order]);
}

Faces walk_faces(const NodeGraph& graph, const ArcSums& sums, Handedness hands, Membership wanted) {
  const std::uint32_t count = graph.size();
  const std::array<std::uint8_t, 6> wanted_arrivals = arrivals(hands, wanted);
  const Buffer<std::uint32_t>& along2 = graph.along2();
  Buffer<std::uint8_t> open(count);  // arrivals that no walk has used yet
  std::array<std::size_t, 6> nodes_of_order{};
  for (std::uint32_t node = 0; node < count; ++node) {
    open[node] = wanted_arrivals[graph.order[node]];
    ++nodes_of_order[graph.order[node]];
  }
  std::size_t corners = 0;
  for (std::size_t order = 0; order < 6; ++order) {
    corners += nodes_of_order[order] * static_cast<std::size_t>(std::popcount(wanted_arrivals[order]));
  }
  Faces faces;
  faces.steps.resize(corners);
  faces.area.reserve(corners / 2 + 1);
  faces.begin.reserve(corners / 2 + 2);
  faces.begin.push_back(0);
  std::uint32_t step = 0;
  const bool arcs_shared = !graph.spans.empty();
  for (std::uint32_t start = 0; start < count; ++start) {
    while (open[start] != 0) {
      std::uint32_t node = start;
      auto arrive = static_cast<Arm>(__builtin_ctz(open[start]));
      RunningSum twice_area;
      do {
        open[node] = static_cast<std::uint8_t>(open[node] & ~(1U << arrive));
        const Arm leave = turns[graph.order[node]][arrive].leave;
        if (arcs_shared) twice_area.add(along_shared(graph, sums, node, arrive, leave));
        faces.steps[step++] = pack({node, leave == out2 || leave == in2});
        switch (leave) {
          case out1:
            twice_area.add(sums.arc1[node]);
            node = node + 1 == count ? 0 : node + 1;
            arrive = in1;
            break;
          case in1:
            node = node == 0 ? count - 1 : node - 1;
            twice_area.add(-sums.arc1[node]);
            arrive = out1;
            break;
          case out2: {
            const std::uint32_t rank = graph.rank2[node];
            twice_area.add(sums.arc2[rank]);
            node = along2[rank + 1 == count ? 0 : rank + 1];
            arrive = in2;
            break;
          }
          case in2: {
            const std::uint32_t rank = graph.rank2[node] == 0 ? count - 1 : graph.rank2[node] - 1;
            twice_area.add(-sums.arc2[rank]);
            node = along2[rank];
            arrive = out2;
            break;
          }
        }
      } while ((open[node] & 1U << arrive) != 0);
      const DD sum = twice_area.value();
      faces.area.push_back(0.5 * (sum.hi + sum.lo));
      faces.begin.push_back(step);
    }
  }
  return faces;
}

FaceTotals total_of_faces(const NodeGraph& graph, const ArcSums& sums, Handedness hands) {
  constexpr std::array<Membership, 3> memberships{{{true, false}, {false, true}, {true, true}}};
  std::array<std::array<std::uint8_t, 6>, 3> wanted{};
  for (std::size_t m = 0; m < 3; ++m) wanted[m] = arrivals(hands, memberships[m]);
  const std::uint32_t count = graph.size();
  std::vector<std::array<DD, 3>> partial((count + grain - 1) / grain);
  for_each_block(count, grain, [&](std::size_t begin, std::size_t end) {
    std::array<RunningSum, 3> sum;
    for (auto node = static_cast<std::uint32_t>(begin); node < end; ++node) {
      const std::uint8_t order = graph.order[node];
      const std::uint32_t rank = graph.rank2[node];
      const DD onwards1 = sums.arc1[node], back1 = -sums.arc1[node == 0 ? count - 1 : node - 1];
      const DD onwards2 = sums.arc2[rank], back2 = -sums.arc2[rank == 0 ? count - 1 : rank - 1];
      const std::array<DD, 4> along{onwards1, onwards2, back1, back2};  // indexed by Arm
      for (std::size_t m = 0; m < 3; ++m) {
        for (unsigned bits = wanted[m][order]; bits != 0; bits &= bits - 1) {
          const auto arrive = static_cast<Arm>(__builtin_ctz(bits));
          const Arm leave = turns[order][arrive].leave;
          if (!graph.spans.empty()) sum[m].add(along_shared(graph, sums, node, arrive, leave));
          sum[m].add(along[leave]);
        }
      }
    }
    for (std::size_t m = 0; m < 3; ++m) partial[begin / grain][m] = sum[m].value();
  });
  std::array<DD, 3> total{};
  for (const auto& part : partial) {
    for (std::size_t m = 0; m < 3; ++m) total[m] += part[m];
  }
  return {total[0], total[1], total[2]};
}

}  // namespace lober

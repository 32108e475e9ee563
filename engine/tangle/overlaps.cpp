// What lobes have in common, from the crossings alone.
//
// Let lobes i < j have orientations o_i, o_j, +1 if the lobe is on the left of its arcs. The boundary of their common
// part consists of parts of U_i, S_i inside lobe j and of U_j, S_j inside lobe i. They begin and end at crossings x of
// U_i with S_j or of U_j with S_i (U does not cross U, nor S cross S), where U passes from the left of S to its right
// if rho(x) = 1. So U_i leaves lobe j there if rho o_j = 1, and S_j leaves lobe i if -rho o_i = 1; with the sums along
// both curves up to x the two contribute o_i o_j rho (S_U - S_S). The arcs end at pips too: q_i and q_i+1 lie in lobe j
// if and only if p- does, because U[p-, q_i+1] does not meet lobe j; then all of lobe i is added. Likewise lobe j if p+
// lies in lobe i.

#include <algorithm>

#include "engine/parallel/parallel.hpp"
#include "engine/tangle/gaps.hpp"
#include "engine/tangle/lobe_topology.hpp"

namespace lober {
namespace {

struct Term {
  std::uint32_t i, j;
  std::uint32_t node;
};

DD twice_area(const Tangle& tangle, std::size_t lobe) {
  const DD twice = tangle.pips[lobe + 1].gap - tangle.pips[lobe].gap;
  return tangle.lobes[lobe].orientation() > 0 ? twice : -twice;
}

}  // namespace

std::vector<LobeOverlap> overlaps(const Tangle& tangle) {
  const auto lobes = static_cast<std::uint32_t>(tangle.lobes.size());
  const std::vector<ArcsAt> arcs = arcs_at_nodes(tangle);
  std::vector<std::uint32_t> nodes;
  std::vector<Term> terms;
  for (std::uint32_t node = 0; node < arcs.size(); ++node) {
    const ArcsAt at = arcs[node];  // at.s < at.u, but for pips
    if (at.s < 0 || at.generation() <= 0 || at.u >= static_cast<std::int32_t>(lobes)) continue;
    if (tangle.nodes.rho(node) == 0) continue;
    terms.push_back(
        {static_cast<std::uint32_t>(at.s), static_cast<std::uint32_t>(at.u), static_cast<std::uint32_t>(nodes.size())});
    nodes.push_back(node);
  }
  const Buffer<DD> gaps = gaps_at(*tangle.curves, tangle.nodes.graph(), nodes);
  std::stable_sort(terms.begin(), terms.end(),
                   [](const Term& x, const Term& y) { return x.i != y.i ? x.i < y.i : x.j < y.j; });

  struct Sum {
    std::uint32_t i, j;
    DD twice;
  };
  std::vector<Sum> sums;
  for (std::size_t k = 0; k < terms.size();) {
    Sum sum{terms[k].i, terms[k].j, {}};
    for (; k < terms.size() && terms[k].i == sum.i && terms[k].j == sum.j; ++k) {
      const DD gap = gaps[terms[k].node];
      sum.twice = tangle.nodes.rho(nodes[terms[k].node]) > 0 ? sum.twice + gap : sum.twice - gap;
    }
    if (tangle.lobes[sum.i].orientation() != tangle.lobes[sum.j].orientation()) sum.twice = -sum.twice;
    sums.push_back(sum);
  }
  // Lobes that hold a fixed point hold whole lobes; there are hardly ever any.
  for (std::uint32_t m = 0; m < lobes; ++m) {
    if (holds_start_of_u(tangle, m)) {
      for (std::uint32_t i = 0; i < m; ++i) sums.push_back({i, m, twice_area(tangle, i)});
    }
    if (holds_start_of_s(tangle, m)) {
      for (std::uint32_t j = m + 1; j < lobes; ++j) sums.push_back({m, j, twice_area(tangle, j)});
    }
  }
  std::stable_sort(sums.begin(), sums.end(),
                   [](const Sum& x, const Sum& y) { return x.i != y.i ? x.i < y.i : x.j < y.j; });
  std::vector<LobeOverlap> result;
  for (std::size_t k = 0; k < sums.size();) {
    DD twice{};
    const std::size_t first = k;
    for (; k < sums.size() && sums[k].i == sums[first].i && sums[k].j == sums[first].j; ++k) twice += sums[k].twice;
    result.push_back({sums[first].i, sums[first].j, std::max(0.0, tangle.curves->area(twice))});
  }
  return result;
}

}  // namespace lober

// The common areas of lobes, from the crossings alone.
//
// Let lobes i < j have orientations o_i, o_j, +1 if the lobe is on the left of its arcs. The boundary of their common
// part consists of parts of U_i, S_i inside lobe j and of U_j, S_j inside lobe i. They begin and end at crossings x of
// U_i with S_j or of U_j with S_i (U does not cross U, nor S cross S), where U passes from the left of S to its right
// if rho(x) = 1. So U_i leaves lobe j there if rho o_j = 1, and S_j leaves lobe i if -rho o_i = 1; with the sums along
// both curves up to x the two contribute o_i o_j rho (S_U - S_S). The arcs end at pips too: q_i and q_i+1 lie in lobe j
// if and only if p- does, because U[p-, q_i+1] does not meet lobe j; then all of lobe i is added. Likewise lobe j if p+
// lies in lobe i.
//
// The boundary's length, and the errors of its arcs, are sums of the same kind without the orientations: what has run
// up along U where it leaves a lobe less what had where it came in, and the same along S.

#include <algorithm>
#include <cmath>

#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/tangle/bounded_overlap.hpp"
#include "engine/geometry/tangle/lobe_topology.hpp"
#include "engine/geometry/tangle/running_sums.hpp"

namespace lober {
using namespace detail;
namespace {

// A crossing of U_j with S_i.
struct Term {
  std::uint32_t i, j;
  std::uint32_t node;
};
struct Sum {
  std::uint32_t i, j;
  DD twice{};
  double error = 0, length = 0;
  int rho = 0;
};

DD twice_area(const Tangle& tangle, std::size_t lobe) {
  const DD twice = gap_of(tangle.pips[lobe + 1]) - gap_of(tangle.pips[lobe]);
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
  const std::vector<SumsToNode> along = sums_to_nodes(*tangle.curves, tangle.nodes, nodes);
  std::stable_sort(terms.begin(), terms.end(),
                   [](const Term& x, const Term& y) { return x.i != y.i ? x.i < y.i : x.j < y.j; });

  std::vector<Sum> sums;
  for (std::size_t k = 0; k < terms.size();) {
    Sum sum{terms[k].i, terms[k].j};
    const int o_i = tangle.lobes[sum.i].orientation(), o_j = tangle.lobes[sum.j].orientation();
    for (; k < terms.size() && terms[k].i == sum.i && terms[k].j == sum.j; ++k) {
      const SumsToNode& here = along[terms[k].node];
      const int rho = tangle.nodes.rho(nodes[terms[k].node]);
      sum.rho += rho;
      sum.twice = rho > 0 ? sum.twice + here.gap : sum.twice - here.gap;
      // The crossing is one of U_j with S_i: U leaves lobe i if rho o_i = 1, S leaves lobe j if -rho o_j = 1.
      sum.error += rho * (o_i * here.error_u - o_j * here.error_s) + here.uncertainty;
      sum.length += rho * (o_i * here.length_u - o_j * here.length_s);
    }
    if (o_i != o_j) sum.twice = -sum.twice;
    sums.push_back(sum);
  }
  // Lobes that hold a fixed point hold whole lobes; there are hardly ever any.
  const std::size_t of_crossings = sums.size();
  for (std::uint32_t m = 0; m < lobes; ++m) {
    const auto add = [&](std::uint32_t i, std::uint32_t j, std::uint32_t whole) {
      sums.push_back({i, j, twice_area(tangle, whole), 2 * tangle.lobes[whole].smooth_error,
                      perimeter(lobe_outline(tangle, whole))});
    };
    if (holds_start_of_u(tangle, m)) {
      for (std::uint32_t i = 0; i < m; ++i) add(i, m, i);
    }
    if (holds_start_of_s(tangle, m)) {
      for (std::uint32_t j = m + 1; j < lobes; ++j) add(m, j, j);
    }
  }
  const bool fixed_points_held = sums.size() > of_crossings;
  std::stable_sort(sums.begin(), sums.end(),
                   [](const Sum& x, const Sum& y) { return x.i != y.i ? x.i < y.i : x.j < y.j; });
  std::vector<LobeOverlap> result;
  for (std::size_t k = 0; k < sums.size();) {
    Sum total{sums[k].i, sums[k].j};
    for (; k < sums.size() && sums[k].i == total.i && sums[k].j == total.j; ++k) {
      total.twice += sums[k].twice;
      total.error += sums[k].error;
      total.length += sums[k].length;
      total.rho += sums[k].rho;
    }
    const double area = tangle.curves->area(total.twice);
    // Infinite where a whole lobe is added whose area is not known.
    const double of_arcs = std::isinf(total.error) ? total.error : tangle.curves->area({std::max(0.0, total.error), 0});
    const double error = of_arcs + tangle.rounding(area);
    const LobeOverlap found{total.i, total.j, 0, error, std::max(0.0, total.length)};
    result.push_back(bounded(tangle, found, area, fixed_points_held || total.rho == 0));
  }
  return result;
}

}  // namespace lober

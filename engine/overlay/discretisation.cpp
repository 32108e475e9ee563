// What polygons lose against smooth curves, arc by arc, for every area.

#include <algorithm>
#include <cmath>

#include "engine/overlay/arc_sums.hpp"
#include "engine/overlay/faces.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/sagitta.hpp"
#include "kernels/shoelace.hpp"

namespace lober {
namespace {

constexpr std::size_t grain = 4096;

double bulge(const CurveView& curve, std::size_t number) {
  const std::size_t size = curve.points.size();
  const auto at = [&](std::size_t k) { return curve.points[k >= size ? k - size : k]; };
  return twice_sagitta_area(at(number + size - 1), at(number), at(number + 1), at(number + 2));
}

// Running sums of the bulges of one curve at its contacts, like the shoelace sums in arc_sums.cpp.
template <typename ContactAt, typename Take>
DD bulges_at_contacts(const CurveView& curve, std::size_t count, const ContactAt& contact, const Take& take) {
  const std::size_t segments = curve.segments(), blocks = (segments + grain - 1) / grain;
  std::vector<DD> before(blocks + 1);
  for_each_block(segments, grain, [&](std::size_t begin, std::size_t end) {
    RunningSum sum;
    for (std::size_t k = begin; k < end; ++k) sum.add({bulge(curve, k), 0});
    before[begin / grain + 1] = sum.value();
  });
  for (std::size_t k = 0; k < blocks; ++k) before[k + 1] += before[k];

  std::vector<std::size_t> first(blocks + 1, count);
  for (std::size_t k = count; k-- > 0;) first[contact(k).segment / grain] = k;
  for (std::size_t k = blocks; k-- > 0;) first[k] = std::min(first[k], first[k + 1]);
  for_each_block(blocks, 1, [&](std::size_t block, std::size_t) {
    if (first[block] == first[block + 1]) return;
    RunningSum sum;
    sum.add(before[block]);
    std::size_t k = first[block];
    for (std::size_t number = block * grain; k < first[block + 1]; ++number) {
      const double here = bulge(curve, number);
      for (; k < first[block + 1] && contact(k).segment == number; ++k) {
        take(k, sum.value() + DD{here * sagitta_fraction(contact(k).t), 0});
      }
      sum.add({here, 0});
    }
  });
  return before[blocks];
}

struct Place {
  std::uint32_t segment;
  double t;
};

}  // namespace

Areas discretisation_error(const Overlay& result) {
  const NodeGraph& graph = result.nodes.graph();
  const CurveView &c1 = result.nodes.curve1(), &c2 = result.nodes.curve2();
  const std::size_t count = graph.contacts.size();
  ArcSums sums;
  sums.gap.resize(count);
  sums.total1 = bulges_at_contacts(
      c1, count,
      [&](std::size_t k) {
        return Place{graph.contacts[k].segment1, graph.contacts[k].t1.hi};
      },
      [&](std::size_t k, DD sum) { sums.gap[k] = sum; });
  sums.total2 = bulges_at_contacts(
      c2, count,
      [&](std::size_t k) {
        const Contact& contact = graph.contacts[graph.contacts2[k]];
        return Place{contact.segment2, contact.t2.hi};
      },
      [&](std::size_t k, DD sum) { sums.gap[graph.contacts2[k]] -= sum; });
  find_wraps(graph, sums);

  const auto lost = [](DD twice) { return std::fabs(0.5 * twice.hi); };
  const DD gain1 = result.nodes.clockwise1() ? -sums.total1 : sums.total1,
           gain2 = result.nodes.clockwise2() ? -sums.total2 : sums.total2;
  DD minus12, minus21, common;
  if (graph.size() > 0) {
    const Handedness hands{result.nodes.clockwise1(), result.nodes.clockwise2()};
    const FaceTotals totals = total_of_faces(graph, sums, hands);
    minus12 = totals.only1;
    minus21 = totals.only2;
    common = totals.both;
  } else if (result.areas.intersection == 0) {
    minus12 = gain1;
    minus21 = gain2;
  } else if (result.areas.c1 >= result.areas.c2) {
    minus12 = gain1 - gain2;
    common = gain2;
  } else {
    minus21 = gain2 - gain1;
    common = gain1;
  }
  if (result.nodes.same_curve()) minus12 = minus21 = {};
  Areas areas;
  areas.c1 = lost(gain1);
  areas.c2 = lost(gain2);
  areas.c1_minus_c2 = lost(minus12);
  areas.c2_minus_c1 = lost(minus21);
  areas.intersection = lost(common);
  areas.symmetric_difference = lost(minus12 + minus21);
  areas.unite = lost(minus12 + minus21 + common);
  return areas;
}

}  // namespace lober

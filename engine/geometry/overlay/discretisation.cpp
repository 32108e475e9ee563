// The error of polygons against smooth curves, arc by arc, for every area.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/curve/require.hpp"
#include "engine/geometry/overlay/arc_sums.hpp"
#include "engine/geometry/overlay/faces.hpp"
#include "kernels/sagitta.hpp"
#include "kernels/shoelace.hpp"

namespace lober {
using namespace detail;

struct detail::DiscretisationData {
  struct Chord {
    DD before;  // running sum up to it
    double area;
  };
  CurveView curve;
  Buffer<DD> before;     // running sums, up to each chunk of segments
  Buffer<Chord> chords;  // kept for a short curve: all that a contact asks for
  DD total;
};

namespace {

constexpr std::size_t chunk = 8;  // whose areas a contact computes again, all at once
constexpr std::size_t chords_a_block = 4096;
static_assert(chords_a_block % chunk == 0);
// The chords of a curve with at most that number of segments are kept: it meets many others as a rule.
constexpr std::size_t short_curve = 2048;

double chord_area(const CurveView& curve, std::size_t number) {
  const std::size_t size = curve.points.size();
  const auto at = [&](std::size_t k) { return curve.points[k >= size ? k - size : k]; };
  const Point from = at(number), to = at(number + 1);
  if (from == to) return 0;
  // The next vertices to either side that are others; there are at least two more.
  std::size_t back = number == 0 ? size - 1 : number - 1, forth = number + 2 >= size ? number + 2 - size : number + 2;
  while (at(back) == from) back = back == 0 ? size - 1 : back - 1;
  while (at(forth) == to) forth = forth + 1 == size ? 0 : forth + 1;
  const Point before = at(back), after = at(forth);
  const double area = twice_chord_area(before, from, to, after);
  if (std::isfinite(area)) return area;
  // Squares of lengths have left the range of double.
  constexpr int down = -600;
  const auto small = [](Point p) { return Point{std::ldexp(p.x, down), std::ldexp(p.y, down)}; };
  return std::ldexp(twice_chord_area(small(before), small(from), small(to), small(after)), -2 * down);
}

// Areas of the chords begin .. end - 1, in vectors where the points of a chord and its neighbours follow each other:
// not at the first vertex.
void chord_areas(const CurveView& curve, std::size_t begin, std::size_t end, double* areas) {
  const std::size_t size = curve.points.size();
  const std::size_t inner_begin = std::min(std::max<std::size_t>(begin, 1), end);
  const std::size_t inner_end = std::max(inner_begin, std::min(end, size < 2 ? 0 : size - 2));
  twice_chord_areas(&curve.points[inner_begin] - 1, inner_end - inner_begin, areas + (inner_begin - begin));
  for (std::size_t k = begin; k < end; ++k) {
    const bool inner = k >= inner_begin && k < inner_end;
    // The neighbours of a segment next to repeated vertices lie farther away.
    const bool repeated =
        inner && (curve.points[k - 1] == curve.points[k] || curve.points[k + 1] == curve.points[k + 2]);
    double& area = areas[k - begin];
    if (!inner || repeated || !std::isfinite(area)) area = chord_area(curve, k);
  }
}

struct RoundedPosition {
  std::uint32_t segment;
  double t;
};

// Calls take(k, sum) with the running sum of the chord-to-arc areas up to contact k, like sum_along for the shoelace
// sums.
template <typename ContactAt, typename Take>
void chord_areas_at_contacts(const DiscretisationSums& sums, std::size_t count, const ContactAt& contact,
                             const Take& take) {
  const CurveView& curve = sums.data().curve;
  const Buffer<DiscretisationData::Chord>& chords = sums.data().chords;
  for_each_block(count, 1024, [&](std::size_t first, std::size_t last) {
    if (!chords.empty()) {
      for (std::size_t k = first; k < last; ++k) {
        const RoundedPosition at = contact(k);
        const auto& [before, area] = chords[at.segment];
        take(k, before + DD{area * sagitta_fraction(at.t), 0});
      }
      return;
    }
    for (std::size_t k = first; k < last;) {
      const std::size_t begin = contact(k).segment / chunk * chunk;
      DD sum = sums.data().before[begin / chunk];
      std::array<double, chunk> areas;
      chord_areas(curve, begin, std::min(begin + chunk, curve.segments()), areas.data());
      for (std::size_t number = begin; k < last && contact(k).segment < begin + chunk; ++number) {
        const double here = areas[number - begin];
        for (; k < last && contact(k).segment == number; ++k) {
          take(k, sum + DD{here * sagitta_fraction(contact(k).t), 0});
        }
        sum += DD{here, 0};
      }
    }
  });
}

// With the sums that a contact on a longer curve finds.
void keep_chords(DiscretisationData& data) {
  const std::size_t segments = data.curve.segments();
  data.chords.resize(segments);
  for (std::size_t begin = 0; begin < segments; begin += chunk) {
    const std::size_t end = std::min(begin + chunk, segments);
    std::array<double, chunk> areas;
    chord_areas(data.curve, begin, end, areas.data());
    DD sum = data.before[begin / chunk];
    for (std::size_t k = begin; k < end; ++k) {
      const double area = areas[k - begin];
      data.chords[k] = {sum, area};
      sum += DD{area, 0};
    }
  }
}

}  // namespace

DiscretisationSums::DiscretisationSums(CurveView curve) {
  require_region(curve, "the curve", "discretisation error");
  auto made = std::make_shared<DiscretisationData>();
  made->curve = curve;
  Buffer<DD>& before = made->before;
  const std::size_t segments = curve.segments(), blocks = (segments + chords_a_block - 1) / chords_a_block;
  before.resize((segments + chunk - 1) / chunk);
  Buffer<DD> block_sums(blocks);
  for_each_block(segments, chords_a_block, [&](std::size_t begin, std::size_t end) {
    std::array<double, chords_a_block> areas;
    chord_areas(curve, begin, end, areas.data());
    DD sum;
    for (std::size_t k = begin; k < end; ++k) {
      if (k % chunk == 0) before[k / chunk] = sum;
      sum += DD{areas[k - begin], 0};
    }
    block_sums[begin / chords_a_block] = sum;
  });
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::size_t end = std::min((block + 1) * (chords_a_block / chunk), before.size());
    for (std::size_t k = block * (chords_a_block / chunk); k < end; ++k) before[k] = made->total + before[k];
    made->total += block_sums[block];
  }
  if (segments <= short_curve) keep_chords(*made);
  data_ = std::move(made);
}

std::size_t DiscretisationSums::memory() const {
  return data_->before.capacity() * sizeof(DD) + data_->chords.capacity() * sizeof(DiscretisationData::Chord);
}

Areas discretisation_error(const Overlay& result) {
  return discretisation_error(result, DiscretisationSums(result.nodes.curve1()),
                              DiscretisationSums(result.nodes.curve2()));
}

Areas discretisation_error(const Overlay& result, const DiscretisationSums& first, const DiscretisationSums& second) {
  const NodeGraph& graph = graph_of(result.nodes);
  const std::size_t count = graph.contacts.size();
  constexpr double largest = std::numeric_limits<double>::max();
  // Products of double-doubles need some room below the largest double.
  const double factor = result.largest_coordinate > 0x1p400 ? 0x1p-200 : 1;
  const auto reduced = [&](DD sum) { return DD{sum.hi * factor, sum.lo * factor}; };
  ArcSums sums;
  sums.gap.resize(count);
  sums.total1 = reduced(first.data().total);
  sums.total2 = reduced(second.data().total);
  chord_areas_at_contacts(
      first, count,
      [&](std::size_t k) {
        return RoundedPosition{graph.contacts[k].segment1, graph.contacts[k].t1.hi};
      },
      [&](std::size_t k, DD sum) { sums.gap[k] = reduced(sum); });
  chord_areas_at_contacts(
      second, count,
      [&](std::size_t k) {
        const Contact contact = graph.contacts[graph.contacts2[k]];
        return RoundedPosition{contact.segment2, contact.t2.hi};
      },
      [&](std::size_t k, DD sum) { sums.gap[graph.contacts2[k]] -= reduced(sum); });
  find_wraps(graph, sums);

  const auto lost = [&](DD twice) { return std::min(std::fabs(0.5 * twice.hi) / factor, largest); };
  const DD gain1 = result.nodes.clockwise1() ? -sums.total1 : sums.total1,
           gain2 = result.nodes.clockwise2() ? -sums.total2 : sums.total2;
  DD minus12, minus21, common;
  if (graph.size() > 0) {
    const Orientations orientations{result.nodes.clockwise1(), result.nodes.clockwise2()};
    const FaceTotals totals = total_of_faces(graph, sums, orientations);
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
  areas.union_ = lost(minus12 + minus21 + common);
  return areas;
}

}  // namespace lober

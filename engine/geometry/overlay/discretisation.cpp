// The error of polygons against smooth curves, arc by arc, for every area.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/base/parallel/isolated.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/curve/require.hpp"
#include "engine/geometry/curve/scaled.hpp"
#include "engine/geometry/overlay/arc_sums.hpp"
#include "engine/geometry/overlay/faces.hpp"
#include "engine/geometry/smooth/near_misses.hpp"
#include "kernels/point.hpp"
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

  struct Arcs {
    explicit Arcs(CurveView view) : curve(view), boxes(curve) {}
    SmoothCurve curve;
    ArcBoxes boxes;  // which point to it
  };
  // For curves that do not cross any other: made when that is first asked for, by any thread.
  [[nodiscard]] const Arcs& arcs() const {
    std::call_once(arcs_made_, [this] {
      // A thread that waits for others here must not begin what would wait for it.
      run_isolated([this] { arcs_ = made_of(curve); });
    });
    return *arcs_;
  }
  static std::unique_ptr<const Arcs> made_of(CurveView curve) {
    auto made = std::make_unique<Arcs>(curve);
    made->boxes.add_all();
    return made;
  }

 private:
  mutable std::once_flag arcs_made_;
  mutable std::unique_ptr<const Arcs> arcs_;
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

// Calls take(k, sum, area) with the running sum of the chord-to-arc areas up to contact k, like sum_along for the
// shoelace sums, and the area of the segment that it is on.
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
        take(k, before + DD{area * sagitta_fraction(at.t), 0}, area);
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
          take(k, sum + DD{here * sagitta_fraction(contact(k).t), 0}, here);
        }
        sum += DD{here, 0};
      }
    }
  });
}

// A segment as the parabola over it that has the same chord-to-arc area, seen from a contact at parameter t.
struct Bend {
  Point chord;
  double length;
  double height;  // that the parabola reaches to the right of the segment; negative to the left
  double right;   // how far to the right it is at the contact
  double slope;   // first derivative of that along the segment
  double bend;    // second derivative

  Bend(const CurveView& curve, std::uint32_t segment, double t, double twice_area)
      : chord(curve.points[segment + 1 == curve.points.size() ? 0 : segment + 1] - curve.points[segment]),
        length(detail::length(chord)),
        height(length > 0 ? 0.75 * twice_area / length : 0),
        right(4 * height * t * (1 - t)),
        slope(length > 0 ? 4 * height * (1 - 2 * t) / length : 0),
        bend(length > 0 ? -8 * height / length / length : 0) {}
};

// The area between smooth curves and polygons at crossings that the arcs up to them do not have: the smooth curves
// cross elsewhere. Let g be the signed distance between the polygons along the first one, with g = 0 at the crossing,
// and q that between the smooth curves. Arcs that end where the polygons cross count q - g where g > 0, but the area is
// that where q > 0: |q| is missing wherever the two differ in sign. About the crossing q is a parabola, and differs in
// sign from g up to where it vanishes. Where curves are nearly tangent it need not vanish, but turn: up to there then,
// as the other end of the lens has the rest. The polygons' next crossing is an end as well. |q| is no larger there than
// the polygons are wrong, and where there is no other crossing, that is not the case for longer than a segment.
class CrossingEnds {
 public:
  CrossingEnds(const NodeGraph& graph, const CurveView& c1, const CurveView& c2, const Buffer<double>& areas1,
               const Buffer<double>& areas2)
      : graph_(graph), c1_(c1), c2_(c2), areas1_(areas1), areas2_(areas2) {}

  // In fixed blocks, so that it does not depend on the number of threads.
  [[nodiscard]] double area() const {
    constexpr std::size_t crossings_a_block = 1024;
    std::vector<double> sums(graph_.size() / crossings_a_block + 1);
    for_each_block(graph_.size(), crossings_a_block, [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t node = begin; node < end; ++node) sum += area_at(static_cast<std::uint32_t>(node));
      sums[begin / crossings_a_block] = sum;
    });
    double sum = 0;
    for (const double one : sums) sum += one;
    return sum;
  }

 private:
  [[nodiscard]] double area_at(std::uint32_t node) const {
    const NodeSpan span = graph_.span(node);
    if (span.direction != 0 || graph_.order[node] >= first_touch) return 0;
    const double twice_area1 = areas1_[span.first], twice_area2 = areas2_[span.first];
    if (twice_area1 == 0 && twice_area2 == 0) return 0;
    const Contact at = graph_.contacts[span.first];
    const Bend one(c1_, at.segment1, at.t1.hi, twice_area1), other(c2_, at.segment2, at.t2.hi, twice_area2);
    if (!(one.length > 0 && other.length > 0)) return 0;
    const double along = dot(one.chord, other.chord) >= 0 ? 1 : -1;
    const double sine = along * cross(one.chord, other.chord) / one.length / other.length;
    // The first curve above the second one, along the first chord.
    const double offset = along * other.right - one.right, slope = other.slope - one.slope - sine;
    const double bend = along * other.bend - one.bend;
    // Towards where the signs differ |q| is depth - falls y + rises y^2 / 2 at the distance y.
    const double depth = std::fabs(offset), falls = sine < 0 ? slope : -slope, rises = offset < 0 ? -bend : bend;
    const double deepest = std::fabs(one.height) + std::fabs(other.height), root = falls * falls - 2 * rises * depth;
    const double longest = std::max(one.length, other.length);
    double reach = longest;
    if (root >= 0 && (falls > 0 || rises < 0)) {
      reach = std::min(reach, 2 * depth / (falls + std::sqrt(root)));
    } else if (falls > 0) {
      reach = std::min(reach, falls / rises);
    } else {
      const double more = std::max(deepest - depth, 0.0);
      reach = std::min(reach, 2 * more / (std::sqrt(falls * falls + 2 * rises * more) - falls));
    }
    // Most often it is a small part of a segment.
    const double t = at.t1.hi * one.length;
    const bool onward = (sine < 0) == (offset < 0);
    if (reach > (onward ? one.length - t : t)) reach = up_to_next(node, onward, reach);
    const double area = reach * (depth - reach * (falls / 2 - reach * rises / 6));
    double sum = area > 0 ? std::min(area, reach * deepest) : 0;
    // On the other side it may come back to the wrong sign for a while: a lens that has moved along.
    if (falls < 0 && rises > 0 && root > 0) {
      const double width = 2 * std::sqrt(root) / rises, begin = -falls / rises - width / 2;
      if (begin < longest && begin < up_to_next(node, !onward, longest))
        sum += width * std::min(deepest, root / rises / 3);
    }
    return sum;
  }

  // The distance to the next node along C1, onward or back, if that is next to it along C2 too and nearer than `reach`;
  // else `reach`.
  [[nodiscard]] double up_to_next(std::uint32_t node, bool onward, double reach) const {
    constexpr std::uint32_t few = 64;  // segments: farther away it is another place
    const std::uint32_t count = graph_.size(), last = count - 1;
    if (count < 2) return reach;
    const std::uint32_t next = onward ? (node == last ? 0 : node + 1) : (node == 0 ? last : node - 1);
    const std::uint32_t rank = graph_.rank2[node], other = graph_.rank2[next];
    const std::uint32_t apart = rank < other ? other - rank : rank - other;
    if (apart != 1 && apart != last) return reach;
    const NodeSpan span = graph_.span(next);
    const Contact here = graph_.contacts[graph_.span(node).first];
    const Contact there = graph_.contacts[onward ? span.first : span.last];
    const std::uint32_t from = onward ? here.segment1 : there.segment1, to = onward ? there.segment1 : here.segment1;
    const auto segments = static_cast<std::uint32_t>(c1_.segments());
    const bool wraps = to < from || (to == from && (onward ? there.t1.hi < here.t1.hi : here.t1.hi < there.t1.hi));
    if ((wraps ? segments - from + to : to - from) > std::min(few, segments / 4)) return reach;
    return std::min(reach, distance(contact_point(here, c1_, c2_), contact_point(there, c1_, c2_)));
  }

  const NodeGraph& graph_;
  CurveView c1_, c2_;
  const Buffer<double>&areas1_, &areas2_;
};

// Twice the area that smooth curves have in common, or that one of them has outside the other one, where the polygons
// do not cross at all.
double twice_hidden(const DiscretisationData::Arcs& one, const DiscretisationData::Arcs& other) {
  const auto root = [](const ArcBoxes& boxes) { return boxes.box({boxes.levels() - 1, 0}); };
  if (!meet(root(one.boxes), root(other.boxes))) return 0;
  NodeSegments none1(one.curve.segments()), none2(other.curve.segments());
  none1.join();
  none2.join();
  return hidden_area({one.curve, one.boxes, none1}, {other.curve, other.boxes, none2});
}

// The curves have to be multiplied by 2^exponent.
double area_hidden(int exponent, const DiscretisationData& first, const DiscretisationData& second) {
  if (exponent == 0) return 0.5 * twice_hidden(first.arcs(), second.arcs());
  const std::vector<Point> one = scaled(first.curve, exponent), other = scaled(second.curve, exponent);
  return scaled_area(twice_hidden(*DiscretisationData::made_of({one, first.curve.closed}),
                                  *DiscretisationData::made_of({other, second.curve.closed})),
                     -2 * exponent - 1);
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
  // The boxes of the arcs may be made later.
  constexpr std::size_t bytes_a_leaf = 2 * sizeof(Box) + sizeof(ArcStrip) + sizeof(double);
  return data_->before.capacity() * sizeof(DD) + data_->chords.capacity() * sizeof(DiscretisationData::Chord) +
         (data_->curve.segments() / ArcBoxes::segments_a_leaf + 1) * bytes_a_leaf;
}

namespace {

// The estimate for curves that have to be multiplied by 2^exponent before squares of lengths are taken. The curves of
// the sums may be those of the result, scaled.
Areas estimate(const Overlay& result, const DiscretisationSums& first, const DiscretisationSums& second, int exponent) {
  const NodeGraph& graph = graph_of(result.nodes);
  const std::size_t count = graph.contacts.size();
  constexpr double largest = std::numeric_limits<double>::max();
  // Products of double-doubles need some room below the largest double.
  const double factor = result.largest_coordinate > 0x1p400 ? 0x1p-200 : 1;
  const auto reduced = [&](DD sum) { return DD{sum.hi * factor, sum.lo * factor}; };
  ArcSums sums;
  sums.gap.resize(count);
  Buffer<double> areas1(count), areas2(count);
  sums.total1 = reduced(first.data().total);
  sums.total2 = reduced(second.data().total);
  chord_areas_at_contacts(
      first, count,
      [&](std::size_t k) {
        return RoundedPosition{graph.contacts[k].segment1, graph.contacts[k].t1.hi};
      },
      [&](std::size_t k, DD sum, double area) {
        sums.gap[k] = reduced(sum);
        areas1[k] = area;
      });
  chord_areas_at_contacts(
      second, count,
      [&](std::size_t k) {
        const Contact contact = graph.contacts[graph.contacts2[k]];
        return RoundedPosition{contact.segment2, contact.t2.hi};
      },
      [&](std::size_t k, DD sum, double area) {
        sums.gap[graph.contacts2[k]] -= reduced(sum);
        areas2[graph.contacts2[k]] = area;
      });
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
  const double ends = result.nodes.same_curve() ? 0
                      : result.nodes.crossings() > 0
                          ? CrossingEnds(graph, first.data().curve, second.data().curve, areas1, areas2).area()
                          : area_hidden(exponent, first.data(), second.data());
  const auto with_ends = [&](DD twice, double times) { return std::min(lost(twice) + times * ends, largest); };
  Areas areas;
  areas.c1 = lost(gain1);
  areas.c2 = lost(gain2);
  areas.c1_minus_c2 = with_ends(minus12, 1);
  areas.c2_minus_c1 = with_ends(minus21, 1);
  areas.intersection = with_ends(common, 1);
  areas.symmetric_difference = with_ends(minus12 + minus21, 2);
  areas.union_ = with_ends(minus12 + minus21 + common, 1);
  return areas;
}

}  // namespace

Areas discretisation_error(const Overlay& result) {
  return discretisation_error(result, DiscretisationSums(result.nodes.curve1()),
                              DiscretisationSums(result.nodes.curve2()));
}

Areas discretisation_error(const Overlay& result, const DiscretisationSums& first, const DiscretisationSums& second) {
  const int exponent = result.nodes.data().exponent;
  if (exponent <= 0) return estimate(result, first, second, exponent);
  // Squares of the lengths of such small segments underflow, in the sums too.
  const std::vector<Point> one = scaled(first.data().curve, exponent), other = scaled(second.data().curve, exponent);
  Areas areas = estimate(result, DiscretisationSums({one, true}), DiscretisationSums({other, true}), 0);
  scale(areas, -2 * exponent);
  return areas;
}

}  // namespace lober

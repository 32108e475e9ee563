// The table of escape: its rows, measured by the common areas of curves and compared in more than one way.
#include "engine/dynamics/escape/fraction_table.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/base/parallel/parallel.hpp"
#include "engine/dynamics/escape/winding_product.hpp"

namespace lober::detail {
namespace {

// The work for a point where cut curves cross themselves or each other, in evaluations of the vector field:
// 20 to 60 were measured (capsize at energies from 0.26 to 0.5).
constexpr double work_a_node = 50;

}  // namespace

// Directions alternate, so that m fixes where a trajectory is and n.
void FractionTable::lay_out_rows(int wanted) {
  const auto& bottlenecks = result_.bottlenecks;
  for (std::size_t i = 0; i < bottlenecks.size(); ++i) {
    const int start = bottlenecks[i].entry[0].direction;
    for (std::size_t j = 0; j < bottlenecks.size(); ++j) {
      int n = 0;
      for (int m = 0;; ++m) {
        const int here = m % 2 == 0 ? start : -start;
        n += here == result_.section.direction;
        if (n > wanted) break;
        if (std::max(n, 1) != wanted || here != bottlenecks[j].exit[0].direction) continue;
        EscapeFraction row;
        row.entry = i;
        row.exit = j;
        row.crossings = n;
        row.iterates = m;
        result_.table.push_back(row);
      }
    }
  }
  std::sort(result_.table.begin(), result_.table.end(), [](const EscapeFraction& x, const EscapeFraction& y) {
    return std::tie(x.entry, x.exit, x.iterates) < std::tie(y.entry, y.exit, y.iterates);
  });
}

double FractionTable::measure() {
  std::atomic<std::uint64_t> nodes = 0;
  for_each_block(result_.table.size(), 1, [&](std::size_t k, std::size_t) { measure(result_.table[k], nodes); });
  std::erase_if(result_.table, [](const EscapeFraction& row) { return row.crossings == 0 && row.fraction == 0; });
  return static_cast<double>(nodes) * work_a_node;
}

// Those with the fewest cut curves first, then those with the fewest points.
std::vector<FractionTable::Split> FractionTable::splits_of(const EscapeFraction& row) const {
  const auto &entries = result_.bottlenecks[row.entry].entry, &exits = result_.bottlenecks[row.exit].exit;
  std::vector<Split> splits;
  for (int a = 0; a <= row.iterates; ++a) {
    const auto forward = static_cast<std::size_t>(a), backward = static_cast<std::size_t>(row.iterates - a);
    if (forward >= entries.size() || backward >= exits.size()) continue;
    const TubeCurve &first = entries[forward], &second = exits[backward];
    splits.push_back({a, first.cut + second.cut, first.image.points.size() + second.image.points.size()});
  }
  std::stable_sort(splits.begin(), splits.end(),
                   [](const Split& x, const Split& y) { return x.cut != y.cut ? x.cut < y.cut : x.points < y.points; });
  return splits;
}

CommonArea FractionTable::fraction(const EscapeFraction& row, int forward, std::atomic<std::uint64_t>& nodes) const {
  const Bottleneck &from = result_.bottlenecks[row.entry], &to = result_.bottlenecks[row.exit];
  const TubeCurve& a = from.entry[static_cast<std::size_t>(forward)];
  const TubeCurve& b = to.exit[static_cast<std::size_t>(row.iterates - forward)];
  if (a.cut || b.cut) {
    const CommonWindingArea common = common_area_by_winding(a.view(), b.view());
    nodes += common.nodes;
    return {common.area / from.area,
            (common.error + a.cut_off + b.cut_off + a.displacement_area + b.displacement_area) / from.area};
  }
  const CommonArea common = common_area(a.view(), b.view());
  const double share = common.area / from.area;
  // The defect of the curves' areas that the action shows may be missing in the common area too.
  return {share, (common.error + a.displacement_area + b.displacement_area) / from.area +
                     share * (std::fabs(a.area / from.area - 1) + std::fabs(b.area / to.area - 1))};
}

void FractionTable::measure(EscapeFraction& row, std::atomic<std::uint64_t>& nodes) const {
  if (row.is_known() && row.other == row.other) return;
  std::vector<Split> splits = splits_of(row);
  if (row.is_known()) {
    std::erase_if(splits, [&](const Split& split) { return split.forward == row.forward; });
  } else if (!splits.empty()) {
    const CommonArea best = fraction(row, splits[0].forward, nodes);
    row.fraction = best.area;
    row.error = best.error;
    row.forward = splits[0].forward;
    row.backward = row.iterates - row.forward;
    row.cut = splits[0].cut > 0;
    splits.erase(splits.begin());
  }
  if (splits.empty() || (splits[0].cut > 0 && !row.cut)) return;
  const CommonArea other = fraction(row, splits[0].forward, nodes);
  row.other = other.area;
  row.other_error = other.error;
  row.other_forward = splits[0].forward;
  row.other_backward = row.iterates - row.other_forward;
}

void FractionTable::compare() {
  Agreement& agreement = result_.agreement;
  agreement = {};
  compare_areas(result_.bottlenecks, agreement);
  if (!symmetries_) symmetries_ = symmetries(flow_, result_.section, result_.bottlenecks);
  result_.largest_split_difference = 0;
  for (const EscapeFraction& row : result_.table) {
    if (row.other == row.other) {
      result_.largest_split_difference =
          std::max(result_.largest_split_difference, std::fabs(row.fraction - row.other));
    }
    agreement.compare({name(row), "split " + split_text(row.forward, row.backward),
                       "split " + split_text(row.other_forward, row.other_backward), row.fraction, row.other,
                       row.error + row.other_error});
    for (const EscapeSymmetry& symmetry : *symmetries_) compare_by(symmetry, row, agreement);
    agreement.compare({name(row), "its curves", "the range from 0 to 1", row.fraction,
                       std::clamp(row.fraction, 0.0, 1.0), row.error});
  }
  compare_sums(agreement);
  compare_sums_by_exit(agreement);
  compare_cut_areas(agreement);
}

// No more leaves than has entered: tubes that the section meets along the flow, or more than once on their way from
// one crossing to the next, give fractions that overlap.
void FractionTable::compare_sums(Agreement& agreement) const {
  for (std::size_t entry = 0; entry < result_.bottlenecks.size(); ++entry) {
    for (const Survival& step : survival(result_, entry)) {
      const double left = 1 - step.remains;
      agreement.compare({"the fraction from bottleneck " + std::to_string(entry + 1) +
                             " that has left after crossing " + std::to_string(step.crossings),
                         "the sum of all", "what has entered", left, std::min(left, 1.0), step.error});
    }
  }
}

// No more leaves by an exit than it holds: what is in it has entered by one bottleneck, one number of crossings ago.
void FractionTable::compare_sums_by_exit(Agreement& agreement) const {
  for (std::size_t exit = 0; exit < result_.bottlenecks.size(); ++exit) {
    double sum = 0, error = 0;
    for (const EscapeFraction& row : result_.table) {
      if (row.exit != exit || !row.is_known()) continue;
      const double area = result_.bottlenecks[row.entry].area / result_.bottlenecks[exit].area;
      sum += row.fraction * area;
      error += row.error * area;
    }
    agreement.compare({"the fraction of bottleneck " + std::to_string(exit + 1) + " by which trajectories leave",
                       "the sum of all", "what it holds", sum, std::min(sum, 1.0), error});
  }
}

// A cut image holds what has not left before, or on the other side what has not entered since; where more bottlenecks
// are open than are asked for, no more than that. One that the section tears holds several times as much (capsize at
// energy 0.26, sections off the middle by 0.1 to 0.18: 1.5 to 116 times E), and both splits may be of such curves. The
// bars of curves with jumps are not sharp (3.2 times too short at energy 0.4), so a tenth of E is allowed beyond them.
void FractionTable::compare_cut_areas(Agreement& agreement) const {
  constexpr double beyond_bars = 0.1;
  const auto compare = [&](std::size_t number, bool entry) {
    const Bottleneck& bottleneck = result_.bottlenecks[number];
    const std::vector<TubeCurve>& curves = entry ? bottleneck.entry : bottleneck.exit;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      if (!curves[k].cut) continue;
      double held = 1, error = 0;  // NaN, which is compared with nothing, where a row is not known
      for (const EscapeFraction& row : result_.table) {
        if ((entry ? row.entry : row.exit) != number || row.iterates >= static_cast<int>(k)) continue;
        const double area = result_.bottlenecks[row.entry].area / bottleneck.area;
        held -= row.fraction * area;
        error += row.error * area;
      }
      const CommonWindingArea own = area_by_winding(curves[k].view());
      const double area = own.area / bottleneck.area;
      error += (own.error + curves[k].cut_off + curves[k].displacement_area) / bottleneck.area;
      agreement.compare({std::string("the area of ") + (entry ? "entrance " : "exit ") + std::to_string(number + 1) +
                             ", cut image " + std::to_string(k),
                         "its points", "what is left of it", area,
                         result_.also_open.empty() ? held : std::min(area, held), error + beyond_bars});
    }
  };
  for (std::size_t number = 0; number < result_.bottlenecks.size(); ++number) {
    compare(number, true);
    compare(number, false);
  }
}

std::string FractionTable::split_text(int forward, int backward) {
  return std::to_string(forward) + " + " + std::to_string(backward);
}

// The fraction that the symmetry makes of this one, unless it is the same or comes earlier.
void FractionTable::compare_by(const EscapeSymmetry& symmetry, const EscapeFraction& row, Agreement& agreement) const {
  const std::size_t first = symmetry.becomes[row.entry], second = symmetry.becomes[row.exit];
  const std::size_t entry = symmetry.backwards ? second : first, exit = symmetry.backwards ? first : second;
  for (const EscapeFraction& other : result_.table) {
    if (&other <= &row || other.entry != entry || other.exit != exit || other.iterates != row.iterates) continue;
    const double scale = result_.bottlenecks[entry].area / result_.bottlenecks[row.entry].area;
    agreement.compare({name(row), "its own curves",
                       std::string(symmetry.backwards ? "time reversal" : "symmetry") + " from bottlenecks " +
                           std::to_string(entry + 1) + " and " + std::to_string(exit + 1),
                       row.fraction, scale * other.fraction, row.error + scale * other.error});
  }
}

}  // namespace lober::detail

namespace lober {

std::string name(const EscapeFraction& row) {
  return "the fraction from bottleneck " + std::to_string(row.entry + 1) + " to " + std::to_string(row.exit + 1) +
         " after crossing " + std::to_string(row.crossings);
}

void compare_areas(std::span<const Bottleneck> bottlenecks, Agreement& agreement) {
  for (std::size_t number = 0; number < bottlenecks.size(); ++number) {
    const Bottleneck& bottleneck = bottlenecks[number];
    for (const auto* curves : {&bottleneck.entry, &bottleneck.exit}) {
      for (std::size_t k = 0; k < curves->size(); ++k) {
        const TubeCurve& curve = (*curves)[k];
        if (!curve.complete) continue;
        agreement.compare({std::string("the area of ") + (curves == &bottleneck.entry ? "entrance " : "exit ") +
                               std::to_string(number + 1) + ", image " + std::to_string(k),
                           "its points", "action", curve.area, bottleneck.area,
                           curve.area_error + bottleneck.area_error});
      }
    }
  }
}

std::vector<Survival> survival(const Escape& result, std::size_t entry) {
  std::vector<Survival> steps;
  Survival sum;
  sum.left.assign(result.bottlenecks.size(), 0);
  for (int n = 1;; ++n) {
    bool any = false;
    for (const EscapeFraction& part : result.table) {
      if (part.entry != entry || std::max(part.crossings, 1) != n) continue;
      if (!part.is_known()) return steps;
      any = true;
      sum.left[part.exit] += part.fraction;
      sum.remains -= part.fraction;
      sum.error += part.error;
    }
    if (!any) return steps;
    sum.crossings = n;
    steps.push_back(sum);
  }
}

}  // namespace lober

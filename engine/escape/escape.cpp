#include "engine/escape/escape.hpp"

#include <algorithm>
#include <cmath>

#include "engine/error.hpp"
#include "engine/escape/necks.hpp"
#include "engine/escape/winding_product.hpp"
#include "engine/parallel/parallel.hpp"

namespace lober {
namespace {

class Builder {
 public:
  Builder(const Flow& flow, const Section& section, double energy, const EscapeOptions& options)
      : flow_(flow), options_(options) {
    result_.energy = energy;
    result_.section = section;
  }

  Escape build(std::span<const FlowState> guesses) {
    Section either = result_.section;
    either.direction = 0;
    Necks necks(flow_, either, result_.energy, guesses, options_);
    necks.cut_first();
    necks.cut_images(images_wanted());
    result_.bottlenecks = std::move(necks.list);
    lay_out_table();
    necks.report("overlaps");
    measure();
    return std::move(result_);
  }

 private:
  // The largest m is 2 n, split into halves.
  [[nodiscard]] int images_wanted() const { return options_.crossings; }

  // Directions alternate, so that m fixes where a trajectory is and n.
  void lay_out_table() {
    const auto& necks = result_.bottlenecks;
    for (std::size_t i = 0; i < necks.size(); ++i) {
      const int start = necks[i].entry[0].direction;
      for (std::size_t j = 0; j < necks.size(); ++j) {
        int n = 0;
        for (int m = 0;; ++m) {
          const int here = m % 2 == 0 ? start : -start;
          n += here == result_.section.direction;
          if (n > options_.crossings) break;
          if (n == 0 || here != necks[j].exit[0].direction) continue;
          EscapeFraction entry;
          entry.entry = i;
          entry.exit = j;
          entry.crossings = n;
          entry.iterates = m;
          result_.table.push_back(entry);
        }
      }
    }
  }

  void measure() {
    for_each_block(result_.table.size(), 1, [&](std::size_t k, std::size_t) { measure(result_.table[k]); });
    for (const EscapeFraction& entry : result_.table) {
      if (entry.other == entry.other) {
        result_.largest_split_difference =
            std::max(result_.largest_split_difference, std::fabs(entry.fraction - entry.other));
      }
    }
  }

  void measure(EscapeFraction& entry) const {
    const Bottleneck& from = result_.bottlenecks[entry.entry];
    const Bottleneck& to = result_.bottlenecks[entry.exit];
    struct Split {
      int forward;
      int torn;
      std::size_t points;
    };
    std::vector<Split> splits;
    for (int a = 0; a <= entry.iterates; ++a) {
      const auto forward = static_cast<std::size_t>(a), backward = static_cast<std::size_t>(entry.iterates - a);
      if (forward >= from.entry.size() || backward >= to.exit.size()) continue;
      const TubeCurve &first = from.entry[forward], &second = to.exit[backward];
      splits.push_back({a, first.torn + second.torn, first.image.points.size() + second.image.points.size()});
    }
    std::stable_sort(splits.begin(), splits.end(), [](const Split& x, const Split& y) {
      return x.torn != y.torn ? x.torn < y.torn : x.points < y.points;
    });
    const auto fraction = [&](int forward) {
      const TubeCurve& a = from.entry[static_cast<std::size_t>(forward)];
      const TubeCurve& b = to.exit[static_cast<std::size_t>(entry.iterates - forward)];
      if (a.torn || b.torn) {
        const CommonArea common = common_area_by_winding(a.view(), b.view());
        return CommonArea{common.area / from.area, (common.error + a.cut_off + b.cut_off) / from.area};
      }
      const CommonArea common = common_area(a.view(), b.view());
      const double share = common.area / from.area;
      return CommonArea{share, common.error / from.area +
                                   share * (std::fabs(a.area / from.area - 1) + std::fabs(b.area / to.area - 1))};
    };
    if (splits.empty()) return;
    const CommonArea best = fraction(splits[0].forward);
    entry.fraction = best.area;
    entry.error = best.error;
    entry.forward = splits[0].forward;
    entry.backward = entry.iterates - entry.forward;
    entry.torn = splits[0].torn > 0;
    if (splits.size() < 2 || (splits[1].torn > 0 && !entry.torn)) return;
    entry.other = fraction(splits[1].forward).area;
    entry.other_forward = splits[1].forward;
    entry.other_backward = entry.iterates - entry.other_forward;
  }

  const Flow& flow_;
  const EscapeOptions& options_;
  Escape result_;
};

}  // namespace

std::vector<Bottleneck> bottlenecks(const Flow& flow, const Section& section, double energy,
                                    std::span<const FlowState> saddles, const EscapeOptions& options) {
  if (!(options.tolerance > 0)) throw UsageError("escape: the tolerance has to be positive");
  Section known = position_section(flow, section.coordinate, section.value, section.direction);
  known.bound_coordinate = section.bound_coordinate;
  known.bound = section.bound;
  known.bound_side = section.bound_side;
  Necks necks(flow, known, energy, saddles, options);
  necks.cut_first();
  return std::move(necks.list);
}

Escape escape(const Flow& flow, const Section& section, double energy, std::span<const FlowState> saddles,
              const EscapeOptions& options) {
  if (options.crossings < 1) throw UsageError("escape takes at least one crossing");
  if (!(options.tolerance > 0)) throw UsageError("escape: the tolerance has to be positive");
  if (section.direction == 0) throw UsageError("escape counts crossings in one direction: the section needs one");
  if (section.bound_side != 0) throw UsageError("escape takes sections without bound");
  const Section whole = position_section(flow, section.coordinate, section.value, section.direction);
  return Builder(flow, whole, energy, options).build(saddles);
}

std::vector<Survival> survival(const Escape& result, std::size_t entry) {
  std::vector<Survival> steps;
  Survival sum;
  sum.left.assign(result.bottlenecks.size(), 0);
  for (int n = 1;; ++n) {
    bool any = false;
    for (const EscapeFraction& part : result.table) {
      if (part.entry != entry || part.crossings != n) continue;
      if (!part.known()) return steps;
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

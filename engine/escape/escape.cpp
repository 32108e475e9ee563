#include "engine/escape/escape.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

#include "engine/error.hpp"
#include "engine/escape/common_area.hpp"
#include "engine/parallel/parallel.hpp"

namespace lober {
namespace {

class Builder {
 public:
  Builder(const Flow& flow, const Section& section, double energy, const EscapeOptions& options)
      : flow_(flow), both_(section), options_(options) {
    result_.energy = energy;
    result_.section = section;
    both_.direction = 0;
  }

  Escape build(std::span<const FlowState> guesses) {
    find_orbits(guesses);
    cut_tubes();
    lay_out_table();
    measure();
    return std::move(result_);
  }

 private:
  struct Cut {
    Tube entry, exit;
    Branch entry_branch, exit_branch;
  };

  void report(const std::string& what) const {
    if (!options_.progress) return;
    const std::lock_guard lock(mutex_);
    if (!options_.progress(what)) throw Cancelled();
  }

  void find_orbits(std::span<const FlowState> guesses) {
    if (guesses.empty()) throw UsageError("escape needs at least one saddle");
    report("periodic orbits");
    const auto axis = static_cast<std::size_t>(both_.coordinate);
    IntegrationOptions exact = options_.integration;
    exact.tolerance = std::min(exact.tolerance, 3e-15);
    for (const FlowState& guess : guesses) {
      Bottleneck neck;
      neck.orbit = periodic_orbit(flow_, saddle_point(flow_, guess), result_.energy, exact);
      for (const Bottleneck& other : result_.bottlenecks) {
        if (std::fabs(other.orbit.state[axis] - neck.orbit.state[axis]) < 1e-9) {
          throw UsageError("two of the saddles are one");
        }
      }
      result_.bottlenecks.push_back(std::move(neck));
    }
    std::sort(result_.bottlenecks.begin(), result_.bottlenecks.end(), [&](const Bottleneck& x, const Bottleneck& y) {
      return x.orbit.saddle.at[axis] < y.orbit.saddle.at[axis];
    });
  }

  // E and X first, because they say where later images are torn.
  void cut_tubes() {
    auto& necks = result_.bottlenecks;
    report("local manifolds");
    std::vector<std::optional<Cut>> cuts(necks.size());
    for_each_block(necks.size(), 1, [&](std::size_t k, std::size_t) {
      Tube entry(flow_, necks[k].orbit, Side::unstable, options_.integration);
      Tube exit(flow_, necks[k].orbit, Side::stable, options_.integration);
      const Branch in = entry.branch_towards(both_), out = exit.branch_towards(both_);
      cuts[k].emplace(Cut{std::move(entry), std::move(exit), in, out});
      necks[k].area = cuts[k]->entry.area_by_action(both_);
    });
    double least = necks[0].area;
    for (const Bottleneck& neck : necks) least = std::min(least, neck.area);
    TubeCurveOptions tracing;
    tracing.tolerance = options_.tolerance * std::sqrt(least);
    tracing.most_points = options_.most_points;
    tracing.progress = [this] { return report("tubes"), true; };
    const auto both_sides = [&](const auto& body) {
      for_each_block(2 * necks.size(), 1, [&](std::size_t k, std::size_t) {
        const Cut& cut = *cuts[k / 2];
        if (k % 2 == 0) {
          body(necks[k / 2].entry, cut.entry, cut.entry_branch, true);
        } else {
          body(necks[k / 2].exit, cut.exit, cut.exit_branch, false);
        }
      });
    };
    both_sides([&](std::vector<TubeCurve>& curves, const Tube& tube, Branch branch, bool) {
      curves = tube.curves(branch, both_, tracing, [](const TubeCurve&) { return false; });
      require_first(curves);
    });
    const int most = images_wanted();
    std::vector<std::vector<TubeCurve>> ends(2);
    for (const Bottleneck& neck : necks) {
      ends[0].push_back(neck.exit[0]);
      ends[1].push_back(neck.entry[0]);
    }
    both_sides([&](std::vector<TubeCurve>& curves, const Tube& tube, Branch branch, bool entry) {
      int done = 0;
      curves = tube.curves(branch, both_, tracing, [&](const TubeCurve& curve) {
        if (curve.direction == 0) throw DataError("a tube crosses the section in both directions");
        if (done++ == most) return false;
        const auto& gates = ends[entry ? 0 : 1];
        return std::none_of(gates.begin(), gates.end(), [&](const TubeCurve& gate) {
          return gate.direction == curve.direction && common_area(curve.view(), gate.view()).area > 0;
        });
      });
      if (!curves.back().complete) curves.pop_back();
    });
    for (Bottleneck& neck : necks) {
      for (const auto* curves : {&neck.entry, &neck.exit}) {
        for (const TubeCurve& curve : *curves) {
          neck.area_defect = std::max(neck.area_defect, std::fabs(curve.area / neck.area - 1));
        }
      }
    }
  }

  static void require_first(const std::vector<TubeCurve>& curves) {
    if (!curves[0].complete) throw DataError("a tube does not reach the section as a closed curve");
    if (curves[0].direction == 0) throw DataError("a tube crosses the section in both directions");
  }

  // What splits into halves needs, and one more for a second split.
  [[nodiscard]] int images_wanted() const { return options_.crossings + 1; }

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
    report("overlaps");
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
      std::size_t points;
    };
    std::vector<Split> splits;
    for (int a = 0; a <= entry.iterates; ++a) {
      const auto forward = static_cast<std::size_t>(a), backward = static_cast<std::size_t>(entry.iterates - a);
      if (forward >= from.entry.size() || backward >= to.exit.size()) continue;
      splits.push_back({a, from.entry[forward].image.points.size() + to.exit[backward].image.points.size()});
    }
    std::stable_sort(splits.begin(), splits.end(), [](const Split& x, const Split& y) { return x.points < y.points; });
    const auto fraction = [&](int forward) {
      const TubeCurve& a = from.entry[static_cast<std::size_t>(forward)];
      const TubeCurve& b = to.exit[static_cast<std::size_t>(entry.iterates - forward)];
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
    if (splits.size() < 2) return;
    entry.other = fraction(splits[1].forward).area;
    entry.other_forward = splits[1].forward;
    entry.other_backward = entry.iterates - entry.other_forward;
  }

  const Flow& flow_;
  Section both_;  // the section, crossed in either direction
  const EscapeOptions& options_;
  Escape result_;
  mutable std::mutex mutex_;
};

}  // namespace

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

#include "engine/escape/escape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>

#include "engine/error.hpp"
#include "engine/escape/common_area.hpp"
#include "engine/escape/torn_images.hpp"
#include "engine/parallel/parallel.hpp"

namespace lober {
namespace {

// Torn images are measured as polygons and end where a strip is cut off: they need not be as fine as whole ones.
constexpr double torn_coarseness = 10;

// Tells what is being done, from whatever thread, one at a time.
class Reporter {
 public:
  explicit Reporter(const EscapeOptions& options) : options_(options) {}
  void operator()(const std::string& what) const {
    if (!options_.progress) return;
    const std::lock_guard lock(mutex_);
    if (!options_.progress(what)) throw Cancelled();
  }

 private:
  const EscapeOptions& options_;
  mutable std::mutex mutex_;
};

// The bottlenecks with their tubes, from which curves are cut.
class Necks {
 public:
  Necks(const Flow& flow, const Section& cut_by, double energy, std::span<const FlowState> guesses,
        const EscapeOptions& options)
      : flow_(flow), section_(cut_by), options_(options), report_(options) {
    find_orbits(guesses, energy);
    find_tubes();
  }

  std::vector<Bottleneck> list;

  // E and X.
  void cut_first() {
    for_each_tube([&](std::vector<TubeCurve>& curves, const Tube& tube, Branch branch, bool) {
      curves = tube.curves(branch, section_, tracing_, [](const TubeCurve&) { return false; });
      if (!curves[0].complete) throw DataError("a tube does not reach the section as a closed curve");
    });
    measure_defects();
  }

  // Their images, as long as they meet no end of the well, which would tear the next one.
  void cut_images(int most) {
    std::array<std::vector<TubeCurve>, 2> ends;
    for (const Bottleneck& neck : list) {
      ends[0].push_back(neck.exit[0]);
      ends[1].push_back(neck.entry[0]);
    }
    for_each_tube([&](std::vector<TubeCurve>& curves, const Tube& tube, Branch branch, bool entry) {
      int done = 0;
      curves = tube.curves(branch, section_, tracing_, [&](const TubeCurve& curve) {
        if (curve.direction == 0) throw DataError("a tube crosses the section in both directions");
        if (done++ == most + 1) return false;  // one more, for a second split
        const auto& gates = ends[entry ? 0 : 1];
        return std::none_of(gates.begin(), gates.end(), [&](const TubeCurve& gate) {
          return gate.direction == curve.direction && common_area(curve.view(), gate.view()).area > 0;
        });
      });
      if (!curves.back().complete) curves.pop_back();
    });
    measure_defects();
    go_on_torn(most);
  }

  void report(const std::string& what) const { report_(what); }

 private:
  void go_on_torn(int most) {
    std::vector<NeckTubes> tubes(list.size());
    for (std::size_t k = 0; k < list.size(); ++k) {
      tubes[k] = {&*tubes_[2 * k],     &*tubes_[2 * k + 1],       list[k].entry_branch,
                  list[k].exit_branch, list[k].exit[0].direction, list[k].entry[0].direction};
    }
    TornOptions torn;
    torn.tracing = tracing_;
    torn.tracing.tolerance *= torn_coarseness;
    torn.most = most;
    torn.strip = options_.strip * least_area_;
    for_each_block(tubes_.size(), 1, [&](std::size_t k, std::size_t) {
      const bool entry = k % 2 == 0;
      std::vector<TubeCurve>& curves = entry ? list[k / 2].entry : list[k / 2].exit;
      const int level = static_cast<int>(curves.size()) - 1;
      if (level >= most) return;
      auto later = torn_images(flow_, section_, tubes, k / 2, entry, curves.back(), level, options_.integration, torn);
      std::move(later.begin(), later.end(), std::back_inserter(curves));
    });
  }

  void find_orbits(std::span<const FlowState> guesses, double energy) {
    if (guesses.empty()) throw UsageError("escape needs at least one saddle");
    report_("periodic orbits");
    const auto axis = static_cast<std::size_t>(section_.coordinate);
    IntegrationOptions exact = options_.integration;
    exact.tolerance = std::min(exact.tolerance, 3e-15);
    for (const FlowState& guess : guesses) {
      Bottleneck neck;
      neck.orbit = periodic_orbit(flow_, saddle_point(flow_, guess), energy, exact);
      for (const Bottleneck& other : list) {
        double distance = 0;
        for (std::size_t k = 0; k < 4; ++k) distance += std::fabs(other.orbit.state[k] - neck.orbit.state[k]);
        if (distance < 1e-9) throw UsageError("two of the saddles are one");
      }
      list.push_back(std::move(neck));
    }
    std::stable_sort(list.begin(), list.end(), [&](const Bottleneck& x, const Bottleneck& y) {
      return x.orbit.saddle.at[axis] < y.orbit.saddle.at[axis];
    });
  }

  void find_tubes() {
    report_("local manifolds");
    tubes_.resize(2 * list.size());
    for_each_block(tubes_.size(), 1, [&](std::size_t k, std::size_t) {
      Bottleneck& neck = list[k / 2];
      tubes_[k].emplace(flow_, neck.orbit, k % 2 == 0 ? Side::unstable : Side::stable, options_.integration);
      (k % 2 == 0 ? neck.entry_branch : neck.exit_branch) = tubes_[k]->branch_towards(section_);
    });
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Tube &entry = *tubes_[2 * k], &exit = *tubes_[2 * k + 1];
      list[k].area = entry.area_by_action(section_);
      list[k].multiplier = entry.local().multiplier;
      list[k].defect_across = std::max(entry.local().defect_across, exit.local().defect_across);
      least_area_ = std::min(least_area_, list[k].area);
    }
    tracing_.tolerance = options_.tolerance * std::sqrt(least_area_);
    tracing_.most_points = options_.most_points;
    tracing_.progress = [this] { return report_("tubes"), true; };
  }

  template <typename Body>
  void for_each_tube(const Body& body) {
    for_each_block(tubes_.size(), 1, [&](std::size_t k, std::size_t) {
      Bottleneck& neck = list[k / 2];
      if (k % 2 == 0) {
        body(neck.entry, *tubes_[k], neck.entry_branch, true);
      } else {
        body(neck.exit, *tubes_[k], neck.exit_branch, false);
      }
    });
  }

  void measure_defects() {
    for (Bottleneck& neck : list) {
      neck.area_defect = 0;
      for (const auto* curves : {&neck.entry, &neck.exit}) {
        for (const TubeCurve& curve : *curves) {
          if (!curve.complete) continue;
          neck.area_defect = std::max(neck.area_defect, std::fabs(curve.area / neck.area - 1));
        }
      }
    }
  }

  const Flow& flow_;
  Section section_;
  const EscapeOptions& options_;
  Reporter report_;
  std::vector<std::optional<Tube>> tubes_;
  TubeCurveOptions tracing_;
  double least_area_ = std::numeric_limits<double>::infinity();
};

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

// The bottlenecks of a well with their tubes, from which curves are cut (private to escape/).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/error.hpp"
#include "engine/escape/escape.hpp"
#include "engine/escape/torn_images.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/smooth/smooth.hpp"

namespace lober {

// Torn images are measured as polygons and end where a strip is cut off: they need not be as fine as whole ones.
inline constexpr double torn_coarseness = 10;

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
      tubes_[k].emplace(flow_, neck.orbit, k % 2 == 0 ? ManifoldSide::unstable : ManifoldSide::stable,
                        options_.integration);
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

}  // namespace lober

// The bottlenecks of a well with their tubes, from which curves are cut (private to escape/).
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/base/growth_forecast.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/base/quantities.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/base/text.hpp"
#include "engine/dynamics/escape/cut_images.hpp"
#include "lober/error.hpp"
#include "lober/escape.hpp"
#include "lober/smooth.hpp"

namespace lober::detail {

// Cut images are measured as polygons and end where a strip is cut off: they need not be as fine as whole ones.
inline constexpr double cut_coarseness = 10;
// Trajectories that are followed for each point of a curve: those that show where points are needed, and the points.
inline constexpr double evaluations_a_point = 2;

// What is under way: the number of the images, when all is expected to be done, by a watch, and the crossings that all
// curves may take.
struct EscapeWork {
  int images;
  double end;
  Stopwatch watch;
  double crossings_left = std::numeric_limits<double>::infinity();
};

// The middles of `count` equal parts of [0, 1].
template <std::size_t count>
std::array<double, count> middles() {
  std::array<double, count> u{};
  for (std::size_t k = 0; k < count; ++k) u[k] = (static_cast<double>(k) + 0.5) / count;
  return u;
}

// Tells what is being done, from whatever thread, one at a time.
class Reporter {
 public:
  explicit Reporter(const EscapeOptions& options) : options_(options) {}
  void begin(const EscapeWork& work) {
    work_ = work;
    (*this)("tubes");
  }
  void operator()(const std::string& what) const {
    if (!options_.progress) return;
    const std::lock_guard lock(mutex_);
    const double now = work_.watch.seconds();
    const double fraction = work_.end > 0 ? std::min(now / work_.end, 0.99) : 0;
    if (!options_.progress({what, fraction, work_.images})) {
      refused_ = true;
      throw Cancelled();
    }
  }
  /// Whether the caller's progress has said no.
  [[nodiscard]] bool refused() const { return refused_; }

 private:
  const EscapeOptions& options_;
  EscapeWork work_{};
  mutable std::mutex mutex_;
  mutable std::atomic<bool> refused_{false};
};

class Bottlenecks {
 public:
  Bottlenecks(const Flow& flow, const Section& cut_by, double energy, std::span<const FlowState> guesses,
              const EscapeOptions& options)
      : flow_(flow), section_(cut_by), options_(options), report_(options) {
    find_orbits(guesses, energy);
    require_off_section();
    find_tubes();
  }

  std::vector<Bottleneck> list;

  // Saddles below the energy that are none of these, by the coordinate across the section.
  [[nodiscard]] std::vector<SaddlePoint> also_open() const {
    std::vector<SaddlePoint> others = open_saddles();
    others.erase(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(list.size()));
    const auto axis = static_cast<std::size_t>(section_.coordinate);
    std::stable_sort(others.begin(), others.end(),
                     [&](const auto& x, const auto& y) { return x.at[axis] < y.at[axis]; });
    return others;
  }

  // E and X. A curve is closed only if every trajectory gets to the section: a few show before points are put in
  // vain next to those that do not, as beside a collision.
  void cut_first() {
    constexpr std::size_t samples = 512;
    for_each_tube([&](std::size_t k) {
      Carried& tube = carried_[k];
      std::array<FlowState, samples> states;
      tubes_[k]->crossings(tube.branch, section_, 1, middles<samples>(), states);
      if (!std::all_of(states.begin(), states.end(), [](const FlowState& x) { return std::isfinite(x[0]); })) {
        throw DataError(name_of_tube(k) + " does not reach the section as a closed curve. " + way_on());
      }
      tube.curves->push_back(tubes_[k]->curve(tube.branch, section_, 1, nullptr, tracing_));
      if (!tube.curves->back().complete) {
        throw DataError(name_of_tube(k) + " does not reach the section as a closed curve. " + way_on());
      }
    });
    measure_defects();
  }

  // One more image of every E and of every X that has fewer than so many: whole as long as the image before meets no
  // end of the well, which cuts the next one; cut ones only if asked for.
  void carry(int images, bool cut_too, const EscapeWork& work) {
    report_.begin(work);
    // One may need more than the others do: half of what is left for each pair of them.
    const double for_one = 2 * work.crossings_left / static_cast<double>(carried_.size());
    const double affordable = std::max(for_one / (evaluations_a_point * (images + 1)), 2.0);
    const bool fewer = affordable < static_cast<double>(options_.max_points);
    tracing_.max_points = fewer ? static_cast<std::size_t>(affordable) : options_.max_points;
    if (ends_.empty()) find_ends();
    for_each_tube([&](std::size_t k) {
      if (static_cast<int>(carried_[k].curves->size()) <= images) carry_one(k, cut_too);
    });
    measure_defects();
    for (std::size_t k = 0; k < carried_.size(); ++k) require_in_well(k);
  }

  // What the next images are expected to need: points of the largest one, crossings of trajectories of all.
  struct Ahead {
    double points = 0, crossings = 0;
  };
  // Whole images grow by a factor much like the one before. Cut ones do not, but how many trajectories one takes to
  // begin with shows once the image before it is cut, which is done here if they are wanted.
  [[nodiscard]] Ahead look_ahead(int images, bool cut_too) {
    if (ends_.empty()) find_ends();
    std::vector<double> points(carried_.size(), 0);
    for_each_tube([&](std::size_t k) {
      Carried& tube = carried_[k];
      if (static_cast<int>(tube.curves->size()) > images || tube.ended) return;
      const TubeCurve& last = tube.curves->back();
      if (last.direction == 0) throw DataError("a tube crosses the section in both directions");
      const bool cut = tube.cutting != nullptr || meets_an_end(last, k % 2 == 0);
      if (cut && !cut_too) return;
      if (cut) {
        if (tube.cutting == nullptr) begin_cutting(k);
        points[k] = static_cast<double>(tube.cutting->prepare());
      } else {
        GrowthForecast forecast;
        for (const TubeCurve& curve : *tube.curves) forecast.add(static_cast<double>(curve.image.points.size()));
        points[k] = forecast.next();
      }
    });
    Ahead ahead;
    for (const double here : points) {
      ahead.points = std::max(ahead.points, here);
      ahead.crossings += evaluations_a_point * here * (images + 1);
    }
    return ahead;
  }
  // Crossings of trajectories that were followed for the curves so far.
  [[nodiscard]] double crossings_so_far() const {
    double sum = 0;
    for (const Carried& tube : carried_) {
      for (std::size_t k = 0; k < tube.curves->size(); ++k) {
        sum += static_cast<double>((*tube.curves)[k].image.images) * static_cast<double>(k + 1);
      }
    }
    return sum;
  }

  [[noreturn]] void throw_outside() const {
    throw DataError("no trajectory comes back to the section, which lies outside of the well. " + way_on());
  }

  // Whether the caller's progress has cancelled.
  [[nodiscard]] bool refused() const { return report_.refused(); }

  // Whether what limits the points of curves is the work that they take.
  [[nodiscard]] bool out_of_work() const { return tracing_.max_points < options_.max_points; }
  // Whether a tube could not be carried on because that takes too many points.
  [[nodiscard]] bool out_of_points() const {
    return std::any_of(carried_.begin(), carried_.end(), [](const Carried& tube) { return tube.out_of_points; });
  }

 private:
  // What has been cut from a tube.
  struct Carried {
    std::vector<TubeCurve>* curves;
    Branch branch;
    std::unique_ptr<CutImages> cutting;         // once one is cut
    bool ended = false, out_of_points = false;  // the next one cannot be found
  };

  // E and X of every bottleneck, and what cut images need.
  void find_ends() {
    for (const Bottleneck& bottleneck : list) {
      exits_.push_back(bottleneck.exit[0]);
      entries_.push_back(bottleneck.entry[0]);
    }
    for (std::size_t k = 0; k < list.size(); ++k) {
      ends_.push_back({&*tubes_[2 * k], &*tubes_[2 * k + 1], list[k].entry_branch, list[k].exit_branch,
                       list[k].exit[0].direction, list[k].entry[0].direction});
    }
  }

  // A tube whose image is far larger than the flow allows, and all of whose trajectories are lost, does not enter the
  // well: the section has met its branch on the other side of the bottleneck first.
  void require_in_well(std::size_t k) const {
    const Carried& tube = carried_[k];
    const Bottleneck& bottleneck = list[k / 2];
    const TubeCurve& last = tube.curves->back();
    if (tube.curves->size() < 2 || !last.complete || last.area < 2 * bottleneck.area) return;
    constexpr std::size_t samples = 64;
    std::array<FlowState, samples> states;
    tubes_[k]->begin(tube.branch, middles<samples>(), states);
    const double time = (k % 2 == 0 ? 1 : -1) * options_.integration.max_time;
    flow_.integrate(states, 0, time, options_.integration);
    if (std::any_of(states.begin(), states.end(), [](const FlowState& x) { return std::isfinite(x[0]); })) return;
    throw DataError(name_of_tube(k) + " runs to infinity: its image " + std::to_string(tube.curves->size() - 1) +
                    " has the area " + format_rounded(last.area) + " instead of " + format_rounded(bottleneck.area) +
                    ", and all of " + std::to_string(samples) + " trajectories are lost. " + way_on());
  }

  // Of tube k: "the unstable tube of the bottleneck (1, 0.5)".
  [[nodiscard]] std::string name_of_tube(std::size_t k) const {
    return std::string(k % 2 == 0 ? "the unstable" : "the stable") + " tube of the bottleneck " +
           name_of_saddle(list[k / 2].orbit.saddle);
  }

  // What to do where the section or the saddles do not serve.
  [[nodiscard]] std::string way_on() const {
    const std::vector<SaddlePoint> open = open_saddles();
    std::string names;
    for (const SaddlePoint& saddle : open) names += (names.empty() ? "" : ", ") + name_of_saddle(saddle);
    return "The energy " + format_number(list[0].orbit.energy) + " is above that of " + std::to_string(open.size()) +
           (open.size() == 1 ? " saddle, " : " saddles, ") + names + "; give " + std::string(quantity::saddles) +
           ", and " + std::string(quantity::section) + " that none of their orbits meets";
  }

  // Those of rank 1 below the energy, of Newton's method from a grid about the named ones: a help for a message.
  [[nodiscard]] std::vector<SaddlePoint> open_saddles() const {
    constexpr int cells = 8;
    double reach = 0;
    const auto q = [&](const SaddlePoint& saddle, std::size_t k) {
      return saddle.at[static_cast<std::size_t>(flow_.conjugate_pairs()[k].q)];
    };
    std::vector<SaddlePoint> found;
    const auto add = [&](const SaddlePoint& saddle) {
      const bool known = std::any_of(found.begin(), found.end(), [&](const SaddlePoint& other) {
        return std::hypot(q(other, 0) - q(saddle, 0), q(other, 1) - q(saddle, 1)) < 1e-6 * (1 + reach);
      });
      if (!known && saddle.energy < list[0].orbit.energy) found.push_back(saddle);
    };
    for (const Bottleneck& bottleneck : list) {
      add(bottleneck.orbit.saddle);
      for (const std::size_t k : {0U, 1U}) reach = std::max(reach, 1.5 * std::fabs(q(bottleneck.orbit.saddle, k)));
    }
    for (int i = 0; i <= cells; ++i) {
      for (int j = 0; j <= cells; ++j) {
        FlowState guess{};
        guess[static_cast<std::size_t>(flow_.conjugate_pairs()[0].q)] = reach * (2.0 * i / cells - 1);
        guess[static_cast<std::size_t>(flow_.conjugate_pairs()[1].q)] = reach * (2.0 * j / cells - 1);
        try {
          add(saddle_point(flow_, guess));
        } catch (const Error&) {  // no saddle of rank 1 is near
        }
      }
    }
    return found;
  }

  void carry_one(std::size_t k, bool cut_too) {
    Carried& tube = carried_[k];
    if (tube.ended) return;
    const int images = static_cast<int>(tube.curves->size());
    const TubeCurve& last = tube.curves->back();
    if (tube.cutting == nullptr) {
      if (last.direction == 0) throw DataError("a tube crosses the section in both directions");
      if (!meets_an_end(last, k % 2 == 0)) {
        TubeCurve next = tubes_[k]->curve(tube.branch, section_, images + 1, &last, tracing_);
        tube.out_of_points = next.image.stop == GrowthStop::points;
        tube.ended = tube.out_of_points;
        if (next.complete) tube.curves->push_back(std::move(next));
        if (tube.ended || static_cast<int>(tube.curves->size()) > images) return;
      }
      if (!cut_too) return;
      begin_cutting(k);
    }
    if (!cut_too) return;
    std::optional<TubeCurve> next = tube.cutting->next();
    if (next) {
      tube.curves->push_back(std::move(*next));
    } else {
      tube.ended = true;
      tube.out_of_points = tube.cutting->out_of_points();
    }
  }

  // Its images are cut from the next one on.
  void begin_cutting(std::size_t k) {
    Carried& tube = carried_[k];
    try {
      tube.cutting = std::make_unique<CutImages>(flow_, section_, ends_, k / 2, k % 2 == 0, tube.curves->back(),
                                                 static_cast<int>(tube.curves->size()) - 1, options_.integration,
                                                 cut_image_options());
    } catch (const DataError& error) {
      throw DataError(std::string(error.what()) + ". " + way_on());
    }
  }

  [[nodiscard]] bool meets_an_end(const TubeCurve& curve, bool entry) const {
    const std::vector<TubeCurve>& ends = entry ? exits_ : entries_;
    return std::any_of(ends.begin(), ends.end(), [&](const TubeCurve& exit) {
      return exit.direction == curve.direction && common_area(curve.view(), exit.view()).area > 0;
    });
  }

  [[nodiscard]] CutImageOptions cut_image_options() const {
    CutImageOptions cut;
    cut.tracing = tracing_;
    cut.tracing.tolerance *= cut_coarseness;
    cut.strip = options_.strip * least_area_;
    cut.area = least_area_;
    return cut;
  }

  static std::string name_of_saddle(const SaddlePoint& saddle) {
    const double scale = std::hypot(saddle.at[0], saddle.at[1]);
    const auto text = [&](double x) { return format_rounded(std::fabs(x) < 1e-12 * scale ? 0 : x, 6); };
    return "(" + text(saddle.at[0]) + ", " + text(saddle.at[1]) + ")";
  }

  // All bottlenecks are open, or there is nothing to escape by.
  static void require_energy_above(std::span<const SaddlePoint> saddles, double energy) {
    const auto highest = std::max_element(saddles.begin(), saddles.end(),
                                          [](const auto& x, const auto& y) { return x.energy < y.energy; });
    if (energy > highest->energy && std::isfinite(energy)) return;
    std::string below;
    for (const SaddlePoint& saddle : saddles) {
      if (energy > saddle.energy) below += (below.empty() ? "" : ", ") + name_of_saddle(saddle);
    }
    throw UsageError("the energy " + format_number(energy) + " is not above that of the saddle " +
                     name_of_saddle(*highest) + ", " + format_number(highest->energy) +
                     ", so that the bottleneck there is closed; energies from about " + text_of_least(*highest) +
                     " on can be used" +
                     (below.empty() ? "" : "; open are " + below + ": give " + std::string(quantity::saddles)));
  }

  // Orbits shrink with the square root of the energy above the saddle, which is a difference of rounded numbers.
  static double least_energy(const SaddlePoint& saddle) {
    constexpr double least_excess = 1e-7;
    return saddle.energy + least_excess * (1 + std::fabs(saddle.energy));
  }
  static std::string text_of_least(const SaddlePoint& saddle) { return format_rounded(least_energy(saddle), 9); }
  // What fails near a saddle's energy fails because of that.
  template <typename Function>
  static void near_saddle(const SaddlePoint& saddle, double energy, const Function& function) {
    try {
      function();
    } catch (const DataError& error) {
      const double least = least_energy(saddle);
      throw DataError("at the energy " + format_number(energy) + ", " + format_rounded(energy - saddle.energy) +
                      " above that of the saddle " + name_of_saddle(saddle) + ", " + format_number(saddle.energy) +
                      ": " + error.what() +
                      (energy < least ? "; orbits so near to the saddle are lost in rounding: energies from about " +
                                            text_of_least(saddle) + " on can be used"
                                      : ""));
    }
  }

  void find_orbits(std::span<const FlowState> guesses, double energy) {
    if (guesses.empty()) throw UsageError("escape needs at least one saddle");
    report_("periodic orbits");
    const auto axis = static_cast<std::size_t>(section_.coordinate);
    IntegrationOptions exact = options_.integration;
    exact.tolerance = std::min(exact.tolerance, 3e-15);
    std::vector<SaddlePoint> saddles;
    for (const FlowState& guess : guesses) saddles.push_back(saddle_point(flow_, guess));
    require_energy_above(saddles, energy);
    for (const SaddlePoint& saddle : saddles) {
      Bottleneck bottleneck;
      near_saddle(saddle, energy, [&] { bottleneck.orbit = periodic_orbit(flow_, saddle, energy, exact); });
      for (const Bottleneck& other : list) {
        double distance = 0;
        for (std::size_t k = 0; k < 4; ++k) distance += std::fabs(other.orbit.state[k] - bottleneck.orbit.state[k]);
        if (distance < 1e-9) throw UsageError("two of the saddles are one");
      }
      list.push_back(std::move(bottleneck));
    }
    std::stable_sort(list.begin(), list.end(), [&](const Bottleneck& x, const Bottleneck& y) {
      return x.orbit.saddle.at[axis] < y.orbit.saddle.at[axis];
    });
  }

  // Trajectories beside an orbit that crosses the section cross it too, turn after turn: their crossings do not count
  // what enters the well.
  void require_off_section() const {
    constexpr std::size_t samples = 128;
    const auto across = static_cast<std::size_t>(section_.coordinate);
    const auto counts = [&](const FlowState& state) {
      return section_.bound_side == 0 ||
             section_.bound_side * (state[static_cast<std::size_t>(section_.bound_coordinate)] - section_.bound) > 0;
    };
    for (const Bottleneck& bottleneck : list) {
      const std::vector<FlowState> states = states_along(flow_, bottleneck.orbit, samples, options_.integration);
      for (std::size_t k = 0; k < states.size(); ++k) {
        const FlowState &here = states[k], &next = states[(k + 1) % states.size()];
        if ((here[across] < section_.value) == (next[across] < section_.value) || !counts(here)) continue;
        throw DataError("the section cuts the periodic orbit of the bottleneck " +
                        name_of_saddle(bottleneck.orbit.saddle) +
                        ", and trajectories beside that orbit cross it turn after turn. " + way_on());
      }
    }
  }

  void find_tubes() {
    report_("local manifolds");
    tubes_.resize(2 * list.size());
    std::vector<std::exception_ptr> failures(tubes_.size());  // the first one counts, whatever failed earlier
    for_each_block(tubes_.size(), 1, [&](std::size_t k, std::size_t) {
      Bottleneck& bottleneck = list[k / 2];
      try {
        near_saddle(bottleneck.orbit.saddle, bottleneck.orbit.energy, [&] {
          tubes_[k].emplace(flow_, bottleneck.orbit, k % 2 == 0 ? ManifoldSide::unstable : ManifoldSide::stable,
                            options_.integration);
        });
        const std::optional<Branch> towards = tubes_[k]->branch_towards(section_);
        if (!towards) {
          throw DataError("neither branch of " + name_of_tube(k) + " reaches the section as a closed curve. " +
                          way_on());
        }
        (k % 2 == 0 ? bottleneck.entry_branch : bottleneck.exit_branch) = *towards;
      } catch (const DataError&) {
        failures[k] = std::current_exception();
      }
    });
    for (const std::exception_ptr& failure : failures) {
      if (failure) std::rethrow_exception(failure);
    }
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Tube &entry = *tubes_[2 * k], &exit = *tubes_[2 * k + 1];
      list[k].area = entry.area_by_action(section_);
      list[k].area_error = list[k].area * list[k].orbit.action_error / std::fabs(list[k].orbit.action);
      list[k].multiplier = entry.local().multiplier;
      list[k].defect_across = std::max(entry.local().defect_across, exit.local().defect_across);
      least_area_ = std::min(least_area_, list[k].area);
    }
    for (std::size_t k = 0; k < tubes_.size(); ++k) {
      Bottleneck& bottleneck = list[k / 2];
      carried_.push_back({k % 2 == 0 ? &bottleneck.entry : &bottleneck.exit,
                          k % 2 == 0 ? bottleneck.entry_branch : bottleneck.exit_branch, nullptr, false});
    }
    tracing_.tolerance = options_.tolerance * std::sqrt(least_area_);
    tracing_.max_points = options_.max_points;
    tracing_.progress = [this] { return report_("tubes"), true; };
  }

  // Calls body(k) for tube k = 2 * bottleneck + (0: unstable, 1: stable), in parallel.
  template <typename Body>
  void for_each_tube(const Body& body) {
    for_each_block(carried_.size(), 1, [&](std::size_t k, std::size_t) { body(k); });
  }

  void measure_defects() {
    for (Bottleneck& bottleneck : list) {
      bottleneck.area_defect = 0;
      for (const auto* curves : {&bottleneck.entry, &bottleneck.exit}) {
        for (const TubeCurve& curve : *curves) {
          if (!curve.complete) continue;
          bottleneck.area_defect = std::max(bottleneck.area_defect, std::fabs(curve.area / bottleneck.area - 1));
        }
      }
    }
  }

  const Flow& flow_;
  Section section_;
  const EscapeOptions& options_;
  Reporter report_;
  std::vector<std::optional<Tube>> tubes_;
  std::vector<Carried> carried_;
  std::vector<TubeCurve> entries_, exits_;  // E and X of all
  std::vector<BottleneckTubes> ends_;
  TubeCurveOptions tracing_;
  double least_area_ = std::numeric_limits<double>::infinity();
};

}  // namespace lober::detail

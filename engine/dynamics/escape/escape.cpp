#include "lober/transport/escape.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <tuple>

#include "engine/base/growth_forecast.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/base/quantities.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/base/text.hpp"
#include "engine/base/time_limit.hpp"
#include "engine/dynamics/escape/bottlenecks.hpp"
#include "engine/dynamics/escape/symmetries.hpp"
#include "engine/dynamics/escape/winding_product.hpp"
#include "lober/base/error.hpp"

namespace lober {
using namespace detail;
namespace {

// Work that was expected to end within the budget and does not is broken off at this many of it: with what still runs
// then, less than a tenth beyond.
constexpr double beyond_budget = 1.05;
// Orbits and first curves may take these seconds whatever the budget, as there is nothing to say before; and no more
// without one, where trajectories next to a collision take a thousand times as long as others.
constexpr double first_seconds = 5, first_seconds_without_budget = 60;
// The work for a point where cut curves cross themselves or each other, in evaluations of the vector field:
// 20 to 60 were measured (capsize at energies from 0.26 to 0.5).
constexpr double work_a_node = 50;

// The seconds after which work is broken off.
double last_second(const EscapeOptions& options) {
  return beyond_budget * seconds_of(options.budget);
}

// Does the work before the first row. Throws DataError when it takes too long.
void within_first_limit(const Stopwatch& watch, const EscapeOptions& options, const std::function<void()>& function) {
  const double seconds =
      options.budget > 0 ? std::max(last_second(options), first_seconds) : first_seconds_without_budget;
  if (done_within(watch, seconds, function)) return;
  throw DataError("escape: the periodic orbits and the first curves of their tubes were not found within " +
                  format_rounded(seconds) + " s; a larger tolerance of curves needs fewer points, a larger " +
                  std::string(quantity::seconds) + " allows more");
}

class EscapeBuilder {
 public:
  EscapeBuilder(const Flow& flow, const Section& section, double energy, const EscapeOptions& options)
      : flow_(flow), options_(options) {
    result_.energy = energy;
    result_.section = section;
  }

  Escape build(std::span<const FlowState> guesses) {
    Section either = result_.section;
    either.direction = 0;
    std::optional<Bottlenecks> tubes;
    within_first_limit(watch_, options_, [&] {
      tubes.emplace(flow_, either, result_.energy, guesses, options_);
      result_.also_open = tubes->also_open();
      const Stopwatch watch;
      tubes->cut_first();
      carrying_ = watch.seconds();
      cost_.add(carrying_);
      crossings_ = tubes->crossings_so_far();
      followed_ = tubes->work_so_far();
    });
    Bottlenecks& bottlenecks = *tubes;
    const TimeLimit limit(watch_, last_second(options_));
    try {
      const CancellationScope limited(limit.flag());
      for (int n = 1; n <= options_.crossings && result_.stop == EscapeStop::done; ++n) go_on(bottlenecks, n);
      // One more whole image gives the longest times of the last rows a second split.
      const int more = options_.crossings + 1;
      if (result_.stop == EscapeStop::done && reason_not_to(bottlenecks, more) == EscapeStop::done) {
        bottlenecks.carry(more, false, work(more));
        with_curves(bottlenecks, [&] {
          measure();
          compare();
        });
      }
    } catch (const Cancelled&) {
      keep_what_is_known(bottlenecks, limit.passed() && !is_cancelled() && !bottlenecks.refused());
    }
    if (result_.bottlenecks.empty()) result_.bottlenecks = std::move(bottlenecks.list);
    return std::move(result_);
  }

 private:
  // After work was ended where it was: by the budget, or by the caller, to whom nothing is due before the first row.
  void keep_what_is_known(Bottlenecks& bottlenecks, bool by_budget) {
    if (!by_budget && result_.crossings == 0) throw Cancelled();
    const CancellationScope shield(CancellationScope::Shield{});
    if (result_.bottlenecks.empty()) std::swap(bottlenecks.list, result_.bottlenecks);
    std::erase_if(result_.table, [&](const EscapeFraction& row) { return row.crossings > result_.crossings; });
    compare();
    // A second split of the last rows is more than was asked for.
    const bool complete = by_budget && result_.crossings == options_.crossings;
    result_.stop = complete ? EscapeStop::done : by_budget ? EscapeStop::budget : EscapeStop::cancelled;
    result_.seconds_spent = watch_.seconds();
    result_.seconds_ahead = 0;
  }

  // One more image of everything, and the rows of n that it makes known, if that is affordable.
  void go_on(Bottlenecks& bottlenecks, int n) {
    result_.stop = reason_not_to(bottlenecks, n);
    if (result_.stop != EscapeStop::done) return;
    const Stopwatch watch;
    bottlenecks.carry(n, true, work(n));
    const double carried = watch.seconds();
    cost_.add(carried);
    const double before = std::exchange(crossings_, bottlenecks.crossings_so_far());
    newest_crossings_ = crossings_ - before;
    followed_ = bottlenecks.work_so_far();
    carrying_ += carried;
    const Stopwatch measuring;
    bool nothing = false;  // comes back
    const auto is_known = [](const EscapeFraction& row) { return row.is_known(); };
    with_curves(bottlenecks, [&] {
      lay_out_rows(n);
      newest_measured_ = measure();
      measured_ += newest_measured_;
      result_.crossings = n;
      compare();
      measuring_ = measuring.seconds();
      nothing = n == 1 && !bottlenecks.out_of_points() && !bottlenecks.out_of_work() &&
                std::none_of(result_.table.begin(), result_.table.end(), is_known);
      if (options_.rows_known && !nothing) options_.rows_known(result_, n);
    });
    if (nothing) bottlenecks.throw_outside();
    const bool known = std::all_of(result_.table.begin(), result_.table.end(), is_known);
    if (known) return;
    result_.stop = bottlenecks.out_of_work()     ? EscapeStop::work
                   : bottlenecks.out_of_points() ? EscapeStop::points
                                                 : EscapeStop::lost;
    if (result_.stop == EscapeStop::work) result_.work_ahead = 0;
  }

  // `done` when the images of this number may be made: what following trajectories has taken by crossing, and measuring
  // by the size of the curves, is what the next ones are expected to take.
  EscapeStop reason_not_to(Bottlenecks& bottlenecks, int images) {
    const Bottlenecks::Ahead ahead = bottlenecks.look_ahead(images, images <= options_.crossings, work_left());
    followed_ = bottlenecks.work_so_far();
    const double so_far = watch_.seconds();
    const double crossings = std::max(crossings_, 1.0);
    double seconds = ahead.crossings * carrying_ / crossings, work = ahead.crossings * followed_ / crossings;
    if (newest_crossings_ > 0) {
      const double growth = std::max(1.0, ahead.crossings / newest_crossings_);
      seconds += measuring_ * growth;
      work += newest_measured_ * growth;
    }
    if (images <= options_.crossings) {
      result_.work_spent = followed_ + measured_;
      result_.work_ahead = ahead.too_much ? 0 : work;
      result_.points_ahead = ahead.points;
      result_.seconds_ahead = seconds;
      result_.seconds_spent = so_far;
    }
    if (ahead.too_much) return EscapeStop::work;
    if (ahead.points > static_cast<double>(options_.max_points)) return EscapeStop::points;
    if (options_.budget > 0) return so_far + seconds > options_.budget ? EscapeStop::budget : EscapeStop::done;
    return followed_ + measured_ + work > options_.max_work ? EscapeStop::work : EscapeStop::done;
  }

  // The progress report while images of this number are made.
  [[nodiscard]] EscapeWork work(int images) const {
    const int left = std::max(1, options_.crossings + 1 - images);
    return {watch_.seconds() + cost_.sum(left), watch_, work_left()};
  }

  [[nodiscard]] double work_left() const {
    return options_.budget > 0 ? std::numeric_limits<double>::infinity() : options_.max_work - followed_ - measured_;
  }

  // The curves belong to the result while `function` runs.
  template <typename Function>
  void with_curves(Bottlenecks& bottlenecks, const Function& function) {
    std::swap(bottlenecks.list, result_.bottlenecks);
    function();
    std::swap(bottlenecks.list, result_.bottlenecks);
  }

  // Directions alternate, so that m fixes where a trajectory is and n.
  void lay_out_rows(int wanted) {
    const auto& bottlenecks = result_.bottlenecks;
    for (std::size_t i = 0; i < bottlenecks.size(); ++i) {
      const int start = bottlenecks[i].entry[0].direction;
      for (std::size_t j = 0; j < bottlenecks.size(); ++j) {
        int n = 0;
        for (int m = 0;; ++m) {
          const int here = m % 2 == 0 ? start : -start;
          n += here == result_.section.direction;
          if (n > wanted) break;
          if (n != wanted || here != bottlenecks[j].exit[0].direction) continue;
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

  // Measures the rows that the curves determine and that have not been reported yet. Returns the work.
  double measure() {
    std::atomic<std::uint64_t> nodes = 0;
    for_each_block(result_.table.size(), 1, [&](std::size_t k, std::size_t) { measure(result_.table[k], nodes); });
    return static_cast<double>(nodes) * work_a_node;
  }

  struct Split {
    int forward;
    int cut;
    std::size_t points;
  };

  // Those with the fewest cut curves first, then those with the fewest points.
  [[nodiscard]] std::vector<Split> splits_of(const EscapeFraction& row) const {
    const auto &entries = result_.bottlenecks[row.entry].entry, &exits = result_.bottlenecks[row.exit].exit;
    std::vector<Split> splits;
    for (int a = 0; a <= row.iterates; ++a) {
      const auto forward = static_cast<std::size_t>(a), backward = static_cast<std::size_t>(row.iterates - a);
      if (forward >= entries.size() || backward >= exits.size()) continue;
      const TubeCurve &first = entries[forward], &second = exits[backward];
      splits.push_back({a, first.cut + second.cut, first.image.points.size() + second.image.points.size()});
    }
    std::stable_sort(splits.begin(), splits.end(), [](const Split& x, const Split& y) {
      return x.cut != y.cut ? x.cut < y.cut : x.points < y.points;
    });
    return splits;
  }

  // The fraction by one split, and its error bar.
  [[nodiscard]] CommonArea fraction(const EscapeFraction& row, int forward, std::atomic<std::uint64_t>& nodes) const {
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

  void measure(EscapeFraction& row, std::atomic<std::uint64_t>& nodes) const {
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

  void compare() {
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
  }

  // No more leaves than has entered: tubes that the section meets along the flow, or more than once on their way from
  // one crossing to the next, give fractions that overlap.
  void compare_sums(Agreement& agreement) const {
    for (std::size_t entry = 0; entry < result_.bottlenecks.size(); ++entry) {
      for (const Survival& step : survival(result_, entry)) {
        const double left = 1 - step.remains;
        agreement.compare({"the fraction from bottleneck " + std::to_string(entry + 1) +
                               " that has left after crossing " + std::to_string(step.crossings),
                           "the sum of all", "what has entered", left, std::min(left, 1.0), step.error});
      }
    }
  }

  static std::string split_text(int forward, int backward) {
    return std::to_string(forward) + " + " + std::to_string(backward);
  }

  // The fraction that the symmetry makes of this one, unless it is the same or comes earlier.
  void compare_by(const EscapeSymmetry& symmetry, const EscapeFraction& row, Agreement& agreement) const {
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

  const Flow& flow_;
  const EscapeOptions& options_;
  Escape result_;
  Stopwatch watch_;
  GrowthForecast cost_;  // seconds by the clock for each number of images
  // Seconds and work that following trajectories has taken, and for how many crossings; of the newest images, their
  // crossings and what measuring them took, in seconds and as work; and the work of measuring all.
  double carrying_ = 0, followed_ = 0, crossings_ = 0, newest_crossings_ = 0, measuring_ = 0, newest_measured_ = 0,
         measured_ = 0;
  std::optional<std::vector<EscapeSymmetry>> symmetries_;
};

}  // namespace

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

std::vector<Bottleneck> bottlenecks(const Flow& flow, const Section& section, double energy,
                                    std::span<const FlowState> saddles, const EscapeOptions& options) {
  if (!(options.tolerance > 0)) throw UsageError("escape: the tolerance has to be positive");
  Section known = position_section(flow, section.coordinate, section.value, section.direction);
  known.bound_coordinate = section.bound_coordinate;
  known.bound = section.bound;
  known.bound_side = section.bound_side;
  const Stopwatch watch;
  std::vector<Bottleneck> list;
  within_first_limit(watch, options, [&] {
    Bottlenecks bottlenecks(flow, known, energy, saddles, options);
    bottlenecks.cut_first();
    list = std::move(bottlenecks.list);
  });
  return list;
}

Escape escape(const Flow& flow, const Section& section, double energy, std::span<const FlowState> saddles,
              const EscapeOptions& options) {
  if (options.crossings < 1) throw UsageError("escape takes at least one crossing");
  if (!(options.tolerance > 0)) throw UsageError("escape: the tolerance has to be positive");
  if (section.direction == 0) throw UsageError("escape counts crossings in one direction: the section needs one");
  if (section.bound_side != 0) throw UsageError("escape takes only sections without a bound");
  const Section whole = position_section(flow, section.coordinate, section.value, section.direction);
  return EscapeBuilder(flow, whole, energy, options).build(saddles);
}

std::vector<Survival> survival(const Escape& result, std::size_t entry) {
  std::vector<Survival> steps;
  Survival sum;
  sum.left.assign(result.bottlenecks.size(), 0);
  for (int n = 1;; ++n) {
    bool any = false;
    for (const EscapeFraction& part : result.table) {
      if (part.entry != entry || part.crossings != n) continue;
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

// Escape, image by image: tubes are carried on as far as that is affordable, and the table grows with them.
#include "lober/transport/escape.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "engine/base/growth_forecast.hpp"
#include "engine/base/quantities.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/base/text.hpp"
#include "engine/base/time_limit.hpp"
#include "engine/dynamics/escape/bottlenecks.hpp"
#include "engine/dynamics/escape/fraction_table.hpp"
#include "lober/base/cancellation.hpp"
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
      : flow_(flow), options_(options), table_(flow, result_) {
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
          table_.measure();
          table_.compare();
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
    table_.compare();
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
      table_.lay_out_rows(n);
      newest_measured_ = table_.measure();
      measured_ += newest_measured_;
      result_.crossings = n;
      table_.compare();
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

  const Flow& flow_;
  const EscapeOptions& options_;
  Escape result_;
  FractionTable table_;
  Stopwatch watch_;
  GrowthForecast cost_;  // seconds by the clock for each number of images
  // Seconds and work that following trajectories has taken, and for how many crossings; of the newest images, their
  // crossings and what measuring them took, in seconds and as work; and the work of measuring all.
  double carrying_ = 0, followed_ = 0, crossings_ = 0, newest_crossings_ = 0, measuring_ = 0, newest_measured_ = 0,
         measured_ = 0;
};

}  // namespace

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

}  // namespace lober

#include "engine/dynamics/transport/sweep/sweep_zero.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace lober::detail {
namespace {

// The end of a refinement at a value that has no difference.
struct NoDifference {};

class Refinement {
 public:
  Refinement(const Family& family, const SweepValue& first, const SweepValue& last, double tolerance,
             const std::function<SweepValue(double)>& row_at)
      : family_(family), row_at_(row_at), tolerance_(tolerance) {
    zero_.low = first.row.value;
    zero_.high = last.row.value;
    low_ = from_ = {first.row.value, first.row.difference};
    high_ = to_ = {last.row.value, last.row.difference};
    if (low_.value > high_.value) {
      std::swap(low_, high_);
      std::swap(from_, to_);
    }
    for (const SweepValue* const end : {&first, &last}) {
      if (end->known) known_.emplace_back(end->row.value, *end->known);
    }
    resolved_ = std::numeric_limits<double>::epsilon() * (high_.value - low_.value);
  }

  SweepZero run() {
    solve(true);
    if (zero_.failure.empty() && !is_confirmed()) {
      low_ = from_;
      high_ = to_;
      solve(false);
    }
    // Ends closer than asked for differ by what the integration leaves, no longer by the zero.
    zero_.width = std::max({high_.value - low_.value, 0.25 * tolerance_ * std::fabs(zero_.value), resolved_});
    const double least_end = std::min(std::fabs(from_.difference), std::fabs(to_.difference));
    if (zero_.failure.empty() && std::fabs(zero_.difference) > 0.1 * least_end) {
      zero_.failure = "the difference jumps there: it belongs to other pips on either side";
    }
    return std::move(zero_);
  }

 private:
  struct End {
    double value, difference;
  };

  // Uses the method of Alefeld, Potra & Shi (1995), TOMS 748, which never gives up the bracket.
  void solve(bool continuing) {
    const auto difference_at = [&](double value) {
      const double difference = continuing ? continued(value) : from_scratch(value);
      if (difference * low_.difference >= 0) low_ = {value, difference};
      if (difference * high_.difference >= 0) high_ = {value, difference};
      return difference;
    };
    const auto narrow = [&](double a, double b) {
      return b - a <= std::max(tolerance_ * std::max(std::fabs(a), std::fabs(b)), resolved_);
    };
    std::uintmax_t max_evaluations = 60;
    try {
      boost::math::tools::toms748_solve(difference_at, from_.value, to_.value, from_.difference, to_.difference, narrow,
                                        max_evaluations);
    } catch (const NoDifference&) {  // the bracket is what it was
    }
    const End& nearer = std::fabs(low_.difference) <= std::fabs(high_.difference) ? low_ : high_;
    zero_.value = nearer.value;
    zero_.difference = nearer.difference;
  }

  double from_scratch(double value) {
    SweepValue found = row_at_(value);
    ++zero_.evaluations;
    if (!found.row.failure.empty() || std::isnan(found.row.difference)) {
      zero_.failure = found.row.failure;
      throw NoDifference();
    }
    scratch_.push_back({value, found.row.difference});
    if (found.known) known_.emplace_back(value, *std::move(found.known));
    return found.row.difference;
  }

  // The difference, continued from the nearest value that is known.
  double continued(double value) {
    const auto nearest = std::min_element(known_.begin(), known_.end(), [&](const auto& a, const auto& b) {
      return std::fabs(a.first - value) < std::fabs(b.first - value);
    });
    if (nearest == known_.end()) return from_scratch(value);
    std::optional<KnownTurnstile> found = continued_to(family_, value, nearest->second, value - nearest->first);
    const std::optional<double> difference = found ? found->difference() : std::nullopt;
    if (!difference) return from_scratch(value);
    ++zero_.evaluations;
    known_.emplace_back(value, *std::move(found));
    return *difference;
  }

  // Whether a tangle that is grown at the zero has the same difference.
  bool is_confirmed() {
    const auto is_there = [&](const End& end) { return end.value == zero_.value; };
    if (is_there(from_) || is_there(to_) || std::any_of(scratch_.begin(), scratch_.end(), is_there)) return true;
    const double error = std::find_if(known_.begin(), known_.end(), [&](const auto& k) {
                           return k.first == zero_.value;
                         })->second.error();
    const double difference = zero_.difference;
    try {
      zero_.difference = from_scratch(zero_.value);
    } catch (const NoDifference&) {
      return true;  // the failure says it
    }
    const double slack = 4 * error + 1e-9 * std::min(std::fabs(from_.difference), std::fabs(to_.difference));
    return std::fabs(zero_.difference - difference) <= slack;
  }

  const Family& family_;
  const std::function<SweepValue(double)>& row_at_;
  double tolerance_;
  double resolved_ = 0;  // what rounding of the difference leaves of the interval, also about a zero that is 0
  SweepZero zero_;
  End from_{}, to_{}, low_{}, high_{};
  std::vector<End> scratch_;
  std::vector<std::pair<double, KnownTurnstile>> known_;
};

}  // namespace

SweepZero refined_zero(const Family& family, const SweepValue& first, const SweepValue& last, double zero_tolerance,
                       const std::function<SweepValue(double)>& row_at) {
  return Refinement(family, first, last, zero_tolerance, row_at).run();
}

}  // namespace lober::detail

#include "lober/transport/sweep.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <utility>

#include "engine/base/parallel/parallel.hpp"
#include "engine/dynamics/transport/sweep/sweep_zero.hpp"
#include "engine/dynamics/transport/tangles/area_preservation.hpp"
#include "engine/dynamics/transport/tangles/barrier.hpp"
#include "engine/dynamics/transport/turnstile/turnstile.hpp"
#include "lober/base/error.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

void fill(SweepRow& row, const ManifoldTangle& found) {
  const Tangle& tangle = found.tangle;
  row.from = found.local_u.saddle;
  row.to = found.local_s.saddle;
  row.bip = found.tangle.pips[found.bip].at;
  row.multiplier = found.local_u.multiplier;
  row.period = found.period();
  row.areas_by_action = found.areas_by_action;
  const bool with_action = !row.areas_by_action.empty();
  if (!with_action) row.lobe_area12_by_action = row.lobe_area21_by_action = row.difference = no_value;
  for (std::size_t k = 0; k < row.period; ++k) {
    const std::size_t number = found.image_of_bip(-1) + k;
    const Lobe& lobe = tangle.lobes[number];
    row.areas.push_back(lobe.area);
    row.errors.push_back(lobe.smooth_error);
    const bool leaves = tangle.images.labels[number].from == 1;
    Measured& side = leaves ? row.lobe_area12 : row.lobe_area21;
    side = side + Measured{std::fabs(lobe.area), lobe.smooth_error};
    if (!with_action) continue;
    (leaves ? row.lobe_area12_by_action : row.lobe_area21_by_action) += std::fabs(row.areas_by_action[k]);
    if (k >= row.period / 2) row.difference -= row.areas_by_action[k];
  }
}

// Fills in the fluxes by the turnstile of the boundary, where it crosses itself as in the plane or on the cylinder.
void fill_fluxes(SweepRow& row, const FamilyMember& member, const ManifoldTangle& found) {
  try {
    require_areas_preserved(*member.map, found.local_u.saddle);
    const Turnstile turnstile(barrier_of(found, member.lattice));
    row.flux12 = turnstile.flux12();
    row.flux21 = turnstile.flux21();
  } catch (const DataError& error) {
    row.flux12 = row.flux21 = {no_value, no_value};
    row.remark = error.what();
  }
}

// The turnstile of one value, with its local manifolds and the bip as far as they are known.
SweepValue value_at(const Family& family, double value, const ManifoldTangleOptions& options, bool with_fluxes,
                    const KnownStart* start = nullptr) {
  SweepValue result;
  SweepRow& row = result.row;
  row.value = value;
  try {
    const FamilyMember member = family(value);
    const std::unique_ptr<ManifoldTangle> found = TangleGrowth(*member.map, member.connection, options, start).take();
    fill(row, *found);
    if (with_fluxes) fill_fluxes(row, member, *found);
    result.known = known_turnstile(*found);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    row = {};
    row.value = value;
    row.failure = error.what();
  }
  return result;
}

// The values of a sweep, with pips that are the same orbits all along it.
//
// A tangle by itself takes one of its pips as the bip, and a little farther along the sweep it might take another:
// W(q) - W(q') would jump. So every 32nd value is worked out from nothing; from each of these the turnstile is
// continued value by value to the next one, where it shows which of that one's pips is the same. Where pips come or go
// the local manifolds are continued all the same, and the tangle is looked for on them. Then all rows are made, with
// local manifolds and a bip that are known. The same bits for any number of threads.
class SweepOfValues {
 public:
  using ValueAt = std::function<SweepValue(double, const KnownStart*)>;

  using OnRow = std::function<void(const SweepRow&)>;

  /// Counts in `done` the pieces of work that are, `pieces()` in all.
  SweepOfValues(const Family& family, std::span<const double> values, std::atomic<std::size_t>& done, ValueAt value_at,
                OnRow on_row)
      : family_(family),
        values_(values),
        done_(done),
        value_at_(std::move(value_at)),
        on_row_(std::move(on_row)),
        known_(values.size()),
        found_(values.size()),
        chain_(values.size()),
        follows_(values.size()),
        is_own_(values.size()),
        is_made_(values.size()) {}

  /// Each group has a first value; each value is continued to, and has a row.
  static std::size_t pieces(std::size_t values) { return (values + together - 1) / together + 2 * values; }

  std::vector<SweepValue> run() {
    const std::size_t groups = (values_.size() + together - 1) / together;
    at_begin_.resize(groups);
    begin_chain_.resize(groups);
    for_each_block(groups, 1, [&](std::size_t g, std::size_t) {
      const std::size_t k = g * together;
      found_[k] = value_at_(values_[k], nullptr);
      known_[k] = found_[k].known;
      chain_[k] = k;
      ++done_;
    });
    for_each_block(groups, 1, [&](std::size_t g, std::size_t) { continue_from(g); });
    continue_over_gaps();
    const std::vector<std::size_t> bip = bips();
    for_each_block(values_.size(), 1, [&](std::size_t k, std::size_t) {
      make_row(k, bip[k]);
      ++done_;
      hand_over(k);
    });
    for (std::size_t k = 1; k < values_.size(); ++k)
      found_[k].row.follows = follows_[k] != 0 && is_own_[k] == 0 && is_own_[k - 1] == 0;
    return std::move(found_);
  }

 private:
  static constexpr std::size_t together = 32;

  // Turnstiles of the values up to the beginning of the next group, and there. Where one cannot be continued it is
  // looked for on manifolds that are, or else worked out from nothing.
  void continue_from(std::size_t group) {
    const std::size_t end = std::min((group + 1) * together, values_.size());
    std::optional<std::size_t> last;
    for (std::size_t k = group * together; k < end; ++k) {
      if (k > group * together) {
        Followed there = last ? followed(k, *last) : Followed{};
        known_[k] = std::move(there.turnstile);
        chain_[k] = known_[k] ? chain_[*last] : k;
        follows_[k] = known_[k] && known_[k - 1];
        if (!known_[k]) look_for(k, there.manifolds);
      }
      if (known_[k]) last = k;
      ++done_;
    }
    if (end == values_.size() || !last) return;
    at_begin_[group + 1] = followed(end, *last).turnstile;
    begin_chain_[group + 1] = chain_[*last];
  }

  void look_for(std::size_t k, const std::optional<KnownManifolds>& manifolds) {
    if (manifolds) {
      const KnownStart start{manifolds->u.local, manifolds->s.local, {}, {}};
      found_[k] = value_at_(values_[k], &start);
    }
    if (found_[k].known) {
      known_[k] = found_[k].known;
      known_[k]->on = *manifolds;
    } else {
      found_[k] = value_at_(values_[k], nullptr);
      known_[k] = found_[k].known;
    }
  }

  // Where a system's own guess finds no saddle any more, one that was followed there may be; from either side.
  void continue_over_gaps() {
    const auto fill = [&](std::size_t k, std::size_t from) {
      if (known_[k] || !known_[from]) return;
      known_[k] = followed(k, from).turnstile;
      if (!known_[k]) return;
      chain_[k] = chain_[from];
      follows_[std::max(k, from)] = 1;
    };
    for (std::size_t k = 1; k < values_.size(); ++k) fill(k, k - 1);
    for (std::size_t k = values_.size(); k-- > 1;) fill(k - 1, k);
  }

  // The bip of each value, as the number of a pip in its turnstile; 0: the one it has. Along chains that are linked it
  // is the orbit that the first tangle took: fluxes of overlapping lobes depend on it, and single values take that one
  // too.
  [[nodiscard]] std::vector<std::size_t> bips() {
    std::vector<std::size_t> bips(values_.size(), 0);
    for (std::size_t k = 0; k < values_.size(); ++k) {
      if (!known_[k] || chain_[k] != k) continue;
      const std::size_t period = known_[k]->orbits.size() - 1;
      std::optional<std::size_t> number;
      if (const auto& there = at_begin_[k / together]; k % together == 0 && there) {
        // As the last number of a period, which has no pre-image among the orbits.
        const std::size_t before = bips[begin_chain_[k / together]], last = there->orbits.size() - 1;
        const std::size_t bip = before == 0 ? last : before;
        if (bip <= last && !there->is_lost(bip)) number = known_[k]->same_pip(*there, bip);
        follows_[k] = number.has_value();
      }
      bips[k] = number.value_or(period) % period;
    }
    for (std::size_t k = 0; k < values_.size(); ++k) {
      if (known_[k]) bips[k] = bips[chain_[k]];
    }
    return bips;
  }

  [[nodiscard]] Followed followed(std::size_t k, std::size_t from) const {
    return followed_to(family_, values_[k], values_[from], *known_[from]);
  }

  void make_row(std::size_t k, std::size_t bip) {
    SweepValue& value = found_[k];
    if (value.known && bip == 0) return;
    const bool has_failed = !value.row.failure.empty();
    if (known_[k]) {
      const std::size_t last = known_[k]->orbits.size() - 1;
      const bool is_last = bip == 0 || bip >= last, is_there = is_last || !known_[k]->is_lost(bip);
      const KnownStart start = known_[k]->start(is_last || !is_there ? last : bip);
      SweepValue made = value_at_(values_[k], &start);
      is_own_[k] = !made.known || !is_there;
      if (made.known) value = std::move(made);
    }
    if (!value.known && !has_failed) value = value_at_(values_[k], nullptr);
  }

  // Row k is made; gives away those before which all are.
  void hand_over(std::size_t k) {
    if (!on_row_) return;
    const std::lock_guard lock(handing_over_);
    is_made_[k] = 1;
    for (; handed_over_ < is_made_.size() && is_made_[handed_over_] != 0; ++handed_over_) {
      on_row_(found_[handed_over_].row);
    }
  }

  const Family& family_;
  std::span<const double> values_;
  std::atomic<std::size_t>& done_;
  ValueAt value_at_;
  OnRow on_row_;
  std::vector<std::optional<KnownTurnstile>> known_;     // as continued
  std::vector<std::optional<KnownTurnstile>> at_begin_;  // that of the group before continued to the first of a group
  std::vector<std::size_t> begin_chain_;                 // the chain that this belongs to
  std::vector<SweepValue> found_;
  std::vector<std::size_t> chain_;  // the number of the value from which each one's turnstile was continued first
  // For each value, whether what is known of it has the pips of the value before; whether its row has pips of its own.
  std::vector<char> follows_, is_own_;
  std::mutex handing_over_;
  std::vector<char> is_made_;  // rows, under the mutex as the number of those that were handed over
  std::size_t handed_over_ = 0;
};

bool is_zero(const SweepRow& row) {
  return row.failure.empty() && row.difference == 0;
}
// One of the values is a zero itself.
SweepZero exact_zero(const SweepRow& row) {
  return {row.value, row.value, row.value, 0, 0, 0, {}};
}

}  // namespace

std::size_t Sweep::failures() const {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const SweepRow& row) { return !row.failure.empty(); }));
}

namespace {

Sweep swept(const Family& family, std::span<const double> values, const SweepOptions& options) {
  Sweep result;
  std::atomic<std::size_t> done{0};
  const auto pieces = static_cast<double>(SweepOfValues::pieces(values.size()));
  std::mutex one_at_a_time;
  bool cancelled = false;
  SweepOptions inner = options;
  // A manifold may take long: it asks as well.
  inner.tangle.progress = [&](const std::string&) {
    const std::lock_guard lock(one_at_a_time);
    cancelled = cancelled || !options.progress(static_cast<double>(done) / pieces);
    return !cancelled;
  };
  const auto value_with = [&](double value, const KnownStart* start) {
    return value_at(family, value, inner.tangle, true, start);
  };
  const std::vector<SweepValue> found = SweepOfValues(family, values, done, value_with, options.on_row).run();
  for (const SweepValue& value : found) result.rows.push_back(value.row);
  for (std::size_t k = 0; k + 1 < result.rows.size(); ++k) {
    const SweepRow &first = result.rows[k], &last = result.rows[k + 1];
    if (is_zero(first)) result.zeros.push_back(exact_zero(first));
    if (!first.failure.empty() || !last.failure.empty() || !(first.difference * last.difference < 0)) continue;
    if (!last.follows) continue;
    SweepZero zero;
    zero.low = first.value;
    zero.high = last.value;
    // The chord; no more than a value to start from.
    zero.value = first.value - first.difference * (last.value - first.value) / (last.difference - first.difference);
    zero.width = std::fabs(last.value - first.value);
    zero.difference = no_value;
    result.zeros.push_back(zero);
  }
  if (!result.rows.empty() && is_zero(result.rows.back())) result.zeros.push_back(exact_zero(result.rows.back()));
  if (!options.find_zeros) return result;
  const auto scratch = [&](double value) { return value_at(family, value, inner.tangle, false); };
  for_each_block(result.zeros.size(), 1, [&](std::size_t k, std::size_t) {
    SweepZero& zero = result.zeros[k];
    if (zero.low == zero.high) return;
    const auto at = [&](double value) -> const SweepValue& {
      return *std::find_if(found.begin(), found.end(), [&](const SweepValue& v) { return v.row.value == value; });
    };
    zero = refined_zero(family, at(zero.low), at(zero.high), options.zero_tolerance, scratch);
  });
  return result;
}

}  // namespace

// An exception of the caller's progress ends the sweep; it is the failure of none of its values.
Sweep sweep(const Family& family, std::span<const double> values, const SweepOptions& options) {
  std::exception_ptr thrown;
  SweepOptions watched = options;
  watched.progress = [&](double done) {
    try {
      return options.progress(done);
    } catch (...) {
      thrown = std::current_exception();
      return false;
    }
  };
  try {
    return swept(family, values, watched);
  } catch (const Cancelled&) {
    if (thrown) std::rethrow_exception(thrown);
    throw;
  }
}

}  // namespace lober

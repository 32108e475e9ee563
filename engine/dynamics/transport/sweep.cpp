#include "lober/sweep.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <utility>

#include "engine/base/parallel/parallel.hpp"
#include "engine/dynamics/transport/area_preservation.hpp"
#include "engine/dynamics/transport/turnstile.hpp"
#include "engine/dynamics/transport/wrapped_tangle.hpp"
#include "lober/error.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

void fill(SweepRow& row, const ManifoldTangle& found) {
  const Tangle& tangle = found.tangle;
  row.from = found.local_u.saddle;
  row.to = found.local_s.saddle;
  row.multiplier = found.local_u.multiplier;
  row.period = found.period();
  row.areas_by_action = found.areas_by_action;
  const bool with_action = !row.areas_by_action.empty();
  if (!with_action) row.lobe_area12_by_action = row.lobe_area21_by_action = row.difference = unknown;
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

// By the turnstile of the boundary, where it crosses itself as in the plane or on the cylinder.
void fill_fluxes(SweepRow& row, const FamilyMember& member, const ManifoldTangle& found) {
  try {
    require_areas_preserved(*member.map, found.local_u.saddle);
    WrappedTangle wrapped;
    Barrier barrier = barrier_of(found);
    if (!(member.lattice == Point{})) {
      const std::array<const ManifoldTangle*, 1> tangles{&found};
      wrapped = wrapped_tangle(cylinder_of(member.lattice, tangles), *member.map, found, 1, 0, 0);
      barrier = barrier_of(found, wrapped);
    }
    const Turnstile turnstile(barrier);
    row.flux12 = turnstile.flux12();
    row.flux21 = turnstile.flux21();
  } catch (const DataError& error) {
    row.flux12 = row.flux21 = {unknown, unknown};
    row.remark = error.what();
  }
}

SweepRow row_at(const Family& family, double value, const ManifoldTangleOptions& options, bool with_fluxes) {
  SweepRow row;
  row.value = value;
  try {
    const FamilyMember member = family(value);
    const std::unique_ptr<ManifoldTangle> found = grow_tangle(*member.map, member.connection, options);
    fill(row, *found);
    if (with_fluxes) fill_fluxes(row, member, *found);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    row = {};
    row.value = value;
    row.failure = error.what();
  }
  return row;
}

bool is_zero(const SweepRow& row) {
  return row.failure.empty() && row.difference == 0;
}
// One of the values is a zero itself.
SweepZero exact_zero(const SweepRow& row) {
  return {row.value, row.value, row.value, 0, 0, 0, {}};
}

// The end of a refinement at a value that has no difference.
struct NoDifference {};

// By the method of Alefeld, Potra & Shi (1995), TOMS 748, which never gives up the bracket.
SweepZero refined(const Family& family, const SweepRow& first, const SweepRow& last, const SweepOptions& options) {
  SweepZero zero{first.value, last.value, 0, 0, 0, 0, {}};
  struct End {
    double value, difference;
  };
  End low{first.value, first.difference}, high{last.value, last.difference};
  if (low.value > high.value) std::swap(low, high);
  const End from = low, to = high;
  const double least_end = std::min(std::fabs(from.difference), std::fabs(to.difference));
  const auto difference_at = [&](double value) {
    const SweepRow row = row_at(family, value, options.tangle, false);
    ++zero.evaluations;
    if (!row.failure.empty() || std::isnan(row.difference)) {
      zero.failure = row.failure;
      throw NoDifference();
    }
    if (row.difference * low.difference >= 0) low = {value, row.difference};
    if (row.difference * high.difference >= 0) high = {value, row.difference};
    return row.difference;
  };
  const auto narrow = [&](double a, double b) {
    return b - a <= options.zero_tolerance * std::max(std::fabs(a), std::fabs(b));
  };
  std::uintmax_t max_evaluations = 60;
  try {
    boost::math::tools::toms748_solve(difference_at, from.value, to.value, from.difference, to.difference, narrow,
                                      max_evaluations);
  } catch (const NoDifference&) {  // the bracket is what it was
  }
  const End& nearer = std::fabs(low.difference) <= std::fabs(high.difference) ? low : high;
  zero.value = nearer.value;
  zero.difference = nearer.difference;
  // Ends closer than asked for differ by what the integration leaves, no longer by the zero.
  zero.width = std::max(high.value - low.value, 0.25 * options.zero_tolerance * std::fabs(zero.value));
  if (zero.failure.empty() && std::fabs(zero.difference) > 0.1 * least_end) {
    zero.failure = "the difference jumps there: it belongs to other pips on either side";
  }
  return zero;
}

}  // namespace

std::size_t Sweep::failures() const {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const SweepRow& row) { return !row.failure.empty(); }));
}

Sweep sweep(const Family& family, std::span<const double> values, const SweepOptions& options) {
  Sweep result;
  result.rows.resize(values.size());
  std::atomic<std::size_t> done{0};
  std::mutex one_at_a_time;
  bool cancelled = false;
  SweepOptions inner = options;
  // A manifold may take long: it asks as well.
  inner.tangle.progress = [&](const std::string&) {
    if (!options.progress) return true;
    const std::lock_guard lock(one_at_a_time);
    cancelled = cancelled || !options.progress(done);
    return !cancelled;
  };
  for_each_block(values.size(), 1, [&](std::size_t k, std::size_t) {
    result.rows[k] = row_at(family, values[k], inner.tangle, true);
    ++done;
  });
  for (std::size_t k = 0; k + 1 < result.rows.size(); ++k) {
    const SweepRow &first = result.rows[k], &last = result.rows[k + 1];
    if (is_zero(first)) result.zeros.push_back(exact_zero(first));
    if (!first.failure.empty() || !last.failure.empty() || !(first.difference * last.difference < 0)) continue;
    SweepZero zero;
    zero.low = first.value;
    zero.high = last.value;
    // The chord; no more than a value to start from.
    zero.value = first.value - first.difference * (last.value - first.value) / (last.difference - first.difference);
    zero.width = std::fabs(last.value - first.value);
    zero.difference = unknown;
    result.zeros.push_back(zero);
  }
  if (!result.rows.empty() && is_zero(result.rows.back())) result.zeros.push_back(exact_zero(result.rows.back()));
  if (!options.find_zeros) return result;
  for_each_block(result.zeros.size(), 1, [&](std::size_t k, std::size_t) {
    if (result.zeros[k].low == result.zeros[k].high) return;
    const auto at = [&](double value) -> const SweepRow& {
      return *std::find_if(result.rows.begin(), result.rows.end(), [&](const SweepRow& r) { return r.value == value; });
    };
    result.zeros[k] = refined(family, at(result.zeros[k].low), at(result.zeros[k].high), inner);
  });
  return result;
}

}  // namespace lober

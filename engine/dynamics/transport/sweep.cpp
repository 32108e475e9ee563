#include "lober/sweep.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "engine/base/parallel/parallel.hpp"
#include "lober/error.hpp"

namespace lober {
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
  if (!with_action) row.action12 = row.action21 = row.difference = unknown;
  for (std::size_t k = 0; k < row.period; ++k) {
    const std::size_t number = found.image_of_bip(-1) + k;
    const Lobe& lobe = tangle.lobes[number];
    row.areas.push_back(lobe.area);
    row.errors.push_back(lobe.smooth_error);
    const bool leaves = tangle.images.labels[number].from == 1;
    (leaves ? row.flux12 : row.flux21) += std::fabs(lobe.area);
    if (!with_action) continue;
    (leaves ? row.action12 : row.action21) += std::fabs(row.areas_by_action[k]);
    if (k >= row.period / 2) row.difference -= row.areas_by_action[k];
  }
}

SweepRow row_at(const Family& family, double value, const ManifoldTangleOptions& options) {
  SweepRow row;
  row.value = value;
  try {
    const FamilyMember member = family(value);
    fill(row, *grow_tangle(*member.map, member.connection, options));
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    row = {};
    row.value = value;
    row.failure = error.what();
  }
  return row;
}

// Regula falsi with the Illinois rule, which never gives up the bracket; a bisection where it gets stuck.
SweepZero refined(const Family& family, const SweepRow& first, const SweepRow& last, const SweepOptions& options) {
  constexpr int most_evaluations = 60;
  SweepZero zero{first.value, last.value, 0, 0, 0, 0, {}};
  double a = first.value, b = last.value, at_a = first.difference, at_b = last.difference;
  const double least_end = std::min(std::fabs(at_a), std::fabs(at_b));
  double weight_a = at_a, weight_b = at_b;  // what the Illinois rule makes of them
  int side = 0;
  double width = std::fabs(b - a);
  while (zero.evaluations < most_evaluations && width > options.zero_tolerance * std::max(std::fabs(a), std::fabs(b))) {
    double x = zero.evaluations % 4 == 3 ? 0.5 * (a + b) : a - weight_a * (b - a) / (weight_b - weight_a);
    // Nearer to an end than the zero is asked for, nothing would be learned from the other side.
    const double margin = 0.25 * options.zero_tolerance * std::fabs(a);
    x = std::clamp(x, std::min(a, b) + margin, std::max(a, b) - margin);
    const SweepRow row = row_at(family, x, options.tangle);
    ++zero.evaluations;
    if (!row.failure.empty() || std::isnan(row.difference)) {
      zero.failure = row.failure;
      break;
    }
    if (row.difference == 0) {
      a = b = x;
      at_a = at_b = 0;
    } else if (row.difference * at_a > 0) {
      a = x;
      weight_a = at_a = row.difference;
      if (side == 1) weight_b /= 2;
      side = 1;
    } else {
      b = x;
      weight_b = at_b = row.difference;
      if (side == -1) weight_a /= 2;
      side = -1;
    }
    width = std::fabs(b - a);
  }
  const bool nearer_a = std::fabs(at_a) <= std::fabs(at_b);
  zero.value = nearer_a ? a : b;
  zero.difference = nearer_a ? at_a : at_b;
  zero.width = width;
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
  std::atomic<bool> cancelled{false};
  SweepOptions inner = options;
  // A manifold may take long: it asks as well.
  inner.tangle.progress = [&](const std::string&) {
    if (options.progress && !options.progress(done)) cancelled = true;
    return !cancelled;
  };
  for_each_block(values.size(), 1, [&](std::size_t k, std::size_t) {
    result.rows[k] = row_at(family, values[k], inner.tangle);
    ++done;
  });
  for (std::size_t k = 0; k + 1 < result.rows.size(); ++k) {
    const SweepRow &first = result.rows[k], &last = result.rows[k + 1];
    if (!first.failure.empty() || !last.failure.empty() || !(first.difference * last.difference < 0)) continue;
    SweepZero zero;
    zero.low = first.value;
    zero.high = last.value;
    // The chord; no more than a place to look at.
    zero.value = first.value - first.difference * (last.value - first.value) / (last.difference - first.difference);
    zero.width = std::fabs(last.value - first.value);
    zero.difference = unknown;
    result.zeros.push_back(zero);
  }
  if (!options.find_zeros) return result;
  for_each_block(result.zeros.size(), 1, [&](std::size_t k, std::size_t) {
    const auto at = [&](double value) -> const SweepRow& {
      return *std::find_if(result.rows.begin(), result.rows.end(), [&](const SweepRow& r) { return r.value == value; });
    };
    result.zeros[k] = refined(family, at(result.zeros[k].low), at(result.zeros[k].high), inner);
  });
  return result;
}

}  // namespace lober

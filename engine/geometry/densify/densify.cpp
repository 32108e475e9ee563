#include "lober/curve/densify.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/parallel/running_sums.hpp"
#include "engine/geometry/densify/criteria.hpp"
#include "engine/geometry/densify/distinct_curve.hpp"
#include "engine/geometry/densify/subdivision.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr std::uint64_t max_densified_points = (std::uint64_t{1} << 31) - 1;

double largest_coordinate(std::span<const Point> points) {
  std::vector<double> largest((points.size() + pass_grain - 1) / pass_grain, 0);
  for_each_block(points.size(), pass_grain, [&](std::size_t first, std::size_t last) {
    double here = 0;
    for (std::size_t k = first; k < last; ++k) {
      here = std::max(here, std::max(std::fabs(points[k].x), std::fabs(points[k].y)));
    }
    largest[first / pass_grain] = here;
  });
  return *std::max_element(largest.begin(), largest.end());
}

// The state of a segment. `waiting`: it or a neighbour changed since it was judged.
enum class State : std::uint8_t { met, waiting, too_short, corner, unmet };

State state_of(const Requirement& requirement) {
  return requirement.corner ? State::corner : requirement.too_short ? State::too_short : State::met;
}

// The number of parts of every segment, brought up round by round.
class Rounds {
 public:
  Rounds(const Judge& judge, std::size_t segments, std::size_t vertices, std::uint64_t max_points)
      : judge_(judge),
        extra_(vertices - segments),
        max_points_(std::min(max_points, max_densified_points)),
        parts_(segments),
        next_(segments),
        state_(segments) {}

  void run(bool closed, std::uint32_t max_rounds) {
    for_each_block(parts_.size(), pass_grain, [&](std::size_t first, std::size_t last) {
      std::fill(parts_.begin() + static_cast<std::ptrdiff_t>(first), parts_.begin() + static_cast<std::ptrdiff_t>(last),
                1U);
    });
    if (!judge_.estimate_is_final()) enough_.resize(parts_.size());
    round(
        [&](std::size_t k) {
          const Requirement requirement = judge_.estimate(k);
          if (!enough_.empty()) enough_[k] = requirement.enough;
          return requirement;
        },
        [](State) { return true; });
    if (judge_.estimate_is_final() || !fits_) return;
    std::fill(state_.begin(), state_.end(), State::waiting);
    while (rounds_ < max_rounds) {
      const bool changed = round([&](std::size_t k) { return judge_.judge(k, parts_, enough_[k]); },
                                 [](State state) { return state == State::waiting; });
      if (!changed || !fits_) return;
      wake_neighbours(closed);
    }
    give_up();
  }

  [[nodiscard]] const Buffer<std::uint32_t>& parts() const { return parts_; }
  [[nodiscard]] std::uint32_t rounds() const { return rounds_; }

  [[nodiscard]] std::vector<Diagnostic> diagnostics(const Buffer<std::uint64_t>& begin) const {
    const auto cause = [&](std::size_t k) {
      return state_[k] == State::corner      ? DiagnosticCause::corner
             : state_[k] == State::too_short ? DiagnosticCause::min_length
                                             : unmet_cause_;
    };
    const Buffer<Diagnostic> found = gathered<Diagnostic>(
        parts_.size(), [&](std::size_t k) { return state_[k] != State::met; },
        [&](std::size_t k) {
          return Diagnostic{static_cast<std::uint32_t>(begin[k]), parts_[k], cause(k)};
        });
    return {found.begin(), found.end()};
  }

 private:
  // One round: the requirement of each segment, trimmed to what fits. Returns whether anything changed.
  template <typename RequirementOf, typename Concerned>
  bool round(const RequirementOf& requirement_of, const Concerned& concerned) {
    for_each_block(parts_.size(), pass_grain, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        next_[k] = parts_[k];
        if (!concerned(state_[k])) continue;
        const Requirement requirement = requirement_of(k);
        next_[k] = requirement.parts;
        state_[k] = state_of(requirement);
      }
    });
    trim();
    const bool changed = sum_of(parts_.size(), [&](std::size_t k) { return next_[k] != parts_[k] ? 1U : 0U; }) != 0;
    parts_.swap(next_);  // next_ now holds the parts before: wake_neighbours compares
    if (changed) ++rounds_;
    return changed;
  }

  // If the result would have too many points, no segment gets more than the largest number with which it has not.
  void trim() {
    const auto points_with = [&](std::uint32_t cap) {
      return extra_ +
             sum_of(parts_.size(), [&](std::size_t k) { return std::max(parts_[k], std::min(next_[k], cap)); });
    };
    if (points_with(~0U) <= max_points_) return;
    std::uint32_t low = 1, high = ~0U;  // low fits, or nothing does; high does not
    while (high - low > 1) {
      const std::uint32_t middle = low + (high - low) / 2;
      (points_with(middle) <= max_points_ ? low : high) = middle;
    }
    fits_ = false;
    unmet_cause_ = DiagnosticCause::max_points;
    for_each_block(parts_.size(), pass_grain, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        const std::uint32_t allowed = std::max(parts_[k], std::min(next_[k], low));
        if (allowed < next_[k]) state_[k] = State::unmet;
        next_[k] = allowed;
      }
    });
  }

  void wake_neighbours(bool closed) {
    const std::size_t size = parts_.size();
    const auto changed = [&](std::size_t k) { return parts_[k] != next_[k]; };
    for_each_block(size, pass_grain, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        const bool before = k > 0 ? changed(k - 1) : closed && changed(size - 1);
        const bool after = k + 1 < size ? changed(k + 1) : closed && changed(0);
        if (changed(k) || before || after) state_[k] = State::waiting;
      }
    });
  }

  // No round is left: what still waits is judged for the last time.
  void give_up() {
    for_each_block(parts_.size(), pass_grain, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        if (state_[k] != State::waiting) continue;
        const Requirement requirement = judge_.judge(k, parts_, enough_[k]);
        state_[k] = requirement.parts > parts_[k] ? State::unmet : state_of(requirement);
      }
    });
  }

  const Judge& judge_;
  std::uint64_t extra_;  // the last vertex of an open curve
  std::uint64_t max_points_;
  Buffer<std::uint32_t> parts_, next_;
  Buffer<std::uint32_t> enough_;  // see Requirement; only where estimates are not final
  Buffer<State> state_;
  std::uint32_t rounds_ = 0;
  bool fits_ = true;
  DiagnosticCause unmet_cause_ = DiagnosticCause::max_rounds;
};

}  // namespace

std::string_view name(DiagnosticCause cause) {
  switch (cause) {
    case DiagnosticCause::max_points:
      return "max_points";
    case DiagnosticCause::max_rounds:
      return "max_rounds";
    case DiagnosticCause::corner:
      return "corner";
    case DiagnosticCause::min_length:
      break;
  }
  return "min_length";
}

DensifiedCurve densify(CurveView curve, const Criteria& criteria, const DensifyOptions& options) {
  require_sensible(criteria);
  const bool linear = options.interpolation == Interpolation::linear;
  if (linear && criteria.angle < Criteria::off) {
    throw UsageError(
        "densify: points on the chords turn no corner; give the angle with an interpolation other than linear");
  }
  const DistinctCurve distinct(curve);
  const Interpolant interpolant(distinct.view(), options.interpolation);
  const Criteria scaled{distinct.to_view(criteria.max_length), criteria.angle,
                        distinct.to_view(criteria.distance_angle), distinct.to_view(criteria.min_length)};
  const Judge judge(interpolant, scaled, largest_coordinate(distinct.view().points));
  Rounds rounds(judge, distinct.view().segments(), distinct.view().points.size(), options.max_points);
  rounds.run(curve.closed, options.max_rounds);
  DensifiedCurve result;
  Buffer<std::uint64_t> begin;
  result.points = subdivided(interpolant, rounds.parts(), begin);
  distinct.from_view(result.points);
  result.closed = curve.closed;
  result.diagnostics = rounds.diagnostics(begin);
  result.rounds = rounds.rounds();
  return result;
}

}  // namespace lober

#include "lober/dynamics/periodic_orbit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/text.hpp"
#include "engine/dynamics/escape/least_excess.hpp"
#include "engine/dynamics/escape/state_index.hpp"
#include "lober/base/error.hpp"

namespace lober {
namespace {

// The amplitude of the linear orbit in each coordinate.
double amplitude(const SaddlePoint& saddle, int coordinate) {
  return std::hypot(saddle.centre_cos[detail::state_index(coordinate)],
                    saddle.centre_sin[detail::state_index(coordinate)]);
}

// Across the longer of the two coordinates of position.
Section local_section(const Flow& flow, const SaddlePoint& saddle) {
  const auto pairs = flow.conjugate_pairs();
  const bool second = amplitude(saddle, pairs[1].q) > amplitude(saddle, pairs[0].q);
  const ConjugatePair along = pairs[second ? 1 : 0], chart = pairs[second ? 0 : 1];
  Section section;
  section.coordinate = along.q;
  section.value = saddle.at[detail::state_index(along.q)];
  section.direction = 1;
  section.chart_x = chart.q;
  section.chart_y = chart.p;
  section.solved = along.p;
  return section;
}

struct Corrected {
  Point at;
  double residual;
  double trace;  // trace of the derivative of the return map
};

// Finds where the trajectories forward and backward from a point of the section meet it next, in the other direction.
// On a periodic orbit that is one point. Each way stretches by the square root of the multiplier only, so that Newton's
// method finds orbits whose return map would be too steep for it.
class HalfReturns {
 public:
  HalfReturns(const Flow& flow, const Section& section, double energy, const IntegrationOptions& options)
      : flow_(flow), section_(section), opposite_(section), energy_(energy), options_(options) {
    opposite_.direction = -section.direction;
  }

  // As long as it gains. `scale`: size of the orbit.
  [[nodiscard]] std::optional<Corrected> corrected(Point guess, double scale) const {
    std::optional<Corrected> best;
    Point here = guess;
    for (int round = 0; round < 20; ++round) {
      Half after, before;
      if (!follow(here, 1, after) || !follow(here, -1, before)) break;
      const Point r{after.at.x - before.at.x, after.at.y - before.at.y};
      const double size = std::hypot(r.x, r.y);
      if (best && size >= best->residual && (best->residual < accepted * scale || round > 12)) break;
      const Matrix2 &a = after.derivative, &b = before.derivative;
      if (!best || size < best->residual) {
        const double determinant = b.xx * b.yy - b.xy * b.yx;
        const double trace = (b.yy * a.xx - b.xy * a.yx - b.yx * a.xy + b.xx * a.yy) / determinant;
        best = Corrected{here, size, trace};
      }
      const Matrix2 d{a.xx - b.xx, a.xy - b.xy, a.yx - b.yx, a.yy - b.yy};
      const double determinant = d.xx * d.yy - d.xy * d.yx;
      if (determinant == 0 || !std::isfinite(determinant)) break;
      here.x -= (r.x * d.yy - d.xy * r.y) / determinant;
      here.y -= (d.xx * r.y - d.yx * r.x) / determinant;
    }
    if (!best || !(best->residual <= accepted * scale) || !(best->trace > 2)) return std::nullopt;
    return best;
  }

 private:
  static constexpr double accepted = 1e-8;
  struct Half {
    Point at;
    Matrix2 derivative;
  };

  [[nodiscard]] bool follow(Point from, int direction, Half& half) const {
    const FlowState start = flow_.on_section(section_, energy_, from);
    FlowState end = start;
    double time = 0;
    if (!std::isfinite(start[0])) return false;
    flow_.to_section({&end, 1}, {&time, 1}, opposite_, direction, options_);
    if (!std::isfinite(end[0])) return false;
    FlowMatrix derivative;
    flow_.integrate_with_derivative(start, 0, time, derivative, options_);
    const FlowState leaves = flow_.velocity(start, 0), arrives = flow_.velocity(end, 0);
    std::array<Point, 2> columns;
    for (std::size_t k = 0; k < 2; ++k) {
      const int moved = k == 0 ? section_.chart_x : section_.chart_y;
      // The chart's vector at constant energy, carried along and slid along the flow back onto the section.
      const double lift = -slope(moved, leaves) / slope(section_.solved, leaves);
      FlowState w{};
      for (std::size_t i = 0; i < 4; ++i)
        w[i] = derivative[i][detail::state_index(moved)] + lift * derivative[i][detail::state_index(section_.solved)];
      const double share =
          w[detail::state_index(section_.coordinate)] / arrives[detail::state_index(section_.coordinate)];
      columns[k] = {w[detail::state_index(section_.chart_x)] - share * arrives[detail::state_index(section_.chart_x)],
                    w[detail::state_index(section_.chart_y)] - share * arrives[detail::state_index(section_.chart_y)]};
    }
    half.at = {end[detail::state_index(section_.chart_x)], end[detail::state_index(section_.chart_y)]};
    half.derivative = {columns[0].x, columns[1].x, columns[0].y, columns[1].y};
    return std::isfinite(half.at.x);
  }

  // dH / d(state[coordinate]) by Hamilton's equations.
  [[nodiscard]] double slope(int coordinate, const FlowState& velocity) const {
    for (const ConjugatePair& pair : flow_.conjugate_pairs()) {
      if (pair.q == coordinate) return -pair.factor * velocity[detail::state_index(pair.p)];
      if (pair.p == coordinate) return pair.factor * velocity[detail::state_index(pair.q)];
    }
    return 0;
  }

  const Flow& flow_;
  Section section_, opposite_;
  double energy_;
  IntegrationOptions options_;
};

// The orbit against r = sqrt((energy - saddle) / (wanted energy - saddle)), in which it is smooth down to r = 0.
class Continuation {
 public:
  Continuation(const Flow& flow, const SaddlePoint& saddle, double energy, const Section& section,
               const IntegrationOptions& options)
      : flow_(flow), saddle_(saddle), excess_(energy - saddle.energy), section_(section), options_(options) {
    known_.push_back(
        {0, {saddle.at[detail::state_index(section.chart_x)], saddle.at[detail::state_index(section.chart_y)]}});
    slope_ = linear_slope();
  }

  Corrected run(int& steps) {
    Corrected found{};
    double r = 0;
    for (double next = first_step(); r < 1;) {
      const double energy = next == 1 ? saddle_.energy + excess_ : saddle_.energy + next * next * excess_;
      const double size = next * size_;
      const std::optional<Corrected> orbit =
          HalfReturns(flow_, section_, energy, options_).corrected(predicted(next), size);
      if (orbit && std::hypot(orbit->at.x - known_[0].at.x, orbit->at.y - known_[0].at.y) < 20 * size) {
        found = *orbit;
        known_.push_back({next, found.at});
        ++steps;
        const double grown = std::min(1.0, 2 * next);
        r = next;
        next = grown;
      } else {
        next = 0.5 * (r + next);
        if (next < 1.001 * r + 1e-5) {
          throw DataError("the periodic orbit about the saddle could not be continued beyond energy " +
                          detail::format_number(saddle_.energy + r * r * excess_));
        }
      }
    }
    return found;
  }

 private:
  // Far from the orbit wanted, but not so near to the saddle that rounding of the energy shows.
  [[nodiscard]] double first_step() const {
    return std::clamp(std::sqrt(detail::least_excess(saddle_) / excess_), 1.0 / 16, 1.0);
  }

  struct Known {
    double r;
    Point at;
  };

  // d(chart point)/dr at r = 0: the linear orbit where it crosses the section forward, of the energy wanted.
  [[nodiscard]] Point linear_slope() {
    const std::complex<double> along{saddle_.centre_cos[detail::state_index(section_.coordinate)],
                                     saddle_.centre_sin[detail::state_index(section_.coordinate)]};
    const std::complex<double> phase = std::complex<double>(0, -1) * std::conj(along) / std::abs(along);
    FlowState offset{};
    for (std::size_t k = 0; k < 4; ++k) {
      offset[k] = (std::complex<double>(saddle_.centre_cos[k], saddle_.centre_sin[k]) * phase).real();
    }
    // The energy is quadratic about the saddle; both signs, so that its cubic terms drop out.
    constexpr double small = 1e-3;
    double energy = 0;
    for (const double sign : {-1.0, 1.0}) {
      FlowState state = saddle_.at;
      for (std::size_t k = 0; k < 4; ++k) state[k] += sign * small * offset[k];
      energy += 0.5 * (flow_.hamiltonian(state, 0) - saddle_.energy) / (small * small);
    }
    if (!(energy > 0)) throw DataError("the oscillation about the saddle lowers the energy");
    const double scale = std::sqrt(excess_ / energy);
    size_ = scale * std::abs(along);
    return {scale * offset[detail::state_index(section_.chart_x)],
            scale * offset[detail::state_index(section_.chart_y)]};
  }

  // Polynomial through the last three orbits, or fewer with the slope at r = 0.
  [[nodiscard]] Point predicted(double r) const {
    if (known_.size() == 1) return {known_[0].at.x + r * slope_.x, known_[0].at.y + r * slope_.y};
    const std::size_t count = std::min<std::size_t>(known_.size(), 3);
    const std::span<const Known> last = std::span(known_).last(count);
    Point sum{};
    for (std::size_t i = 0; i < count; ++i) {
      double weight = 1;
      for (std::size_t j = 0; j < count; ++j) {
        if (j != i) weight *= (r - last[j].r) / (last[i].r - last[j].r);
      }
      sum = {sum.x + weight * last[i].at.x, sum.y + weight * last[i].at.y};
    }
    return sum;
  }

  const Flow& flow_;
  const SaddlePoint& saddle_;
  double excess_;
  Section section_;
  IntegrationOptions options_;
  std::vector<Known> known_;
  Point slope_;
  double size_ = 0;  // size of the linear orbit at r = 1
};

// The two states where the section's coordinate turns round, the lower one first.
std::array<FlowState, 2> turning_points(const Flow& flow, const PeriodicOrbit& orbit,
                                        const IntegrationOptions& options) {
  const std::size_t axis = detail::state_index(orbit.local.coordinate);
  constexpr int parts = 64;
  std::array<FlowState, 2> extremes{orbit.state, orbit.state};
  FlowState state = orbit.state;
  for (int k = 0; k < parts; ++k) {
    if (state[axis] < extremes[0][axis]) extremes[0] = state;
    if (state[axis] > extremes[1][axis]) extremes[1] = state;
    flow.integrate({&state, 1}, 0, orbit.period / parts, options);
  }
  for (FlowState& extreme : extremes) {
    for (int round = 0; round < 20; ++round) {
      const FlowState v = flow.velocity(extreme, 0);
      const FlowMatrix slope = flow.jacobian(extreme, 0);
      double acceleration = 0;
      for (std::size_t j = 0; j < 4; ++j) acceleration += slope[axis][j] * v[j];
      const double step = -v[axis] / acceleration;
      if (!(std::fabs(step) > 1e-15 * orbit.period) || !(std::fabs(step) < orbit.period)) break;
      flow.integrate({&extreme, 1}, 0, step, options);
    }
  }
  return extremes;
}

}  // namespace

PeriodicOrbit periodic_orbit(const Flow& flow, const SaddlePoint& saddle, double energy,
                             const IntegrationOptions& options) {
  if (!(energy > saddle.energy) || !std::isfinite(energy)) {
    throw UsageError("the energy must be above that of the saddle, " + detail::format_number(saddle.energy));
  }
  PeriodicOrbit orbit;
  orbit.saddle = saddle;
  orbit.energy = energy;
  orbit.local = local_section(flow, saddle);
  IntegrationOptions near = options;
  near.max_time = std::min(options.max_time, 40 / saddle.frequency);
  const Corrected fixed = Continuation(flow, saddle, energy, orbit.local, near).run(orbit.continuation_steps);
  orbit.at = fixed.at;
  orbit.residual = fixed.residual;
  // Free of cancellation also for multipliers near 1.
  const double excess = fixed.trace - 2;
  orbit.multiplier = 1 + 0.5 * (excess + std::sqrt(excess * (excess + 4)));
  orbit.state = flow.on_section(orbit.local, energy, orbit.at);
  FlowState end = orbit.state;
  flow.to_section({&end, 1}, {&orbit.period, 1}, orbit.local, 1, near);
  flow.integrate_with_action(orbit.state, 0, orbit.period, orbit.action, near);
  IntegrationOptions coarser = near;
  coarser.tolerance *= 10;
  double coarse_action = 0;
  flow.integrate_with_action(orbit.state, 0, orbit.period, coarse_action, coarser);
  orbit.action_error =
      std::fabs(coarse_action - orbit.action) + 64 * std::numeric_limits<double>::epsilon() * std::fabs(orbit.action);
  flow.integrate_with_derivative(orbit.state, 0, orbit.period, orbit.monodromy, near);
  for (std::size_t k = 0; k < 4; ++k) orbit.trace_defect += orbit.monodromy[k][k];
  orbit.trace_defect -= 2 + orbit.multiplier + 1 / orbit.multiplier;
  orbit.turning = turning_points(flow, orbit, near);
  orbit.brake = true;
  for (const FlowState& turning : orbit.turning) {
    const FlowState v = flow.velocity(turning, 0);
    for (const ConjugatePair& pair : flow.conjugate_pairs())
      orbit.brake &= std::fabs(v[detail::state_index(pair.q)]) < 1e-9;
  }
  return orbit;
}

std::vector<FlowState> states_along(const Flow& flow, const PeriodicOrbit& orbit, std::size_t count,
                                    const IntegrationOptions& options) {
  std::vector<FlowState> states(count, orbit.state);
  for (std::size_t k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(count);
    flow.integrate({&states[k], 1}, 0, (2 * k <= count ? share : share - 1) * orbit.period, options);
  }
  return states;
}

}  // namespace lober

#include "lober/transport/melnikov.hpp"
#include "kernels/elementary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "kernels/point.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/levels.hpp"
#include "lober/dynamics/local_manifold.hpp"

namespace lober {
using detail::cross, detail::length;
namespace elementary = detail::elementary;
namespace {

constexpr double least_departure = 1e-18;  // size of f at the ends of the orbit over the reach of the manifold
constexpr double max_gap = 1e-8;           // between the two halves of the orbit
constexpr double sufficient = 1e-13;       // change of M, relative to its largest value, at which a refinement ends

Point as_point(const FlowState& state) {
  return {state[0], state[1]};
}

// d(velocity)/d(eps) at eps = 0, by the central difference of order 6. The step makes its error about that of rounding:
// 1e-12 / 140 of the seventh derivative.
class Perturbation {
 public:
  explicit Perturbation(const FlowFamily& family) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double eps = step * static_cast<double>(k + 1);
      above_[k] = family(eps);
      below_[k] = family(-eps);
    }
  }
  /// At many states, each at its own time: a call of a field of one's own may cost as much as thousands of points.
  [[nodiscard]] std::vector<Point> operator()(std::span<const FlowState> states, std::span<const double> times) const {
    constexpr std::array<double, 3> weights{45.0 / 60, -9.0 / 60, 1.0 / 60};
    std::vector<Point> sums(states.size());
    std::vector<FlowState> above(states.size()), below(states.size());
    for (std::size_t k = 0; k < 3; ++k) {
      above_[k]->velocities(states, times, above);
      below_[k]->velocities(states, times, below);
      for (std::size_t i = 0; i < states.size(); ++i) {
        sums[i].x += weights[k] * (above[i][0] - below[i][0]);
        sums[i].y += weights[k] * (above[i][1] - below[i][1]);
      }
    }
    for (Point& sum : sums) sum = {sum.x / step, sum.y / step};
    return sums;
  }

 private:
  static constexpr double step = 0x1p-7;
  std::array<std::shared_ptr<const Flow>, 3> above_, below_;
};

// The half of a connecting orbit on a local manifold: P(s e^(-+ rate t)).
struct LocalBranch {
  LocalManifold local;
  double sign = 1;  // sign of s
  double rate = 0;  // |log multiplier| per time

  LocalBranch(const PlanarMap& map, Point guess, ManifoldSide side, Point direction, double period)
      : local(local_manifold(map, guess, side)) {
    sign = local.tangent.x * direction.x + local.tangent.y * direction.y < 0 ? -1 : 1;
    rate = elementary::log(local.multiplier) / period;
  }
  [[nodiscard]] Point at(double s) const { return local.at(sign * s); }
};

// The parameter of the branch's point nearest to a point, by Newton's method; negative where none is.
double nearest(const LocalBranch& branch, Point point) {
  double s = std::min(length({point.x - branch.local.saddle.x, point.y - branch.local.saddle.y}), branch.local.reach);
  for (int round = 0; round < 30; ++round) {
    const Point at = branch.at(s), slope = branch.local.slope(branch.sign * s);
    const double speed = slope.x * slope.x + slope.y * slope.y;
    const double step = branch.sign * ((point.x - at.x) * slope.x + (point.y - at.y) * slope.y) / speed;
    s += step;
    if (!(s > 0 && s <= branch.local.reach)) return -1;
    if (std::fabs(step) < 1e-15 * branch.local.reach) break;
  }
  return s;
}

struct QuadratureNodes {
  std::vector<double> times;
  std::vector<FlowState> states, velocities;

  void add(double t, Point at) {
    times.push_back(t);
    states.push_back({at.x, at.y});
  }
};

// Points of the connecting orbit at times k h, from where f is nothing to where it is nothing again; t = 0 where U's
// local manifold ends.
class ConnectingTrajectory {
 public:
  ConnectingTrajectory(const Flow& flow, const LocalBranch& u, const LocalBranch& s, const IntegrationOptions& options)
      : flow_(flow), u_(u), s_(s), options_(options.finer()) {}

  [[nodiscard]] QuadratureNodes nodes(double h) {
    QuadratureNodes list;
    add_points(list, h);
    list.velocities.resize(list.states.size());
    flow_.velocities(list.states, std::vector<double>(list.states.size(), 0), list.velocities);
    return list;
  }
  [[nodiscard]] double gap() const { return gap_; }

 private:
  void add_points(QuadratureNodes& list, double h) {
    const auto back = static_cast<long>(-elementary::log(least_departure) / (u_.rate * h));
    for (long k = -back; k < 0; ++k) {
      const double t = static_cast<double>(k) * h;
      list.add(t, u_.at(u_.local.reach * elementary::exp(u_.rate * t)));
    }
    const Point begin = u_.at(u_.local.reach);
    std::array<FlowState, 1> state{FlowState{begin.x, begin.y}};
    // The way between the local manifolds takes no longer than the way along them, by far.
    const double latest = 100 / u_.rate + 100 / s_.rate;
    for (long k = 0;; ++k) {
      const double t = static_cast<double>(k) * h;
      const Point at = as_point(state[0]);
      if (!std::isfinite(at.x) || t > latest) {
        throw DataError("without the perturbation U does not lead to the other saddle: no orbit connects them");
      }
      if (const double s = nearest(s_, at); s > 0) {
        const Point on = s_.at(s);
        gap_ = length({on.x - at.x, on.y - at.y});
        if (gap_ <= max_gap * (1 + length(at))) {
          const auto forward = static_cast<long>(-elementary::log(least_departure) / (s_.rate * h));
          for (long j = 0; j < forward; ++j) {
            const double later = static_cast<double>(j) * h;
            list.add(t + later, s_.at(s * elementary::exp(-s_.rate * later)));
          }
          return;
        }
      }
      list.add(t, at);
      flow_.integrate(state, 0, h, options_);
    }
  }

  const Flow& flow_;
  const LocalBranch &u_, &s_;
  IntegrationOptions options_;
  double gap_ = 0;
};

// M at j T / samples, by the trapezoidal rule.
std::vector<double> samples_of(const QuadratureNodes& nodes, double h, const Perturbation& g, double period,
                               std::size_t samples) {
  std::vector<double> values(samples), times(nodes.times.size());
  for (std::size_t j = 0; j < samples; ++j) {
    const double t0 = period * static_cast<double>(j) / static_cast<double>(samples);
    double sum = 0;
    for (std::size_t k = 0; k < times.size(); ++k) times[k] = std::fmod(nodes.times[k] + t0, period);
    const std::vector<Point> perturbations = g(nodes.states, times);
    for (std::size_t k = 0; k < times.size(); ++k) sum += cross(as_point(nodes.velocities[k]), perturbations[k]);
    values[j] = h * sum;
  }
  return values;
}

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::fabs(value));
  return largest;
}

// Coefficients of the trigonometric polynomial through an even number of samples; the highest cosine is left out.
void expand(const std::vector<double>& values, Melnikov& result) {
  const std::size_t n = values.size();
  result.cosines.assign(n / 2, 0);
  result.sines.assign(n / 2, 0);
  for (std::size_t k = 0; k < n / 2; ++k) {
    for (std::size_t j = 0; j < n; ++j) {
      const double angle = 2 * std::numbers::pi * static_cast<double>((j * k) % n) / static_cast<double>(n);
      const double weight = (k == 0 ? 1.0 : 2.0) / static_cast<double>(n);
      result.cosines[k] += weight * values[j] * elementary::cos(angle);
      result.sines[k] += weight * values[j] * elementary::sin(angle);
    }
  }
  result.sines[0] = 0;
}

double angle_of(const Melnikov& m, std::size_t k, double t0) {
  return 2 * std::numbers::pi * static_cast<double>(k) * t0 / m.period;
}

double slope_at(const Melnikov& m, double t0) {
  double sum = 0;
  for (std::size_t k = 1; k < m.cosines.size(); ++k) {
    const double angle = angle_of(m, k, t0);
    sum += 2 * std::numbers::pi * static_cast<double>(k) / m.period *
           (m.sines[k] * elementary::cos(angle) - m.cosines[k] * elementary::sin(angle));
  }
  return sum;
}

// The primitive of M, from 0 on.
double primitive_at(const Melnikov& m, double t0) {
  double sum = m.cosines[0] * t0;
  for (std::size_t k = 1; k < m.cosines.size(); ++k) {
    const double angle = angle_of(m, k, t0), frequency = 2 * std::numbers::pi * static_cast<double>(k) / m.period;
    sum += (m.cosines[k] * elementary::sin(angle) + m.sines[k] * (1 - elementary::cos(angle))) / frequency;
  }
  return sum;
}

// The largest |M| at the nodes of a grid, and where M has no slope between two of them.
double largest_value(const Melnikov& m) {
  const std::size_t pieces = 32 * m.cosines.size();
  double largest = 0;
  for (std::size_t k = 0; k < pieces; ++k) {
    double low = m.period * static_cast<double>(k) / static_cast<double>(pieces);
    double high = m.period * static_cast<double>(k + 1) / static_cast<double>(pieces);
    const bool rising = slope_at(m, low) >= 0;
    if (rising != (slope_at(m, high) >= 0)) {
      for (int round = 0; round < 40; ++round) {
        const double middle = 0.5 * (low + high);
        ((slope_at(m, middle) >= 0) == rising ? low : high) = middle;
      }
    }
    largest = std::max(largest, std::fabs(m.at(low)));
  }
  return largest;
}

void find_zeros(Melnikov& m) {
  // A trigonometric polynomial has at most twice as many zeros as terms.
  const std::size_t pieces = 32 * m.cosines.size();
  const auto time = [&](std::size_t k) { return m.period * static_cast<double>(k) / static_cast<double>(pieces); };
  if (m.largest <= 10 * m.error) return;
  for (std::size_t k = 0; k < pieces; ++k) {
    double low = time(k), high = time(k + 1);
    const bool above = m.at(low) >= 0;
    if (above == (m.at(high) >= 0)) continue;
    for (int round = 0; round < 80; ++round) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) break;
      ((m.at(middle) >= 0) == above ? low : high) = middle;
    }
    m.zeros.push_back({high >= m.period ? 0 : high, slope_at(m, high)});
  }
  std::sort(m.zeros.begin(), m.zeros.end(), [](const MelnikovZero& a, const MelnikovZero& b) { return a.t0 < b.t0; });
  for (std::size_t k = 0; k < m.zeros.size(); ++k) {
    const double begin = m.zeros[k].t0;
    const double end = k + 1 < m.zeros.size() ? m.zeros[k + 1].t0 : m.zeros[0].t0 + m.period;
    m.lobes.push_back({begin, end, primitive_at(m, end) - primitive_at(m, begin)});
  }
}

void require_family(const Flow& flow) {
  if (flow.dimension() != 2 || !(flow.period() > 0)) {
    throw UsageError("Melnikov's function needs a planar flow that is periodic in time");
  }
  if (flow.conjugate_pairs().empty()) {
    throw UsageError("Melnikov's function needs a flow with a Hamiltonian where the perturbation is 0");
  }
}

}  // namespace

double Melnikov::at(double t0) const {
  double sum = cosines[0];
  for (std::size_t k = 1; k < cosines.size(); ++k) {
    const double angle = angle_of(*this, k, t0);
    sum += cosines[k] * elementary::cos(angle) + sines[k] * elementary::sin(angle);
  }
  return sum;
}

Melnikov::Sides Melnikov::lobe_areas(double eps) const {
  Sides sides;
  for (const MelnikovLobe& lobe : lobes) {
    const double area = -eps * lobe.integral;
    (area > 0 ? sides.left : sides.right) += std::fabs(area);
  }
  return sides;
}

Melnikov melnikov(const FlowFamily& family, const Connection& connection, const IntegrationOptions& options) {
  const std::shared_ptr<const Flow> flow = family(0);
  require_family(*flow);
  const Perturbation g(family);
  Melnikov result;
  result.period = flow->period();
  const auto map = flow->stroboscopic_map(0, options);
  // From the saddles of the perturbed map Newton's method finds equilibria of the flow; for fixed points of the map,
  // which stretches much more, they may be too far away.
  const auto saddle = [&](Point guess) { return equilibrium_near(*flow, {guess.x, guess.y}, 0).at; };
  const LocalBranch u(*map, saddle(connection.from), ManifoldSide::unstable, connection.u_direction, result.period);
  const LocalBranch s(*map, saddle(connection.to), ManifoldSide::stable, connection.s_direction, result.period);
  result.from = u.local.saddle;
  result.to = s.local.saddle;
  ConnectingTrajectory orbit(*flow, u, s, options);
  // Halve the step until M no longer changes, then double the samples until they resolve it.
  double h = std::min({0.5 / u.rate, 0.5 / s.rate, result.period / 16});
  std::size_t samples = 16;
  std::vector<double> values = samples_of(orbit.nodes(h), h, g, result.period, samples);
  double change = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 6 && change > sufficient * largest_of(values); ++round) {
    h *= 0.5;
    const std::vector<double> finer = samples_of(orbit.nodes(h), h, g, result.period, samples);
    double difference = 0;
    for (std::size_t k = 0; k < samples; ++k) difference = std::max(difference, std::fabs(finer[k] - values[k]));
    values = finer;
    if (round > 1 && difference >= change) break;  // rounding
    change = difference;
  }
  const QuadratureNodes nodes = orbit.nodes(h);
  // Rounding alone: what cancels in the sums.
  double size = 0;
  const std::vector<Point> perturbations = g(nodes.states, nodes.times);
  for (std::size_t k = 0; k < perturbations.size(); ++k)
    size += h * length(as_point(nodes.velocities[k])) * length(perturbations[k]);
  for (;; samples *= 2) {
    expand(values, result);
    const std::size_t n = result.cosines.size();
    double tail = 0, all = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const double term = std::hypot(result.cosines[k], result.sines[k]);
      all = std::max(all, term);
      if (k >= 3 * n / 4) tail = std::max(tail, term);
    }
    result.error = change + tail + orbit.gap() * size + 1e-13 * size;
    if (tail <= std::max(sufficient * all, 1e-14 * size) || samples >= 1024) break;
    values = samples_of(nodes, h, g, result.period, 2 * samples);
  }
  result.largest = largest_value(result);
  find_zeros(result);
  return result;
}

}  // namespace lober

// Whether the functions of a vector field belong together: its velocity, Jacobian, Hamiltonian, period and lattice.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/base/text.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "engine/dynamics/systems/library_checks.hpp"
#include "engine/dynamics/systems/library_differences.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

class FlowChecks {
 public:
  FlowChecks(const VectorField& field, const System& made)
      : field_(field),
        made_(made),
        name_(made.info.name),
        hamiltonian_(!field.conjugate_pairs().empty()),
        dimension_(static_cast<std::size_t>(field.dimension())) {}

  void at(const FlowState& x, double t) {
    const FlowState speed = velocity(x, t);
    if (!finite(x) || !finite(speed)) return;
    ++velocities_;
    if (field_.has_jacobian()) check_jacobian(x, t);
    if (hamiltonian_) check_hamiltonian(x, t, speed);
    if (field_.batch() > 1) check_batch(x, t, speed);
    if (made_.flow->period() > 0) {
      check_same(x, t, speed, x, t + made_.flow->period(), "a period of " + format_number(made_.flow->period()));
    }
    if (dimension_ != 2) return;
    for (const Point shift : {made_.lattice, made_.second_lattice}) {
      if (shift == Point{}) continue;
      const FlowState there{x[0] + shift.x, x[1] + shift.y};
      check_same(x, t, speed, there, t, "the shift " + format_point(shift) + " of its lattice");
    }
  }
  // Functions that never give a number are slips; those that fail at some points may be right.
  void require_numbers() const {
    const auto need = [&](std::size_t found, const char* what) {
      if (velocities_ == 0 || found > 0) return;
      throw DataError(system_prefix(name_) + what +
                      " fails, or gives no number, at all points of the window that have a velocity");
    };
    if (field_.has_jacobian()) need(jacobians_, "jacobian");
    if (hamiltonian_) need(energies_, "hamiltonian, or a factor of its pairs,");
  }

 private:
  [[nodiscard]] FlowState velocity(const FlowState& x, double t) const {
    FlowState speed{};
    field_.velocities(1, x.data(), &t, speed.data());
    return speed;
  }
  [[nodiscard]] bool finite(const FlowState& x) const {
    return std::all_of(x.begin(), x.begin() + field_.dimension(), [](double value) { return std::isfinite(value); });
  }
  [[nodiscard]] double size(const FlowState& x) const {
    double largest = 0;
    for (std::size_t k = 0; k < dimension_; ++k) largest = std::max(largest, std::fabs(x[k]));
    return largest;
  }
  [[nodiscard]] std::string position_text(const FlowState& x, double t) const {
    std::string text = "(";
    for (std::size_t k = 0; k < dimension_; ++k) text += (k == 0 ? "" : ", ") + format_number(x[k]);
    return text + "), t = " + format_number(t);
  }

  // The velocity at another state and time where it has to be the same.
  void check_same(const FlowState& x, double t, const FlowState& speed, const FlowState& there, double then,
                  const std::string& shift) const {
    const FlowState other = velocity(there, then);
    if (!finite(other)) return;
    for (std::size_t k = 0; k < dimension_; ++k) {
      if (std::fabs(other[k] - speed[k]) <= symmetry_accuracy * (size(speed) + size(other))) continue;
      throw DataError(system_prefix(name_) + "the velocity does not repeat after " + shift + ": component " +
                      std::to_string(k) + " is " + format_number(speed[k]) + " at " + position_text(x, t) + ", but " +
                      format_number(other[k]) + " at " + position_text(there, then));
    }
  }

  void check_jacobian(const FlowState& x, double t) {
    std::vector<double> jacobian(dimension_ * dimension_);
    field_.jacobians(1, x.data(), &t, jacobian.data());
    if (!std::all_of(jacobian.begin(), jacobian.end(), [](double entry) { return std::isfinite(entry); })) return;
    ++jacobians_;
    double largest = 0;
    for (const double entry : jacobian) largest = std::max(largest, std::fabs(entry));
    for (std::size_t i = 0; i < dimension_; ++i) {
      for (std::size_t j = 0; j < dimension_; ++j) {
        const Slope slope = slope_of(
            [&](double value) {
              FlowState moved = x;
              moved[j] = value;
              return velocity(moved, t)[i];
            },
            x[j], size_within(extent_of(made_.window), size(x)));
        const double given = jacobian[i * dimension_ + j];
        if (differs(given, slope, largest)) {
          throw_discrepancy(name_, "the Jacobian d(velocity " + std::to_string(i) + ")/d(x " + std::to_string(j) + ")",
                            position_text(x, t), {"it is", given},
                            {"finite differences of velocity give", slope.value});
        }
      }
    }
  }

  // factor dq/dt = dH/dp, factor dp/dt = -dH/dq.
  void check_hamiltonian(const FlowState& x, double t, const FlowState& speed) {
    for (const ConjugatePair& pair : field_.conjugate_pairs()) {
      const double factor = pair.factor;
      const auto slope = [&](int coordinate) {
        const auto j = static_cast<std::size_t>(coordinate);
        return slope_of(
            [&](double value) {
              FlowState moved = x;
              moved[j] = value;
              double energy = std::nan("");
              field_.hamiltonians(1, moved.data(), &t, &energy);
              return energy;
            },
            x[j], size_within(extent_of(made_.window), size(x)));
      };
      const auto check = [&](int moving, double sign, int by) {
        Slope expected = slope(by);
        expected.value *= sign;
        if (std::isfinite(expected.value) && std::isfinite(factor)) ++energies_;
        const double given = factor * speed[static_cast<std::size_t>(moving)];
        if (differs(given, expected, std::fabs(factor) * size(speed))) {
          throw_discrepancy(name_, "the Hamiltonian, or the velocity " + std::to_string(moving) + ",",
                            position_text(x, t), {sign > 0 ? "dH/dp is" : "-dH/dq is", expected.value},
                            {"the velocity times its factor is", given});
        }
      };
      check(pair.q, 1, pair.p);
      check(pair.p, -1, pair.q);
    }
  }

  // Checks the batch for two points at a time, this one second.
  void check_batch(const FlowState& x, double t, const FlowState& speed) const {
    std::vector<double> from(2 * dimension_), to(2 * dimension_);
    for (std::size_t k = 0; k < dimension_; ++k) {
      from[2 * k] = 0.5 * x[k];
      from[2 * k + 1] = x[k];
    }
    const std::array<double, 2> times{0.5 * t, t};
    field_.velocities(2, from.data(), times.data(), to.data());
    for (std::size_t k = 0; k < dimension_; ++k) {
      if (std::fabs(to[2 * k + 1] - speed[k]) <= 1e-9 * (1 + size(speed))) continue;
      throw_discrepancy(name_, "velocity_batch, component " + std::to_string(k) + ",", position_text(x, t),
                        {"it is", to[2 * k + 1]}, {"velocity gives", speed[k]});
    }
  }

  const VectorField& field_;
  const System& made_;
  const std::string& name_;
  bool hamiltonian_;
  std::size_t dimension_;
  std::size_t velocities_ = 0, jacobians_ = 0, energies_ = 0;  // points that have them
};

// Points of a plane flow lie in the window, those of a return map on the section; of others nothing is known.
std::vector<FlowState> flow_states(const System& made, double energy) {
  std::vector<FlowState> states;
  for (const Point& z : window_points(made.window)) {
    if (made.section) {
      states.push_back(made.flow->on_section(*made.section, energy, z));
    } else {
      states.push_back({z.x, z.y, 0.3 * z.x - 0.2 * z.y, 0.1 * z.x + 0.4 * z.y, 0.2 * z.x, 0.3 * z.y});
    }
  }
  return states;
}

}  // namespace

void check_flow(const VectorField& field, const System& made, double energy) {
  FlowChecks checks(field, made);
  const double period = made.flow->period();
  for (const FlowState& x : flow_states(made, energy)) {
    for (const double phase : {0.0, 0.3}) {
      checks.at(x, phase * period);
      if (period == 0) break;
    }
  }
  checks.require_numbers();
}

}  // namespace lober::detail

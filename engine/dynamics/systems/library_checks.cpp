#include "engine/dynamics/systems/library_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "engine/base/text.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

// Allowed errors of finite differences and of an iterated inverse, as fractions; slips are far larger.
constexpr double accuracy = 1e-4;
constexpr double inverse_accuracy = 1e-6;
constexpr double symmetry_accuracy = 1e-6;  // after a shift by the lattice, or by the period in time
constexpr int points_a_side = 5;            // points of the window along each axis

std::string prefix(const lober_system& system) {
  return std::string("system ") + system.name + ": ";
}

// "system NAME: WHAT is wrong at WHERE: GIVEN, but EXPECTED", both with their numbers.
struct Named {
  const char* name;
  double value;
};
[[noreturn]] void report(const lober_system& system, const std::string& what, const std::string& where, Named given,
                         Named expected) {
  throw DataError(prefix(system) + what + " is wrong at " + where + ": " + given.name + " " +
                  format_number(given.value) + ", but " + expected.name + " " + format_number(expected.value));
}

// A derivative by central differences, with an estimate of its error.
struct Slope {
  double value, error;
};
Slope slope_of(const std::function<double(double)>& function, double at, double scale) {
  const auto central = [&](double h) {
    const double low = at - h, high = at + h;
    return (function(high) - function(low)) / (high - low);
  };
  const double step = 1e-4 * scale, coarse = central(step), fine = central(0.5 * step);
  return {fine + (fine - coarse) / 3, std::fabs(fine - coarse)};
}

// Where differences cannot be formed, or where they converge badly, nothing is said.
bool differs(double given, Slope slope, double size) {
  if (!std::isfinite(given) || !std::isfinite(slope.value)) return false;
  return std::fabs(given - slope.value) > accuracy * (size + std::fabs(slope.value)) + 10 * slope.error;
}

std::vector<Point> window_points(const Rectangle& window) {
  std::vector<Point> points;
  if (!(window.width() > 0 && window.height() > 0)) return points;
  // Off the middle and off round fractions, where symmetries hide slips.
  for (int i = 0; i < points_a_side; ++i) {
    for (int j = 0; j < points_a_side; ++j) {
      points.push_back({window.min_x + window.width() * (i + 0.37) / points_a_side,
                        window.min_y + window.height() * (j + 0.61) / points_a_side});
    }
  }
  return points;
}

class MapChecks {
 public:
  MapChecks(const lober_system& system, const System& made, std::span<const double> parameters)
      : system_(system), made_(made), map_(*system.map), parameters_(parameters.data()) {}

  void at(Point z) {
    const Point image = apply(map_.forward, z);
    if (!is_finite(image)) return;
    ++images_;
    std::array<double, 4> d{};
    const std::array<double, 2> from{z.x, z.y};
    if (map_.derivative(parameters_, from.data(), d.data()) != 0) return;
    if (!std::all_of(d.begin(), d.end(), [](double entry) { return std::isfinite(entry); })) return;
    ++derivatives_;
    check_derivative(z, d);
    check_inverse(z, image, d);
    for (const Point shift : {made_.lattice, made_.second_lattice}) check_lattice(z, image, shift, d);
    if (map_.action != nullptr) check_action(z, image);
  }
  // A function that never gives a number is a slip; one that fails at some points may be right.
  void require_numbers() const {
    if (images_ == 0 || derivatives_ > 0) return;
    throw DataError(prefix(system_) +
                    "derivative fails, or gives no number, at all points of the window that have images");
  }

 private:
  [[nodiscard]] Point apply(int (*function)(const double*, const double*, double*), Point z) const {
    const std::array<double, 2> from{z.x, z.y};
    std::array<double, 2> to{};
    return function(parameters_, from.data(), to.data()) != 0 ? lost_point : Point{to[0], to[1]};
  }

  void check_derivative(Point z, const std::array<double, 4>& d) const {
    constexpr std::array names{"dx'/dx", "dx'/dy", "dy'/dx", "dy'/dy"};
    const double size = std::fabs(d[0]) + std::fabs(d[1]) + std::fabs(d[2]) + std::fabs(d[3]);
    for (std::size_t k = 0; k < 4; ++k) {
      const bool by_x = k % 2 == 0;
      const Slope slope = slope_of(
          [&](double value) {
            const Point image = apply(map_.forward, by_x ? Point{value, z.y} : Point{z.x, value});
            return k < 2 ? image.x : image.y;
          },
          by_x ? z.x : z.y, size_within(extent_of(made_.window), length(z)));
      if (differs(d[k], slope, size)) {
        report(system_, std::string("the derivative ") + names[k], format_point(z), {"it is", d[k]},
               {"finite differences of forward give", slope.value});
      }
    }
  }

  void check_inverse(Point z, Point image, const std::array<double, 4>& d) const {
    const Point back = apply(map_.backward, image);
    if (!is_finite(back)) {
      throw DataError(prefix(system_) + "backward fails at " + format_point(image) + ", the image of " +
                      format_point(z));
    }
    // The inverse stretches the rounding of the image.
    const double determinant = std::fabs(d[0] * d[3] - d[1] * d[2]);
    const double norm = std::max({std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2]), std::fabs(d[3]), determinant});
    const double stretch = determinant > 0 ? 1 + norm / determinant : 1 / accuracy;
    const double gap = length({back.x - z.x, back.y - z.y});
    if (gap <= inverse_accuracy * stretch * (size_within(extent_of(made_.window), length(z)) + length(image))) return;
    throw DataError(prefix(system_) + "backward is not the inverse of forward: it takes the image of " +
                    format_point(z) + " to " + format_point(back));
  }

  void check_lattice(Point z, Point image, Point shift, const std::array<double, 4>& d) const {
    if (shift == Point{}) return;
    const Point there = apply(map_.forward, {z.x + shift.x, z.y + shift.y});
    if (!is_finite(there)) return;
    const double stretch = 1 + std::fabs(d[0]) + std::fabs(d[1]) + std::fabs(d[2]) + std::fabs(d[3]);
    const double gap = length({there.x - image.x - shift.x, there.y - image.y - shift.y});
    if (gap <= symmetry_accuracy * stretch * (length(shift) + length(image))) return;
    throw DataError(prefix(system_) + "the map does not repeat after the shift " + format_point(shift) +
                    " of its lattice: it takes " + format_point(z) + " to " + format_point(image) +
                    ", and the shifted point to " + format_point(there));
  }

  // dL = y' dx' - y dx.
  void check_action(Point z, Point image) const {
    const double scale = size_within(extent_of(made_.window), length(z));
    const Slope to = slope_of([&](double x) { return map_.action(parameters_, z.x, x); }, image.x, scale);
    const Slope from = slope_of([&](double x) { return map_.action(parameters_, x, image.x); }, z.x, scale);
    if (differs(image.y, to, 1)) {
      report(system_, "the action L(x, x')", format_point(z), {"dL/dx' is", to.value}, {"y' is", image.y});
    }
    if (differs(-z.y, from, 1)) {
      report(system_, "the action L(x, x')", format_point(z), {"dL/dx is", from.value}, {"-y is", -z.y});
    }
  }

  const lober_system& system_;
  const System& made_;
  const lober_map& map_;
  const double* parameters_;
  std::size_t images_ = 0, derivatives_ = 0;  // points that have them
};

class FlowChecks {
 public:
  FlowChecks(const lober_system& system, const System& made, std::span<const double> parameters)
      : system_(system),
        made_(made),
        flow_(*system.flow),
        parameters_(parameters.data()),
        dimension_(static_cast<std::size_t>(flow_.dimension)) {}

  void at(const FlowState& x, double t) {
    const FlowState speed = velocity(x, t);
    if (!finite(x) || !finite(speed)) return;
    ++velocities_;
    check_jacobian(x, t);
    if (flow_.hamiltonian != nullptr) check_hamiltonian(x, t, speed);
    if (system_.abi >= 3 && flow_.velocity_batch != nullptr) check_batch(x, t, speed);
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
      throw DataError(prefix(system_) + what +
                      " fails, or gives no number, at all points of the window that have a velocity");
    };
    need(jacobians_, "jacobian");
    if (flow_.hamiltonian != nullptr && flow_.pair_count > 0) need(energies_, "hamiltonian, or a factor of its pairs,");
  }

 private:
  [[nodiscard]] FlowState velocity(const FlowState& x, double t) const {
    FlowState speed{};
    if (flow_.velocity(parameters_, x.data(), t, speed.data()) != 0) speed.fill(std::nan(""));
    return speed;
  }
  [[nodiscard]] bool finite(const FlowState& x) const {
    return std::all_of(x.begin(), x.begin() + flow_.dimension, [](double value) { return std::isfinite(value); });
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
      throw DataError(prefix(system_) + "the velocity does not repeat after " + shift + ": component " +
                      std::to_string(k) + " is " + format_number(speed[k]) + " at " + position_text(x, t) + ", but " +
                      format_number(other[k]) + " at " + position_text(there, then));
    }
  }

  void check_jacobian(const FlowState& x, double t) {
    std::vector<double> jacobian(dimension_ * dimension_);
    if (flow_.jacobian(parameters_, x.data(), t, jacobian.data()) != 0) return;
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
          report(system_, "the Jacobian d(velocity " + std::to_string(i) + ")/d(x " + std::to_string(j) + ")",
                 position_text(x, t), {"it is", given}, {"finite differences of velocity give", slope.value});
        }
      }
    }
  }

  // factor dq/dt = dH/dp, factor dp/dt = -dH/dq.
  void check_hamiltonian(const FlowState& x, double t, const FlowState& speed) {
    for (std::size_t k = 0; k < flow_.pair_count; ++k) {
      const lober_conjugate_pair& pair = flow_.pairs[k];
      const double factor = pair.factor != nullptr ? pair.factor(parameters_) : 1;
      const auto slope = [&](int coordinate) {
        const auto j = static_cast<std::size_t>(coordinate);
        return slope_of(
            [&](double value) {
              FlowState moved = x;
              moved[j] = value;
              return flow_.hamiltonian(parameters_, moved.data(), t);
            },
            x[j], size_within(extent_of(made_.window), size(x)));
      };
      const auto check = [&](int moving, double sign, int by) {
        Slope expected = slope(by);
        expected.value *= sign;
        if (std::isfinite(expected.value) && std::isfinite(factor)) ++energies_;
        const double given = factor * speed[static_cast<std::size_t>(moving)];
        if (differs(given, expected, std::fabs(factor) * size(speed))) {
          report(system_, "the Hamiltonian, or the velocity " + std::to_string(moving) + ",", position_text(x, t),
                 {sign > 0 ? "dH/dp is" : "-dH/dq is", expected.value}, {"the velocity times its factor is", given});
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
    flow_.velocity_batch(parameters_, 2, from.data(), times.data(), to.data());
    for (std::size_t k = 0; k < dimension_; ++k) {
      if (std::fabs(to[2 * k + 1] - speed[k]) <= 1e-9 * (1 + size(speed))) continue;
      report(system_, "velocity_batch, component " + std::to_string(k) + ",", position_text(x, t),
             {"it is", to[2 * k + 1]}, {"velocity gives", speed[k]});
    }
  }

  const lober_system& system_;
  const System& made_;
  const lober_flow& flow_;
  const double* parameters_;
  std::size_t dimension_;
  std::size_t velocities_ = 0, jacobians_ = 0, energies_ = 0;  // points that have them
};

// Points of a plane flow lie in the window, those of a return map on the section; of others nothing is known.
std::vector<FlowState> flow_states(const lober_system& system, const System& made, std::span<const double> parameters) {
  std::vector<FlowState> states;
  for (const Point& z : window_points(made.window)) {
    if (made.section) {
      const int energy = system.flow->section->energy_parameter;
      states.push_back(
          made.flow->on_section(*made.section, energy < 0 ? 0 : parameters[static_cast<std::size_t>(energy)], z));
    } else {
      states.push_back({z.x, z.y, 0.3 * z.x - 0.2 * z.y, 0.1 * z.x + 0.4 * z.y, 0.2 * z.x, 0.3 * z.y});
    }
  }
  return states;
}

}  // namespace

void check_library(const lober_system& system, const System& made, std::span<const double> parameters) {
  if (system.kind == LOBER_MAP) {
    MapChecks checks(system, made, parameters);
    for (const Point& z : window_points(made.window)) checks.at(z);
    checks.require_numbers();
    return;
  }
  FlowChecks checks(system, made, parameters);
  const double period = made.flow->period();
  for (const FlowState& x : flow_states(system, made, parameters)) {
    for (const double phase : {0.0, 0.3}) {
      checks.at(x, phase * period);
      if (period == 0) break;
    }
  }
  checks.require_numbers();
}

}  // namespace lober::detail

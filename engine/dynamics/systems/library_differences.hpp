// The comparisons of library functions with finite differences, and how a discrepancy is reported (private to
// systems/).
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "engine/base/text.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober::detail {

// Allowed errors of finite differences and of repetition, as fractions; slips are far larger.
inline constexpr double difference_accuracy = 1e-4;
inline constexpr double symmetry_accuracy = 1e-6;  // after a shift by the lattice, or by the period in time

/// "system NAME: ".
inline std::string system_prefix(const std::string& name) {
  return "system " + name + ": ";
}

struct NamedNumber {
  const char* name;
  double value;
};
/// Throws DataError: "system NAME: WHAT is wrong at WHERE: GIVEN, but EXPECTED", both with their numbers.
[[noreturn]] inline void throw_discrepancy(const std::string& system, const std::string& what, const std::string& where,
                                           NamedNumber given, NamedNumber expected) {
  throw DataError(system_prefix(system) + what + " is wrong at " + where + ": " + given.name + " " +
                  format_number(given.value) + ", but " + expected.name + " " + format_number(expected.value));
}

/// A derivative by central differences, with an estimate of its error.
struct Slope {
  double value, error;
};
inline Slope slope_of(const std::function<double(double)>& function, double at, double scale) {
  const auto central = [&](double h) {
    const double low = at - h, high = at + h;
    return (function(high) - function(low)) / (high - low);
  };
  const double step = 1e-4 * scale, coarse = central(step), fine = central(0.5 * step);
  return {fine + (fine - coarse) / 3, std::fabs(fine - coarse)};
}

/// Where differences cannot be formed, or where they converge badly, nothing is said.
inline bool differs(double given, Slope slope, double size) {
  if (!std::isfinite(given) || !std::isfinite(slope.value)) return false;
  return std::fabs(given - slope.value) > difference_accuracy * (size + std::fabs(slope.value)) + 10 * slope.error;
}

/// The points of a window at which functions are compared; none for a window without area.
inline std::vector<Point> window_points(const Rectangle& window) {
  constexpr int points_a_side = 5;
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

}  // namespace lober::detail

// The built-in systems, one function each, listed in registry.cpp.
#pragma once

#include <cmath>
#include <functional>
#include <span>

#include "lober/dynamics/systems.hpp"

namespace lober::detail {

/// A system and how it is made from values in the order of info.parameters. `make` fills all but System::info.
struct SystemEntry {
  SystemInfo info;
  std::function<System(std::span<const double> values, const IntegrationOptions& options)> make;
};

SystemEntry abc_entry();
SystemEntry standard_map_entry();
SystemEntry henon_map_entry();
SystemEntry vortex_pair_entry();
SystemEntry first_order_vortex_pair_entry();
SystemEntry duffing_entry();
SystemEntry pendulum_entry();
SystemEntry double_gyre_entry();
SystemEntry capsize_entry();
SystemEntry three_body_entry();

/// A parameter that has to be above 0.
inline Parameter positive(const char* name, double value, const char* meaning) {
  return {name, value, meaning, 0, std::numeric_limits<double>::infinity(), true};
}

/// The size of a perturbation.
inline Parameter perturbation(const char* name, double value, const char* meaning) {
  Parameter parameter{name, value, meaning};
  parameter.perturbation = true;
  return parameter;
}

/// The system of an entry with values by name.
System make_system(const SystemEntry& entry, const ParameterValues& values, const IntegrationOptions& options);

/// z -> linear z + shift as a reversor.
inline Symmetry reversor(const Matrix2& linear, Point shift = {}) {
  return {linear, shift, true};
}

/// Whether time 0 or a quarter of the period lies on the section, or half a period later: forces that are even or odd
/// in time about it give the map a reversor.
inline bool at_half_periods(double phase) {
  return 2 * phase == std::floor(2 * phase);
}
inline bool at_quarter_periods(double phase) {
  return at_half_periods(phase + 0.25);
}

/// A box by its corners.
inline Rectangle window(double min_x, double min_y, double max_x, double max_y) {
  return Rectangle::of({min_x, min_y}, {max_x, max_y});
}

}  // namespace lober::detail

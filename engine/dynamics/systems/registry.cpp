// The list of systems, and systems from names and values.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/nearest_word.hpp"
#include "engine/base/text.hpp"
#include "engine/dynamics/systems/entries.hpp"
#include "engine/dynamics/systems/shared_library.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober {
using namespace detail;

namespace {

std::vector<SystemEntry> entries() {
  return {abc_entry(),
          capsize_entry(),
          double_gyre_entry(),
          duffing_entry(),
          henon_map_entry(),
          vortex_pair_entry(),
          first_order_vortex_pair_entry(),
          three_body_entry(),
          pendulum_entry(),
          standard_map_entry()};
}

template <typename Things, typename Name>
std::vector<std::string> names_of(const Things& things, const Name& name) {
  std::vector<std::string> names;
  names.reserve(things.size());
  for (const auto& thing : things) names.push_back(name(thing));
  return names;
}

void require_in_range(const std::string& system, const Parameter& parameter, double value) {
  if (parameter.allows(value)) return;
  throw UsageError("system " + system + ": parameter " + parameter.name + " must be " + parameter.range() + ", not " +
                   format_number(value));
}

}  // namespace

bool Parameter::allows(double number) const {
  return (min_excluded ? number > min : number >= min) && (max_excluded ? number < max : number <= max);
}

std::string Parameter::range() const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (min == -infinity && max == infinity) return "";
  if (max == infinity) {
    if (min == 0 && min_excluded) return "positive";
    return (min_excluded ? "above " : "at least ") + format_number(min);
  }
  if (min == -infinity) return (max_excluded ? "below " : "at most ") + format_number(max);
  return std::string("in ") + (min_excluded ? "(" : "[") + format_number(min) + ", " + format_number(max) +
         (max_excluded ? ")" : "]");
}

const Parameter* SystemInfo::perturbation() const {
  const auto found =
      std::find_if(parameters.begin(), parameters.end(), [](const Parameter& p) { return p.perturbation; });
  return found == parameters.end() ? nullptr : &*found;
}

Point Symmetry::operator()(Point z) const {
  return {linear.xx * z.x + linear.xy * z.y + shift.x, linear.yx * z.x + linear.yy * z.y + shift.y};
}

System detail::make_system(const SystemEntry& entry, const ParameterValues& values, const IntegrationOptions& options) {
  SystemInfo info = entry.info;
  std::vector<bool> given(info.parameters.size(), false);
  for (const auto& setting : values) {
    const std::string& name = setting.first;
    const double value = setting.second;
    const auto found = std::find_if(info.parameters.begin(), info.parameters.end(),
                                    [&](const Parameter& parameter) { return parameter.name == name; });
    if (found == info.parameters.end()) {
      const auto known = names_of(info.parameters, [](const Parameter& parameter) { return parameter.name; });
      throw UsageError("system " + info.name + " has no parameter '" + name + "'; it has: " + joined(known) +
                       did_you_mean(name, known));
    }
    const auto at = static_cast<std::size_t>(found - info.parameters.begin());
    if (given[at]) throw UsageError("system " + info.name + ": parameter " + name + " is given twice");
    if (!std::isfinite(value)) throw UsageError("system " + info.name + ": parameter " + name + " is not finite");
    require_in_range(info.name, *found, value);
    given[at] = true;
    found->value = value;
  }
  if (!(options.tolerance > 0 && options.tolerance < 1))
    throw UsageError("the tolerance of integration must be in (0, 1)");
  std::vector<double> numbers;
  for (const Parameter& parameter : info.parameters) {
    // Whole periods change nothing but rounding.
    const bool far = parameter.name == "phase" && std::fabs(parameter.value) >= 1;
    numbers.push_back(far ? parameter.value - std::floor(parameter.value) : parameter.value);
  }
  System system = entry.make(numbers, options);
  if (system.picture.empty()) system.picture = system.window;
  system.info = std::move(info);
  return system;
}

bool is_library_path(std::string_view name) {
  return name.find('/') != std::string_view::npos || name.ends_with(".so");
}

std::vector<SystemInfo> list_systems() {
  std::vector<SystemInfo> list;
  for (SystemEntry& entry : entries()) list.push_back(std::move(entry.info));
  return list;
}

System make_system(std::string_view name, const ParameterValues& values, const IntegrationOptions& options) {
  if (is_library_path(name)) {
    return make_system(load_system(std::string(name)), values, options);
  }
  const std::vector<SystemEntry> all = entries();
  for (const SystemEntry& entry : all) {
    if (entry.info.name == name) return make_system(entry, values, options);
  }
  const auto known = names_of(all, [](const SystemEntry& entry) { return entry.info.name; });
  throw UsageError("no system is called '" + std::string(name) + "'; there are: " + joined(known) +
                   ", or the path of a shared library" + did_you_mean(name, known));
}

}  // namespace lober

#include "engine/operations/escape_choice.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "lober/base/error.hpp"

namespace lober::detail::table {
namespace {

std::string quoted(std::string_view key) {
  return "option \"" + std::string(key) + "\"";
}

double finite_number(std::string_view text, std::string_view key) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    throw UsageError(quoted(key) + ": \"" + std::string(text) + "\" is not a number");
  }
  return value;
}

struct Assignment {
  std::string name;
  char separator;
  double value;
};

// "NAME<separator>VALUE"; the separator is any one of those given.
Assignment assignment(const std::string& text, std::string_view key, std::string_view separators) {
  const std::size_t at = text.find_first_of(separators);
  if (at == std::string::npos || at == 0) {
    std::string forms;
    for (const char separator : separators)
      forms += (forms.empty() ? "NAME" : " or NAME") + std::string(1, separator) + "VALUE";
    throw UsageError(quoted(key) + ": \"" + text + "\" is not of the form " + forms);
  }
  return {text.substr(0, at), text[at], finite_number(std::string_view(text).substr(at + 1), key)};
}

// The number of a position, which is called x or y, or as the system calls it.
int position_coordinate(const System& system, const std::string& name, std::string_view key) {
  const auto pairs = system.flow->conjugate_pairs();
  if (pairs.size() != 2) throw UsageError("an escape needs a Hamiltonian flow of two degrees of freedom");
  std::array<std::string, 2> names{"x", "y"};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto coordinate = static_cast<std::size_t>(pairs[k].q);
    if (coordinate < system.coordinates.size()) names[k] = system.coordinates[coordinate];
  }
  for (std::size_t k = 0; k < 2; ++k) {
    if (name == names[k]) return pairs[k].q;
  }
  if (name == "x" || name == "y") return pairs[name == "x" ? 0 : 1].q;
  throw UsageError(quoted(key) + ": the coordinate has to be " + names[0] + " or " + names[1] + ", not \"" + name +
                   "\"");
}

FlowState saddle_of(const std::string& text, const System& system) {
  FlowState state{};
  std::size_t count = 0;
  for (std::size_t begin = 0; begin <= text.size(); ++count) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const double value = finite_number(std::string_view(text).substr(begin, end - begin), "saddle");
    if (count < 4) state[count] = value;
    begin = end + 1;
  }
  if (count == 4) return state;
  if (count == 2) return state_at_rest(*system.flow, {state[0], state[1]});
  const double index = state[0];
  if (count != 1 || !(index >= 1 && index <= static_cast<double>(system.saddles.size())) ||
      index != std::floor(index)) {
    throw UsageError(quoted("saddle") + ": \"" + text +
                     "\" is neither a position X,Y, nor four coordinates, nor the number of a saddle from 1 to " +
                     std::to_string(system.saddles.size()));
  }
  return system.saddles[static_cast<std::size_t>(index) - 1];
}

bool has_energy(const System& system) {
  return std::any_of(system.info.parameters.begin(), system.info.parameters.end(),
                     [](const Parameter& p) { return p.name == "energy"; });
}

}  // namespace

System system_with_energy(const SystemInput& input, const EscapeChoice& choice) {
  System system = choice.energy && input.with && has_energy(*input.system) ? input.with({{"energy", *choice.energy}})
                                                                           : *input.system;
  if (!system.flow) throw UsageError("an escape needs a flow, and system " + system.info.name + " is a map");
  if (system.flow->dimension() != 4 || system.flow->period() != 0) {
    throw UsageError("an escape needs an autonomous Hamiltonian flow of two degrees of freedom, and system " +
                     system.info.name + " is of another kind");
  }
  return system;
}

double energy_of(const EscapeChoice& choice, const System& system) {
  if (choice.energy) return *choice.energy;
  for (const Parameter& parameter : system.info.parameters) {
    if (parameter.name == "energy") return parameter.value;
  }
  throw UsageError(quoted("energy") + " is missing, and system " + system.info.name +
                   " has no parameter energy; give " + quoted("energy"));
}

std::vector<FlowState> saddles_of(const EscapeChoice& choice, const System& system) {
  std::vector<FlowState> saddles = system.saddles;
  if (!choice.saddles.empty()) saddles.clear();
  for (const std::string& text : choice.saddles) saddles.push_back(saddle_of(text, system));
  if (saddles.empty()) {
    throw UsageError(quoted("saddle") + " is missing, and system " + system.info.name + " names no saddles; give " +
                     quoted("saddle"));
  }
  return saddles;
}

Section section_of(const EscapeChoice& choice, const System& system) {
  const Flow& flow = *system.flow;
  if (!choice.section && !system.section) {
    throw UsageError(quoted("section") + " is missing, and system " + system.info.name +
                     " has no section of its own; give " + quoted("section"));
  }
  Section section = system.section.value_or(Section{});
  if (choice.section) {
    const Assignment given = assignment(*choice.section, "section", "=");
    section = position_section(flow, position_coordinate(system, given.name, "section"), given.value, 1);
  }
  if (section.bound_side != 0 && !choice.bound && choice.crossings > 0) {
    throw UsageError("the section of system " + system.info.name +
                     " counts only a part of the crossings, and the table of escape needs all of them; give " +
                     quoted("section") + ", or no crossings (" + quoted("crossings") +
                     " 0) for the orbits and tubes alone");
  }
  if (choice.direction) {
    section.direction = *choice.direction == "+" ? 1 : *choice.direction == "-" ? -1 : 0;
  } else if (choice.crossings == 0 && section.bound_side == 0) {
    section.direction = 0;  // as the table has it, which takes tubes where they cross first
  }
  if (choice.bound) {
    const Assignment given = assignment(*choice.bound, "bound", "<>");
    section.bound_coordinate = position_coordinate(system, given.name, "bound");
    section.bound = given.value;
    section.bound_side = given.separator == '<' ? -1 : 1;
  }
  return section;
}

std::vector<std::string> bottleneck_names(const Escape& result) {
  const auto axis = static_cast<std::size_t>(result.section.coordinate);
  const auto& bottlenecks = result.bottlenecks;
  if (bottlenecks.size() == 2 && bottlenecks[0].orbit.saddle.at[axis] < result.section.value &&
      bottlenecks[1].orbit.saddle.at[axis] > result.section.value) {
    return {"left", "right"};
  }
  std::vector<std::string> names;
  for (std::size_t k = 0; k < bottlenecks.size(); ++k) names.push_back(std::to_string(k + 1));
  return names;
}

}  // namespace lober::detail::table

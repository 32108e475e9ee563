// Shared libraries of systems: they are loaded, and their descriptions are checked.
#include "engine/dynamics/systems/shared_library.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/input_guard.hpp"
#include "engine/base/path_text.hpp"
#include "engine/base/text.hpp"
#include "engine/base/utf8.hpp"
#include "engine/dynamics/systems/loaded_system.hpp"
#include "lober/base/error.hpp"
#include "lober/lober_system.h"

namespace lober::detail {

namespace {

/// The fault in a flow's description, or null.
const char* fault(const lober_flow& flow, std::size_t parameters) {
  if (flow.dimension < 1 || flow.dimension > LOBER_MAX_DIMENSION) return "the dimension is not 1 to 6";
  if (flow.velocity == nullptr) return "the flow has no velocity";
  if (flow.jacobian == nullptr) return "the flow has no jacobian";
  if (flow.pair_count != 0 && flow.pairs == nullptr) return "pairs is null";
  if (flow.hamiltonian != nullptr && flow.pair_count == 0) return "a Hamiltonian needs its conjugate pairs";
  for (std::size_t k = 0; k < flow.pair_count; ++k) {
    const auto inside = [&](int coordinate) { return 0 <= coordinate && coordinate < flow.dimension; };
    if (!inside(flow.pairs[k].q) || !inside(flow.pairs[k].p))
      return "a conjugate pair names a coordinate beyond the dimension";
  }
  if (flow.section != nullptr && flow.section->energy_parameter >= static_cast<int>(parameters)) {
    return "energy_parameter is beyond the list of parameters";
  }
  if (flow.section != nullptr && flow.hamiltonian != nullptr && flow.section->energy_parameter < 0) {
    return "the section of a Hamiltonian flow needs energy_parameter";
  }
  return nullptr;
}

/// Parameters with their ranges and their roles.
std::vector<Parameter> parameters_of(const lober_system& system) {
  std::vector<Parameter> parameters;
  const std::string_view perturbation = system.abi < 4                   ? "eps"
                                        : system.perturbation != nullptr ? system.perturbation
                                                                         : "";
  for (std::size_t k = 0; k < system.parameter_count; ++k) {
    const lober_parameter& given = system.parameters[k];
    Parameter parameter{given.name, given.default_value, given.meaning};
    if (system.abi >= 4 && system.ranges != nullptr) {
      const lober_range& range = system.ranges[k];
      parameter.min = range.min;
      parameter.max = range.max;
      parameter.min_excluded = range.min_excluded != 0;
      parameter.max_excluded = range.max_excluded != 0;
    }
    parameter.perturbation = parameter.name == perturbation;
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

/// The fault in ranges and roles, or empty.
std::string fault(const lober_system& system, const std::vector<Parameter>& parameters) {
  for (const Parameter& parameter : parameters) {
    if (!(parameter.min <= parameter.max)) return "the range of parameter " + parameter.name + " is empty";
    if (!parameter.allows(parameter.value)) {
      return "the default of parameter " + parameter.name + ", " + format_number(parameter.value) +
             ", is outside of its range";
    }
  }
  const bool named = system.abi >= 4 && system.perturbation != nullptr;
  if (named && std::none_of(parameters.begin(), parameters.end(), [](const Parameter& p) { return p.perturbation; })) {
    return std::string("the perturbation is called ") + system.perturbation + ", but no parameter has this name";
  }
  return "";
}

/// The fault in a description, or null.
const char* fault(const lober_system* system) {
  if (system == nullptr) return "lober_system_describe returned null";
  if (system->abi < 1 || system->abi > LOBER_SYSTEM_ABI) return "it was built for another version of lober_system.h";
  if (system->name == nullptr || system->summary == nullptr) return "the name or the summary is null";
  // JSON and Python take nothing else.
  if (!is_utf8(system->name) || !is_utf8(system->summary)) return "the name or the summary is not UTF-8";
  if (system->parameter_count != 0 && system->parameters == nullptr) return "parameters is null";
  for (std::size_t k = 0; k < system->parameter_count; ++k) {
    if (system->parameters[k].name == nullptr || system->parameters[k].meaning == nullptr) {
      return "a parameter's name or meaning is null";
    }
    if (!is_utf8(system->parameters[k].name) || !is_utf8(system->parameters[k].meaning)) {
      return "a parameter's name or meaning is not UTF-8";
    }
  }
  if (system->abi >= 2 && system->connection_count != 0 && system->connection == nullptr) return "connection is null";
  if (system->abi >= 2 && system->connection_count > LOBER_MAX_CONNECTIONS) {
    return "connection_count is more than LOBER_MAX_CONNECTIONS, 64";
  }
  if (system->abi >= 5 && system->saddle_count != 0) {
    if (system->saddle == nullptr) return "saddle is null";
    if (system->saddle_count > LOBER_MAX_SADDLES) return "saddle_count is more than LOBER_MAX_SADDLES, 64";
    const lober_flow* const flow = system->kind == LOBER_FLOW ? system->flow : nullptr;
    if (flow == nullptr || flow->dimension != 4 || flow->period != nullptr || flow->hamiltonian == nullptr) {
      return "saddles are those of an autonomous flow of four dimensions with a Hamiltonian";
    }
  }
  if (!all_finite(system->window)) return "the window has a number that is not finite";
  if (!all_finite(system->lattice) || (system->abi >= 4 && !all_finite(system->second_lattice))) {
    return "the lattice has a number that is not finite";
  }
  switch (system->kind) {
    case LOBER_MAP:
      if (system->map == nullptr) return "map is null";
      if (system->map->forward == nullptr) return "the map has no forward";
      if (system->map->backward == nullptr) return "the map has no backward";
      if (system->map->derivative == nullptr) return "the map has no derivative";
      return nullptr;
    case LOBER_FLOW:
      return system->flow == nullptr ? "flow is null" : fault(*system->flow, system->parameter_count);
  }
  return "kind is neither LOBER_MAP nor LOBER_FLOW";
}

}  // namespace

SystemEntry load_system(const std::string& path) {
  require_no_zero_byte(path);
  // Without a slash dlopen would search the system's folders.
  const std::string file = path.find('/') == std::string::npos ? "./" + path : path;
  void* const handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    throw DataError("cannot load the system: " + std::string(dlerror()) +
                    "; a name with a slash or with the ending .so is that of a shared library");
  }
  note_input(file);
  const Library library(handle, [](void* opened) { dlclose(opened); });
  using Describe = const lober_system* (*)();
  const auto describe = reinterpret_cast<Describe>(dlsym(handle, "lober_system_describe"));
  if (describe == nullptr) throw DataError(path + ": the library exports no function lober_system_describe");
  const lober_system* const system = describe();
  if (const char* const what = fault(system)) throw DataError(path + ": " + what);

  SystemEntry entry;
  entry.info.name = system->name;
  entry.info.summary = system->summary;
  entry.info.library = path;
  entry.info.parameters = parameters_of(*system);
  if (const std::string what = fault(*system, entry.info.parameters); !what.empty())
    throw DataError(path + ": " + what);
  entry.make = [library, system](std::span<const double> values, const IntegrationOptions& options) {
    return make_loaded_system(library, *system, values, options);
  };
  return entry;
}

}  // namespace lober::detail

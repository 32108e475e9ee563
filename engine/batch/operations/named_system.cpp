#include "engine/batch/operations/named_system.hpp"

#include "lober/base/error.hpp"

namespace lober::detail {

void require_for_manifests(const std::string& name) {
  if (name.empty()) throw UsageError("the name of a system is missing");
  if (name.find('/') != std::string::npos || name.ends_with(".so")) {
    throw UsageError("a manifest cannot use systems from shared libraries");
  }
}

System system_of(const std::string& name, const ParameterValues& parameters, double integration_tolerance) {
  require_for_manifests(name);
  IntegrationOptions options;
  options.tolerance = integration_tolerance;
  System system = make_system(name, parameters, options);
  if (!system.map) throw UsageError(name + " has no planar map");
  return system;
}

}  // namespace lober::detail

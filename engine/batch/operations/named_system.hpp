// A system by its name, as manifests give it.
#pragma once

#include <string>

#include "lober/dynamics/systems.hpp"

namespace lober::detail {

/// Throws UsageError for a name that is missing, or that of a shared library.
void require_for_manifests(const std::string& name);
/// A system with a planar map. Throws UsageError for unknown names, for one without, and for shared libraries: what
/// they compute is not known by their name.
[[nodiscard]] System system_of(const std::string& name, const ParameterValues& parameters,
                               double integration_tolerance);

}  // namespace lober::detail

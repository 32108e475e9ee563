// A system by its name, as manifests give it.
#pragma once

#include <string>

#include "lober/systems.hpp"

namespace lober::detail {

/// A system with a planar map. Throws UsageError for unknown names, for one without, and for shared libraries: what
/// they compute is not known by their name.
[[nodiscard]] System system_of(const std::string& name, const ParameterValues& parameters,
                               double integration_tolerance);

}  // namespace lober::detail

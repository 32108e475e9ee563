// Areas of two curves, for overlay, interior and regions.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "lober/overlay/overlay.hpp"

namespace lober::python {

void bind_areas(pybind11::module_& module);

/// Throws UsageError, with the names there are.
[[nodiscard]] Pairing pairing_of(const std::string& name);

}  // namespace lober::python

// Systems for Python: what functions of dynamics take.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "lober/dynamics/systems.hpp"
#include "python/bindings/keywords.hpp"

namespace lober::python {

using SystemHandle = std::shared_ptr<System>;

/// Throws UsageError for a system without a planar map.
[[nodiscard]] const PlanarMap& map_of(const System& system);

/// The common members of systems of one's own: name, summary, values of parameters (that called eps is the size of the
/// perturbation), window and lattice.
void take_description(Keywords& given, System& system);

/// (from, u_direction, to, s_direction, bip or None, corners), points as pairs; lober/_systems.py has the class.
[[nodiscard]] Connection connection_from(const pybind11::tuple& parts);
[[nodiscard]] pybind11::tuple connection_parts(const Connection& connection);

[[nodiscard]] Point point_from(const pybind11::handle& pair);
/// Two corners: (x0, y0, x1, y1). Throws UsageError unless x0 < x1 and y0 < y1.
[[nodiscard]] Rectangle rectangle_from(const pybind11::handle& corners);
[[nodiscard]] pybind11::tuple corners_of(const Rectangle& rectangle);

}  // namespace lober::python

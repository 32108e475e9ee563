// Nodes and crossings as structured arrays.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "lober/overlay/crossings.hpp"

namespace lober::python {

void bind_nodes(pybind11::module_& module);

/// One row for each node in order along C1, with the fields of the JSON of `lober overlay`; `end_...` are those of the
/// end of a shared arc, and of a point the same as without. O(nodes); holds the GIL.
[[nodiscard]] pybind11::array nodes_array(const Crossings& nodes);

}  // namespace lober::python

// One function for each group of bindings.
#pragma once

#include <pybind11/pybind11.h>

namespace lober::python {

void bind_batch(pybind11::module_& module);  ///< only in builds with batches (LOBER_BUILD_BATCH)
void bind_build(pybind11::module_& module);
void bind_files(pybind11::module_& module);
void bind_fixed_points(pybind11::module_& module);
void bind_interior(pybind11::module_& module);
void bind_manifolds(pybind11::module_& module);
void bind_operations(pybind11::module_& module);
void bind_overlaps(pybind11::module_& module);
void bind_overlay(pybind11::module_& module);
void bind_pages(pybind11::module_& module);
void bind_python_field(pybind11::module_& module);
void bind_python_map(pybind11::module_& module);
void bind_regions(pybind11::module_& module);
void bind_shared_run(pybind11::module_& module);  ///< only in builds with batches
void bind_systems(pybind11::module_& module);
void bind_tangle(pybind11::module_& module);

}  // namespace lober::python

// Exceptions of the library as those of the package (lober/errors.py), with the same text.
#pragma once

#include <pybind11/pybind11.h>

namespace lober::python {

void bind_errors(pybind11::module_& module);

}  // namespace lober::python

// Classes whose objects only the library makes.
#pragma once

#include <pybind11/pybind11.h>

namespace lober::python {

/// Takes their __new__ from all classes of the module. An object that no function of the library made holds nothing,
/// and pybind11 would read memory of nobody at the first attribute.
inline void seal_classes(const pybind11::module_& module) {
  for (const auto& item : pybind11::reinterpret_borrow<pybind11::dict>(module.attr("__dict__"))) {
    if (PyType_Check(item.second.ptr()) == 0) continue;
    auto* const type = reinterpret_cast<PyTypeObject*>(item.second.ptr());
    type->tp_new = nullptr;
    PyType_Modified(type);
  }
}

}  // namespace lober::python

// How this module was built and how it runs, for lober.show_versions().
#include <string>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/cpu.hpp"
#include "python/bindings/module.hpp"

namespace lober::python {
namespace {

namespace py = pybind11;

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "GCC " __VERSION__;
#else
  return "unknown";
#endif
}

py::dict build() {
  py::dict parts;
  parts["compiler"] = compiler();
  parts["instruction_set"] =
      lober::detail::instruction_set_names()[static_cast<std::size_t>(lober::detail::instruction_set())];
  parts["threads"] = lober::detail::concurrency();
  return parts;
}

}  // namespace

void bind_build(py::module_& module) {
  module.def("build", build);
}

}  // namespace lober::python

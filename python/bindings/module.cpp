// The private extension module lober._lober. Its functions take arrays that lober/_arrays.py has made fit; the package
// lober gives them names, defaults and documentation.
#include "python/bindings/module.hpp"

#include "lober/base/version.hpp"
#include "python/bindings/areas.hpp"
#include "python/bindings/errors.hpp"
#include "python/bindings/nodes.hpp"
#include "python/bindings/sealed.hpp"

PYBIND11_MODULE(_lober, module) {
  using namespace lober::python;
  module.attr("__version__") = lober::version();
  bind_errors(module);
  bind_areas(module);
  bind_nodes(module);
  bind_overlay(module);
  bind_overlaps(module);
  bind_interior(module);
  bind_regions(module);
  bind_tangle(module);
  bind_build(module);
  bind_files(module);
  bind_systems(module);
  bind_python_field(module);
  bind_python_map(module);
  bind_fixed_points(module);
  bind_manifolds(module);
  bind_operations(module);
#ifdef LOBER_PYTHON_BATCH
  bind_batch(module);
  bind_shared_run(module);
#endif
  bind_pages(module);
  seal_classes(module);
}

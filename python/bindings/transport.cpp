// Tangles grown from a map.
#include "lober/tangle/manifold_tangle.hpp"

#include <pybind11/stl.h>

#include "python/bindings/agreement.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/system.hpp"
#include "python/bindings/tangle.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

// The tangle as a handle, and what is known beside it.
py::tuple tangle_of(const System& system, const py::tuple& connection, const py::object& bip_near, double tolerance,
                    int before, int after, bool smooth, int max_iterates, std::size_t max_points, double max_work,
                    int threads, const py::object& progress) {
  const ProgressCallback callback(progress);
  const PlanarMap& map = map_of(system);
  const Connection between = connection_from(connection);
  ManifoldTangleOptions options;
  options.tolerance = tolerance;
  options.before = before;
  options.after = after;
  options.smooth = smooth;
  options.max_iterates = max_iterates;
  options.max_points = max_points;
  options.max_work = max_work;
  if (!bip_near.is_none()) options.bip_near = point_from(bip_near);
  options.progress = text_progress(callback);
  std::shared_ptr<ManifoldTangle> grown =
      long_call(threads, [&] { return std::shared_ptr<ManifoldTangle>(grow_tangle(map, between, options)); });
  py::dict more;
  more["bip"] = grown->bip;
  more["tolerance"] = grown->tolerance;
  more["areas_by_action"] = array_of(std::vector<double>(grown->areas_by_action));
  more["action_errors"] = array_of(std::vector<double>(grown->action_errors));
  more["saddles"] = py::make_tuple(pair_of(grown->local_u.saddle), pair_of(grown->local_s.saddle));
  more["multipliers"] = py::make_tuple(grown->local_u.multiplier, grown->local_s.multiplier);
  more["point_errors"] = py::make_tuple(grown->point_errors_u[grown->bip], grown->point_errors_s[grown->bip]);
  more["comparisons"] = comparisons_of(agreement_of(*grown));
  TangleHandle handle{grown->tangle, smooth, grown};
  return py::make_tuple(std::move(handle), more);
}

}  // namespace

void bind_transport(py::module_& module) {
  module.def("grow_tangle", tangle_of, py::arg("system"), py::arg("connection"), py::arg("bip_near"),
             py::arg("tolerance"), py::arg("before"), py::arg("after"), py::arg("smooth"), py::arg("max_iterates"),
             py::arg("max_points"), py::arg("max_work"), py::arg("threads"), py::arg("progress"));
}

}  // namespace lober::python

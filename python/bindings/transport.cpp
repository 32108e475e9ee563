// Tangles grown from a map, and transport.
#include "lober/transport.hpp"

#include <pybind11/stl.h>

#include <limits>

#include "lober/manifold_tangle.hpp"
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

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// Steps x regions x regions, NaN where a route does not lead: values, errors.
py::tuple matrices(const std::vector<TransportStep>& steps, std::size_t regions, RegionMatrix TransportStep::*member) {
  const std::array<py::ssize_t, 3> shape{static_cast<py::ssize_t>(steps.size()), static_cast<py::ssize_t>(regions),
                                         static_cast<py::ssize_t>(regions)};
  py::array_t<double> values(shape), errors(shape);
  double* value = values.mutable_data();
  double* error = errors.mutable_data();
  for (const TransportStep& step : steps) {
    const RegionMatrix& matrix = step.*member;
    for (std::size_t i = 0; i < regions; ++i) {
      for (std::size_t j = 0; j < regions; ++j) {
        const bool known = matrix.size() == regions;
        *value++ = known ? matrix(i, j).value : unknown;
        *error++ = known ? matrix(i, j).error : unknown;
      }
    }
  }
  return py::make_tuple(values, errors);
}

py::tuple pair_of(Measured measured) {
  return py::make_tuple(measured.value, measured.error);
}

py::dict transport_of(const System& system, const py::tuple& connection, const py::object& bip_near,
                      const py::list& further, int iterates, double tolerance, std::size_t max_points, double max_work,
                      std::uint64_t particles, std::uint64_t seed, int threads, const py::object& progress) {
  const ProgressCallback callback(progress);
  const PlanarMap& map = map_of(system);
  const Connection first = connection_from(connection);
  TransportOptions options;
  options.iterates = iterates;
  options.tolerance = tolerance;
  if (!bip_near.is_none()) options.bip_near = point_from(bip_near);
  options.max_points = max_points;
  options.max_work = max_work;
  options.lattice = system.lattice;
  options.particles = particles;
  options.seed = seed;
  for (const py::handle other : further) options.further.push_back(connection_from(other.cast<py::tuple>()));
  options.progress = text_progress(callback);
  const Transport found = long_call(threads, [&] { return transport(map, first, options); });
  const std::size_t regions = found.regions.size();
  py::list areas, boundaries;
  for (const Region& region : found.regions) areas.append(py::make_tuple(pair_of(region.area), region.bounded));
  for (const TransportBoundary& boundary : found.boundaries) {
    py::dict one;
    one["enclosed"] = pair_of(boundary.enclosed);
    one["flux12"] = pair_of(boundary.flux12);
    one["flux21"] = pair_of(boundary.flux21);
    one["lobe_area12"] = pair_of(boundary.lobe_area12);
    one["lobe_area21"] = pair_of(boundary.lobe_area21);
    one["lobe_area12_by_action"] = boundary.lobe_area12_by_action;
    one["lobe_area21_by_action"] = boundary.lobe_area21_by_action;
    one["outline"] = array_of(boundary_curve(*boundary.manifolds));
    boundaries.append(one);
  }
  py::dict result;
  result["n"] = py::cast(found.steps.size());
  result["regions"] = areas;
  result["boundaries"] = boundaries;
  result["flux"] = matrices(found.steps, regions, &TransportStep::flux);
  result["total"] = matrices(found.steps, regions, &TransportStep::total);
  result["by_boundaries"] = matrices(found.steps, regions, &TransportStep::by_boundaries);
  result["by_particles"] = matrices(found.steps, regions, &TransportStep::by_particles);
  result["iterates_a_step"] = found.iterates_a_step;
  result["remarks"] = found.remarks;
  result["comparisons"] = comparisons_of(found.agreement);
  return result;
}

}  // namespace

void bind_transport(py::module_& module) {
  module.def("grow_tangle", tangle_of, py::arg("system"), py::arg("connection"), py::arg("bip_near"),
             py::arg("tolerance"), py::arg("before"), py::arg("after"), py::arg("smooth"), py::arg("max_iterates"),
             py::arg("max_points"), py::arg("max_work"), py::arg("threads"), py::arg("progress"));
  module.def("transport", transport_of, py::arg("system"), py::arg("connection"), py::arg("bip_near"),
             py::arg("further"), py::arg("iterates"), py::arg("tolerance"), py::arg("max_points"), py::arg("max_work"),
             py::arg("particles"), py::arg("seed"), py::arg("threads"), py::arg("progress"));
}

}  // namespace lober::python

#include "lober/overlay/interior.hpp"

#include <cmath>

#include "python/bindings/areas.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/nodes.hpp"
#include "python/bindings/outcome.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

// Checks that the binding has to make, as those who index a curve answer for it.
IndexedCurve indexed(const ClosedCurve& curve, std::span<const Point> points) {
  validate(curve, "curve");
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!std::isfinite(points[k].x) || !std::isfinite(points[k].y)) {
      throw DataError("points: point " + std::to_string(k) + " is not finite");
    }
  }
  return IndexedCurve(curve);
}

// Winding numbers, and which points lie on the curve.
py::tuple windings_of(const Array& curve, const Array& points, int threads) {
  const std::span<const Point> at = points_of(points);
  const ClosedCurve closed = closed_curve(curve);
  const std::vector<Winding> found = long_call(threads, [&] { return windings(indexed(closed, at), at); });
  std::vector<std::int32_t> numbers(found.size());
  py::array_t<bool> on(static_cast<py::ssize_t>(found.size()));
  for (std::size_t k = 0; k < found.size(); ++k) {
    numbers[k] = found[k].number;
    on.mutable_data()[k] = found[k].on;
  }
  return py::make_tuple(array_of(std::move(numbers)), on);
}

py::array interior_values(const Array& curve, const Array& points, int threads) {
  const std::span<const Point> at = points_of(points);
  const ClosedCurve closed = closed_curve(curve);
  return array_of(long_call(threads, [&] {
    const std::vector<InteriorValue> found = interior_function(indexed(closed, at), at);
    std::vector<double> values(found.size());
    for (std::size_t k = 0; k < found.size(); ++k) values[k] = found[k].j;
    return values;
  }));
}

}  // namespace

void bind_interior(py::module_& module) {
  py::class_<InteriorAreas, std::shared_ptr<InteriorAreas>>(module, "Interior")
      .def_readonly("areas", &InteriorAreas::areas)
      .def_readonly("rounding", &InteriorAreas::rounding)
      .def_readonly("q1", &InteriorAreas::q1)
      .def_readonly("q2", &InteriorAreas::q2)
      .def_readonly("q3", &InteriorAreas::q3)
      .def_readonly("delta", &InteriorAreas::delta)
      .def_property_readonly("orientation1", [](const InteriorAreas& result) { return name(result.orientation1); })
      .def_property_readonly("orientation2", [](const InteriorAreas& result) { return name(result.orientation2); })
      .def("nodes", [](const InteriorAreas& result) { return nodes_array(result.nodes); });
  module.def(
      "interior_of",
      [](const OperationRun& run) {
        return std::const_pointer_cast<InteriorAreas>(
            std::shared_ptr<const InteriorAreas>(run.value<operations::CurveInterior>()));
      },
      py::arg("run"), py::keep_alive<0, 1>());
  module.def("windings", windings_of, py::arg("curve").noconvert(), py::arg("points").noconvert(), py::arg("threads"));
  module.def("interior_values", interior_values, py::arg("curve").noconvert(), py::arg("points").noconvert(),
             py::arg("threads"));
}

}  // namespace lober::python

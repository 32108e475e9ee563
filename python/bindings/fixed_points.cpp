#include "lober/dynamics/fixed_points.hpp"

#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <algorithm>

#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/system.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

// As the class FixedPoint of lober/_dynamics.py takes it.
py::tuple parts_of(const FixedPoint& point, int period) {
  const Matrix2& d = point.derivative;
  return py::make_tuple(pair_of(point.at), point.period, name(point.kind),
                        py::make_tuple(py::make_tuple(d.xx, d.xy), py::make_tuple(d.yx, d.yy)),
                        py::make_tuple(point.multipliers[0], point.multipliers[1]),
                        py::make_tuple(pair_of(point.directions[0]), pair_of(point.directions[1])), residue(point),
                        index_of(point, period), point.residual);
}

py::tuple near(const System& system, const py::object& guess, int period, int turns) {
  const PlanarMap& map = map_of(system);
  FixedPointOptions options;
  options.period = period;
  const double extent = std::max(system.window.width(), system.window.height());
  if (extent > 0) options.extent = extent;
  options.turns = turns;
  options.lattice = system.lattice;
  if (turns != 0 && system.lattice == Point{}) {
    throw UsageError("system " + system.info.name + " does not repeat itself after a shift; turns has to be 0");
  }
  const Point start = point_from(guess);
  return parts_of(long_call(0, [&] { return find_fixed_point(map, start, options); }), period);
}

}  // namespace

void bind_fixed_points(py::module_& module) {
  module.def("fixed_point", near, py::arg("system"), py::arg("guess"), py::arg("period"), py::arg("turns"));
}

}  // namespace lober::python

#include "lober/fixed_points.hpp"

#include <pybind11/complex.h>
#include <pybind11/stl.h>

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
  return py::make_tuple(pair_of(point.at), point.period, name_of(point.kind),
                        py::make_tuple(py::make_tuple(d.xx, d.xy), py::make_tuple(d.yx, d.yy)),
                        py::make_tuple(point.eigenvalues[0], point.eigenvalues[1]),
                        py::make_tuple(pair_of(point.directions[0]), pair_of(point.directions[1])), residue(point),
                        index_of(point, period), point.residual);
}

FixedPointOptions options_of(const System& system, int period, int turns, int grid) {
  FixedPointOptions options;
  options.period = period;
  options.shift = {turns * system.lattice.x, turns * system.lattice.y};
  options.grid = grid;
  if (turns != 0 && system.lattice == Point{}) {
    throw UsageError("system " + system.info.name + " does not repeat itself after a shift; turns has to be 0");
  }
  return options;
}

// Points, settled, grid, sum of the indices, index of the box or None.
py::tuple search(const System& system, const py::object& box, int period, int turns, int grid, int max_grid,
                 int threads, const py::object& progress) {
  const ProgressCallback callback(progress);
  const PlanarMap& map = map_of(system);
  const FixedPointOptions options = options_of(system, period, turns, grid);
  const Rectangle where = box.is_none() ? system.window : rectangle_from(box);
  const auto report = [&](int of) {
    return !callback.given() || callback("grid of " + std::to_string(of) + " points a side");
  };
  const FixedPointSearch found =
      long_call(threads, [&] { return search_fixed_points(map, where, options, max_grid, report); });
  py::list points;
  for (const FixedPoint& point : found.points) points.append(parts_of(point, period));
  return py::make_tuple(points, found.settled, found.grid, found.index_sum, found.index_of_box, corners_of(where));
}

py::tuple near(const System& system, const py::object& guess, int period, int turns) {
  const PlanarMap& map = map_of(system);
  const FixedPointOptions options = options_of(system, period, turns, FixedPointOptions{}.grid);
  const Point start = point_from(guess);
  return parts_of(long_call(0, [&] { return find_fixed_point(map, start, options); }), period);
}

}  // namespace

void bind_fixed_points(py::module_& module) {
  module.def("fixed_points", search, py::arg("system"), py::arg("box"), py::arg("period"), py::arg("turns"),
             py::arg("grid"), py::arg("max_grid"), py::arg("threads"), py::arg("progress"));
  module.def("fixed_point", near, py::arg("system"), py::arg("guess"), py::arg("period"), py::arg("turns"));
}

}  // namespace lober::python

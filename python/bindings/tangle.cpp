// Tangles of two curves, and of manifolds grown from a map.
#include "lober/tangle/tangle.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <limits>

#include "python/bindings/areas.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/nodes.hpp"
#include "python/bindings/outcome.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

using operations::CurveTangle;

struct PipRow {
  double x = 0, y = 0;
  std::int32_t rho = 0;
  std::uint32_t node = 0, u_segment = 0, s_segment = 0;
  double u_t = 0, s_t = 0;
};

struct LobeRow {
  double area = 0, polygon_area = 0, inside = 0, outside = 0, parts_error = 0;
  double rounding = 0, discretisation = 0;
  double perimeter = 0, width = 0, x = 0, y = 0;
  bool simple = true, meets_closure = false;
  std::int32_t label_from = 0, label_to = 0, label_n = 0;
};

struct OverlapRow {
  std::uint32_t i = 0, j = 0;
  double area = 0, error = 0, perimeter = 0;
};

py::array pips_of(const CurveTangle& tangle) {
  std::vector<PipRow> rows;
  rows.reserve(tangle.pips.size());
  for (const Pip& pip : tangle.pips) {
    rows.push_back({pip.at.x, pip.at.y, pip.rho, pip.node, pip.u.segment, pip.s.segment, pip.u.t, pip.s.t});
  }
  return array_of(std::move(rows));
}

py::array lobes_of(const CurveTangle& tangle) {
  return array_of(long_call(0, [&] {
    std::vector<LobeRow> rows;
    rows.reserve(tangle.lobes.size());
    for (std::size_t k = 0; k < tangle.lobes.size(); ++k) {
      const Lobe& lobe = tangle.lobes[k];
      const LobeShape& shape = tangle.shapes[k];
      const LobeLabel& label = tangle.images.labels[k];
      rows.push_back({lobe.area, lobe.polygon_area, lobe.inside, lobe.outside,
                      tangle.smooth ? tangle.parts_error(k) : std::numeric_limits<double>::quiet_NaN(),
                      tangle.rounding(lobe.area), tangle.discretisation(k), shape.perimeter, shape.width,
                      shape.centroid.x, shape.centroid.y, lobe.simple, lobe.meets_closure, label.from, label.to,
                      label.n});
    }
    return rows;
  }));
}

py::list labels_of(const CurveTangle& tangle) {
  py::list labels;
  for (const LobeLabel& label : tangle.images.labels) labels.append(text(label));
  return labels;
}

py::array overlaps_of(const CurveTangle& tangle) {
  return array_of(long_call(0, [&] {
    std::vector<OverlapRow> rows;
    for (const LobeOverlap& both : overlaps(tangle)) {
      rows.push_back({both.i, both.j, both.area, both.error, both.perimeter});
    }
    return rows;
  }));
}

// None without a boundary.
py::object boundary_of(const CurveTangle& tangle) {
  const std::optional<Boundary>& boundary = tangle.boundary;
  if (!boundary) return py::none();
  py::dict result;
  result["bip"] = boundary->bip;
  result["area"] = boundary->area;
  result["rounding"] = tangle.rounding(boundary->area);
  result["discretisation"] = tangle.smooth ? boundary->smooth_error : tangle.boundary_discretisation;
  result["orientation"] = boundary->orientation > 0 ? "counter_clockwise" : "clockwise";
  result["crosses_itself"] = boundary->crosses_itself;
  return result;
}

py::dict images_of_lobes(const CurveTangle& tangle) {
  const Images& images = tangle.images;
  py::dict result;
  result["period"] = images.period == 0 ? py::object(py::none()) : py::int_(images.period);
  result["given"] = images.given;
  result["reason"] = images.reason.empty() ? py::object(py::none()) : py::str(images.reason);
  result["area_change"] = images.area_change;
  result["turnstile_sum"] = images.turnstile_sum;
  result["compared"] = images.compared;
  result["turnstile_begin"] = images.turnstile_begin;
  result["turnstile_end"] = images.turnstile_end;
  result["lobe_area12"] = images.lobe_area12;
  result["lobe_area21"] = images.lobe_area21;
  return result;
}

py::array lobe_outline_of(const CurveTangle& tangle, py::ssize_t lobe) {
  return array_of(lobe_outline(tangle, index_in(lobe, tangle.lobes.size())));
}

py::object boundary_outline_of(const CurveTangle& tangle) {
  if (!tangle.boundary) return py::none();
  return array_of(boundary_outline(tangle));
}

// The numbers that are known of a tangle of a system beside the tangle.
py::dict manifolds_of(const OperationRun& run) {
  const ManifoldTangle& grown = *run.value<operations::SystemTangle>()->manifolds;
  py::dict more;
  more["bip"] = grown.bip;
  more["tolerance"] = grown.tolerance;
  more["areas_by_action"] = array_of(std::vector<double>(grown.areas_by_action));
  more["action_errors"] = array_of(std::vector<double>(grown.action_errors));
  more["saddles"] = py::make_tuple(pair_of(grown.local_u.saddle), pair_of(grown.local_s.saddle));
  more["multipliers"] = py::make_tuple(grown.local_u.multiplier, grown.local_s.multiplier);
  more["point_errors"] = py::make_tuple(grown.point_errors_u[grown.bip], grown.point_errors_s[grown.bip]);
  return more;
}

}  // namespace

void bind_tangle(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(PipRow, x, y, rho, node, u_segment, s_segment, u_t, s_t);
  PYBIND11_NUMPY_DTYPE(LobeRow, area, polygon_area, inside, outside, parts_error, rounding, discretisation, perimeter,
                       width, x, y, simple, meets_closure, label_from, label_to, label_n);
  PYBIND11_NUMPY_DTYPE(OverlapRow, i, j, area, error, perimeter);
  py::class_<CurveTangle, std::shared_ptr<CurveTangle>>(module, "Tangle")
      .def("nodes", [](const CurveTangle& tangle) { return nodes_array(tangle.nodes); })
      .def("pips", pips_of)
      .def("lobes", lobes_of)
      .def("labels", labels_of)
      .def("overlaps", overlaps_of)
      .def("boundary", boundary_of)
      .def("images", images_of_lobes)
      .def("lobe_outline", lobe_outline_of)
      .def("boundary_outline", boundary_outline_of)
      .def("u", [](const py::object& self) { return view_of(self.cast<const CurveTangle&>().u().points, self); })
      .def("s", [](const py::object& self) { return view_of(self.cast<const CurveTangle&>().s().points, self); })
      .def_property_readonly("smooth", [](const CurveTangle& tangle) { return tangle.smooth; })
      .def_property_readonly("remarks", [](const CurveTangle& tangle) { return tangle.remarks; });
  module.def(
      "tangle_of",
      [](const OperationRun& run) { return std::const_pointer_cast<CurveTangle>(run.value<CurveTangle>()); },
      py::arg("run"), py::keep_alive<0, 1>());
  module.def("manifolds_of", manifolds_of, py::arg("run"));
}

}  // namespace lober::python

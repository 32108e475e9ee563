#include "python/bindings/tangle.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "python/bindings/areas.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/nodes.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

struct PipRow {
  double x = 0, y = 0;
  std::int32_t rho = 0;
  std::uint32_t node = 0, u_segment = 0, s_segment = 0;
  double u_t = 0, s_t = 0;
};

struct LobeRow {
  double area = 0, polygon_area = 0, inside = 0, outside = 0;
  double rounding = 0, discretisation = 0;
  double perimeter = 0, width = 0, x = 0, y = 0;
  bool simple = true, meets_closure = false;
  std::int32_t label_from = 0, label_to = 0, label_n = 0;
};

struct OverlapRow {
  std::uint32_t i = 0, j = 0;
  double area = 0, error = 0, perimeter = 0;
};

TangleHandle make_tangle(const Array& u, const Array& s, bool smooth, std::optional<std::size_t> bip,
                         std::optional<std::array<double, 2>> bip_near, const std::optional<Array>& closure,
                         std::uint32_t period, bool check_simple, const std::string& index, int threads,
                         const py::object& progress) {
  const ProgressCallback callback(progress);
  TangleOptions options;
  options.index = index_of(index);
  options.bip = bip;
  if (bip_near) options.bip_near = Point{(*bip_near)[0], (*bip_near)[1]};
  if (closure) {
    const std::span<const Point> corners = points_of(*closure);
    options.closure.assign(corners.begin(), corners.end());
  }
  options.period = period;
  options.check_simple = check_simple;
  options.smooth = smooth;
  options.progress = fraction_progress(callback);
  const OpenCurve first = open_curve(u), second = open_curve(s);
  return long_call(threads, [&] { return TangleHandle{tangle(first, second, options), smooth}; });
}

py::array pips_of(const TangleHandle& handle) {
  std::vector<PipRow> rows;
  rows.reserve(handle.tangle.pips.size());
  for (const Pip& pip : handle.tangle.pips) {
    rows.push_back({pip.at.x, pip.at.y, pip.rho, pip.node, pip.u.segment, pip.s.segment, pip.u.t, pip.s.t});
  }
  return array_of(std::move(rows));
}

py::array lobes_of(const TangleHandle& handle) {
  return array_of(long_call(0, [&] {
    const Tangle& tangle = handle.tangle;
    const std::vector<LobeShape> shapes = lobe_shapes(tangle);
    std::vector<LobeRow> rows;
    rows.reserve(shapes.size());
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      const Lobe& lobe = tangle.lobes[k];
      const LobeShape& shape = shapes[k];
      const LobeLabel& label = tangle.images.labels[k];
      rows.push_back({lobe.area, lobe.polygon_area, lobe.inside, lobe.outside, tangle.rounding(lobe.area),
                      handle.smooth ? lobe.smooth_error : shape.discretisation, shape.perimeter, shape.width,
                      shape.centroid.x, shape.centroid.y, lobe.simple, lobe.meets_closure, label.from, label.to,
                      label.n});
    }
    return rows;
  }));
}

py::list labels_of(const TangleHandle& handle) {
  py::list labels;
  for (const LobeLabel& label : handle.tangle.images.labels) labels.append(text(label));
  return labels;
}

py::array overlaps_of(const TangleHandle& handle) {
  return array_of(long_call(0, [&] {
    std::vector<OverlapRow> rows;
    for (const LobeOverlap& both : overlaps(handle.tangle)) {
      rows.push_back({both.i, both.j, both.area, both.error, both.perimeter});
    }
    return rows;
  }));
}

// None without a boundary.
py::object boundary_of(const TangleHandle& handle) {
  const std::optional<Boundary>& boundary = handle.tangle.boundary;
  if (!boundary) return py::none();
  py::dict result;
  result["bip"] = boundary->bip;
  result["area"] = boundary->area;
  result["rounding"] = handle.tangle.rounding(boundary->area);
  result["discretisation"] = handle.smooth ? boundary->smooth_error : boundary_discretisation(handle.tangle);
  result["orientation"] = boundary->orientation > 0 ? "counter_clockwise" : "clockwise";
  result["crosses_itself"] = boundary->crosses_itself;
  return result;
}

py::dict images_of_lobes(const TangleHandle& handle) {
  const Images& images = handle.tangle.images;
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

py::array lobe_outline_of(const TangleHandle& handle, py::ssize_t lobe) {
  return array_of(lobe_outline(handle.tangle, index_in(lobe, handle.tangle.lobes.size())));
}

py::object boundary_outline_of(const TangleHandle& handle) {
  if (!handle.tangle.boundary) return py::none();
  return array_of(boundary_outline(handle.tangle));
}

}  // namespace

void bind_tangle(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(PipRow, x, y, rho, node, u_segment, s_segment, u_t, s_t);
  PYBIND11_NUMPY_DTYPE(LobeRow, area, polygon_area, inside, outside, rounding, discretisation, perimeter, width, x, y,
                       simple, meets_closure, label_from, label_to, label_n);
  PYBIND11_NUMPY_DTYPE(OverlapRow, i, j, area, error, perimeter);
  py::class_<TangleHandle>(module, "Tangle")
      .def("nodes", [](const TangleHandle& handle) { return nodes_array(handle.tangle.nodes); })
      .def("pips", pips_of)
      .def("lobes", lobes_of)
      .def("labels", labels_of)
      .def("overlaps", overlaps_of)
      .def("boundary", boundary_of)
      .def("images", images_of_lobes)
      .def("lobe_outline", lobe_outline_of)
      .def("boundary_outline", boundary_outline_of)
      .def("u",
           [](const py::object& self) { return view_of(self.cast<const TangleHandle&>().tangle.u().points, self); })
      .def("s",
           [](const py::object& self) { return view_of(self.cast<const TangleHandle&>().tangle.s().points, self); })
      .def_property_readonly("smooth", [](const TangleHandle& handle) { return handle.smooth; })
      .def_property_readonly("remarks", [](const TangleHandle& handle) { return handle.tangle.remarks; });
  module.def("tangle", make_tangle, py::arg("u").noconvert(), py::arg("s").noconvert(), py::arg("smooth"),
             py::arg("bip"), py::arg("bip_near"), py::arg("closure").noconvert().none(true), py::arg("period"),
             py::arg("check_simple"), py::arg("index"), py::arg("threads"), py::arg("progress"));
}

}  // namespace lober::python

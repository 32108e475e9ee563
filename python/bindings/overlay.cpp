#include <pybind11/stl.h>

#include "lober/overlay/overlay.hpp"
#include "lober/overlay/smooth.hpp"
#include "python/bindings/areas.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/nodes.hpp"
#include "python/bindings/outcome.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

py::array areas_of(const py::object& self, const std::string& pairing) {
  return view_of(self.cast<const Overlay&>().pieces(pairing_of(pairing)).areas(), self);
}

// Area, number of holes, numbers of the nodes.
py::tuple piece(const Overlay& result, const std::string& pairing, py::ssize_t number) {
  const Pieces& pieces = result.pieces(pairing_of(pairing));
  const Piece found = pieces[index_in(number, pieces.size())];
  std::vector<std::uint32_t> nodes(found.crossings.begin(), found.crossings.end());
  return py::make_tuple(found.area, found.holes, array_of(std::move(nodes)));
}

py::list outline_of(const Overlay& result, const std::string& pairing, py::ssize_t number) {
  const Pairing which = pairing_of(pairing);
  return arrays_of(outline(result, which, index_in(number, result.pieces(which).size())));
}

py::array centroids_of(const Overlay& result, const std::string& pairing) {
  const Pairing which = pairing_of(pairing);
  return array_of(long_call(0, [&] { return centroids(result, which); }));
}

py::array slivers_of(const Overlay& result, const std::string& pairing) {
  const Pairing which = pairing_of(pairing);
  return array_of(long_call(0, [&] { return find_slivers(result, which); }).pieces);
}

py::array sigma_of(const Overlay& result, const std::string& pairing) {
  const Pairing which = pairing_of(pairing);
  return array_of(long_call(0, [&] { return sigma_steps(result, which); }));
}

py::tuple smooth_of(const Overlay& result) {
  const SmoothAreas smooth = long_call(0, [&] { return smooth_areas(result); });
  return py::make_tuple(smooth.areas, smooth.error, smooth.fallback_segments, smooth.fallback_crossings);
}

py::dict timing_of(const Overlay& result) {
  const OverlayTiming& timing = result.timing;
  py::dict seconds;
  seconds["index"] = timing.index;
  seconds["check"] = timing.check;
  seconds["crossings"] = timing.crossings;
  seconds["order"] = timing.order;
  seconds["areas"] = timing.areas;
  seconds["total"] = timing.total;
  return seconds;
}

}  // namespace

void bind_overlay(py::module_& module) {
  PYBIND11_NUMPY_DTYPE_EX(SigmaStep, crossing, "crossing", rho, "rho", along1, "along1", along2, "along2", sigma,
                          "sigma", class_number, "class", s, "s");
  py::class_<Overlay, std::shared_ptr<Overlay>>(module, "Overlay")
      .def_readonly("areas", &Overlay::areas)
      .def_readonly("rounding", &Overlay::rounding)
      .def_readonly("class_count", &Overlay::class_count)
      .def_property_readonly("crossings", [](const Overlay& result) { return result.nodes.crossings(); })
      .def_property_readonly("touches", [](const Overlay& result) { return result.nodes.touches(); })
      .def_property_readonly("shared_arcs", [](const Overlay& result) { return result.nodes.shared_arcs(); })
      .def_property_readonly("same_curve", [](const Overlay& result) { return result.nodes.same_curve(); })
      .def_property_readonly("orientation1", [](const Overlay& result) { return name(result.orientation1); })
      .def_property_readonly("orientation2", [](const Overlay& result) { return name(result.orientation2); })
      .def_property_readonly("timing", timing_of)
      .def("nodes", [](const Overlay& result) { return nodes_array(result.nodes); })
      .def("classes",
           [](const py::object& self) {
             return view_of(std::span<const std::uint32_t>(self.cast<const Overlay&>().classes), self);
           })
      .def("discretisation",
           [](const Overlay& result) { return long_call(0, [&] { return discretisation_error(result); }); })
      .def("piece_areas", areas_of)
      .def("piece", piece)
      .def("outline", outline_of)
      .def("centroids", centroids_of)
      .def("slivers", slivers_of)
      .def("sigma", sigma_of)
      .def("smooth", smooth_of);
  module.def(
      "overlay_of",
      [](const OperationRun& run) {
        return std::const_pointer_cast<Overlay>(std::shared_ptr<const Overlay>(run.value<operations::CurveOverlay>()));
      },
      py::arg("run"), py::keep_alive<0, 1>());
}

}  // namespace lober::python

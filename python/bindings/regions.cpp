#include "lober/overlay/regions.hpp"

#include <pybind11/stl.h>

#include "python/bindings/areas.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/outcome.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

FillRule rule_of(const std::string& name) {
  std::string known;
  for (const FillRule rule : all_fill_rules) {
    if (name == lober::name(rule)) return rule;
    known += (known.empty() ? "" : ", ") + std::string(lober::name(rule));
  }
  throw UsageError("\"" + name + "\" is not a fill rule; there are " + known);
}

RegionPieces pieces_of(const Regions& result, const std::string& rule, const std::string& pairing) {
  const FillRule with = rule_of(rule);
  const Pairing which = pairing_of(pairing);
  return long_call(0, [&] { return result.pieces(with, which); });
}

}  // namespace

void bind_regions(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(WindingArea, w1, w2, area);
  py::class_<RegionPieces>(module, "RegionPieces")
      .def("__len__", &RegionPieces::size)
      .def("areas", [](const py::object& self) { return view_of(self.cast<const RegionPieces&>().areas(), self); })
      .def("holes", [](const RegionPieces& pieces, py::ssize_t k) { return pieces[index_in(k, pieces.size())].holes; })
      .def("outline", [](const RegionPieces& pieces, py::ssize_t k) {
        return arrays_of(pieces.outline(index_in(k, pieces.size())));
      });
  py::class_<Regions, std::shared_ptr<Regions>>(module, "Regions")
      .def("table", [](const py::object& self) { return view_of(self.cast<const Regions&>().table(), self); })
      .def("signed_areas",
           [](const Regions& result) {
             const auto [first, second] = result.signed_areas();
             return py::make_tuple(first, second);
           })
      .def("areas", [](const Regions& result, const std::string& rule) { return result.areas(rule_of(rule)); })
      .def("rounding", [](const Regions& result, const std::string& rule) { return result.rounding(rule_of(rule)); })
      .def("rounding_of", [](const Regions& result, double area) { return result.rounding(area); })
      .def("pieces", pieces_of);
  module.def(
      "regions_of",
      [](const OperationRun& run) {
        const auto found = run.value<operations::CurveRegions>();
        return std::const_pointer_cast<Regions>(std::shared_ptr<const Regions>(found, &found->regions));
      },
      py::arg("run"), py::keep_alive<0, 1>());
}

}  // namespace lober::python

#include "lober/overlay/regions.hpp"

#include <pybind11/stl.h>

#include "python/bindings/areas.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"

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

Regions make_regions(const Array& c1, const std::optional<Array>& c2, const std::string& index, int threads,
                     const py::object& progress) {
  const ProgressCallback callback(progress);
  RegionOptions options;
  options.index = index_of(index);
  options.progress = fraction_progress(callback);
  const ClosedCurve first = closed_curve(c1);
  if (!c2) return long_call(threads, [&] { return regions(first, options); });
  const ClosedCurve second = closed_curve(*c2);
  return long_call(threads, [&] { return regions(first, second, options); });
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
  py::class_<Regions>(module, "Regions")
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
  module.def("regions", make_regions, py::arg("c1").noconvert(), py::arg("c2").noconvert().none(true), py::arg("index"),
             py::arg("threads"), py::arg("progress"));
}

}  // namespace lober::python

#include "lober/dynamics/manifolds.hpp"

#include <pybind11/stl.h>

#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/outcome.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

template <typename Diagnostics>
py::list list_of(const Diagnostics& diagnostics) {
  py::list list;
  for (const GrowthDiagnostic& one : diagnostics) list.append(py::make_tuple(one.first, one.count, name(one.cause)));
  return list;
}

// As the class Image of lober/_dynamics.py takes it.
py::dict image_dict(const operations::CurveImages::One& one) {
  const CurveImage& image = one.image;
  py::list parts;
  for (const ImagePart& part : one.parts) {
    parts.append(py::make_tuple(array_of(std::vector<Point>(part.points.begin(), part.points.end())), part.closed));
  }
  py::dict result;
  result["iterate"] = image.iterate;
  result["curve"] = one.curve;
  result["closed"] = image.closed;
  result["diagnostics"] = list_of(image.diagnostics);
  result["stop"] = name(image.stop);
  result["images"] = image.images;
  result["parts"] = parts;
  result["parameters"] = array_of(std::vector<double>(image.parameters.begin(), image.parameters.end()));
  result["points"] = array_of(std::vector<Point>(image.points.begin(), image.points.end()));
  return result;
}

py::list images_of_run(const OperationRun& run) {
  py::list list;
  for (const operations::CurveImages::One& one : run.value<operations::CurveImages>()->images) {
    list.append(image_dict(one));
  }
  return list;
}

}  // namespace

void bind_manifolds(py::module_& module) {
  module.def("images_of", images_of_run, py::arg("run"));
}

}  // namespace lober::python

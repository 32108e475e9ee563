#include "lober/dynamics/manifolds.hpp"

#include <pybind11/stl.h>

#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/system.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

template <typename Diagnostics>
py::list list_of(const Diagnostics& diagnostics) {
  py::list list;
  for (const GrowthDiagnostic& one : diagnostics) list.append(py::make_tuple(one.first, one.count, name(one.cause)));
  return list;
}

std::function<bool(const GrowthProgress&)> growth_progress(const ProgressCallback& callback) {
  if (!callback.given()) return {};
  return [&callback](const GrowthProgress& progress) {
    return callback(std::to_string(progress.iterates) + " iterates, " + std::to_string(progress.points) + " points");
  };
}

py::dict image_dict(CurveImage&& image) {
  py::list parts;
  for (ImagePart& part : parts_of(image)) parts.append(py::make_tuple(array_of(std::move(part.points)), part.closed));
  py::dict result;
  result["iterate"] = image.iterate;
  result["closed"] = image.closed;
  result["diagnostics"] = list_of(image.diagnostics);
  result["stop"] = name(image.stop);
  result["images"] = image.images;
  result["parts"] = parts;
  result["parameters"] = array_of(std::move(image.parameters));
  result["points"] = array_of(std::move(image.points));
  return result;
}

py::list images(const System& system, const Array& curve, bool closed, int first, int last, double tolerance,
                double max_length, std::size_t max_points, const py::object& box, int threads,
                const py::object& progress) {
  const ProgressCallback callback(progress);
  const PlanarMap& map = map_of(system);
  const CurveView view{points_of(curve), closed};
  ImageOptions options;
  options.tolerance = tolerance;
  options.max_length = max_length;
  options.max_points = max_points;
  if (!box.is_none()) options.box = rectangle_from(box);
  options.progress = growth_progress(callback);
  std::vector<CurveImage> found = long_call(threads, [&] {
    validate(view, "curve");
    return images_of(map, first, last, view, options);
  });
  py::list list;
  for (CurveImage& image : found) {
    if (image.stop == GrowthStop::cancelled) throw Cancelled();
    list.append(image_dict(std::move(image)));
  }
  return list;
}

}  // namespace

void bind_manifolds(py::module_& module) {
  module.def("curve_images", images, py::arg("system"), py::arg("curve").noconvert(), py::arg("closed"),
             py::arg("first"), py::arg("last"), py::arg("tolerance"), py::arg("max_length"), py::arg("max_points"),
             py::arg("box"), py::arg("threads"), py::arg("progress"));
}

}  // namespace lober::python

#include "lober/manifolds.hpp"

#include <pybind11/stl.h>

#include <cmath>
#include <variant>

#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/system.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

ManifoldSide side_named(const std::string& name) {
  if (name == "unstable") return ManifoldSide::unstable;
  if (name == "stable") return ManifoldSide::stable;
  throw UsageError("\"" + name + "\" is not a side of a saddle; there are unstable, stable");
}

// "+" or "-", or a vector roughly along the branch.
Branch branch_of(const LocalManifold& local, const py::object& branch) {
  if (!py::isinstance<py::str>(branch)) return branch_towards(local, point_from(branch));
  const auto sign = branch.cast<std::string>();
  if (sign == "+") return Branch::plus;
  if (sign == "-") return Branch::minus;
  throw UsageError("a branch is +, - or a vector roughly along it, not \"" + sign + "\"");
}

template <typename Diagnostics>
py::list list_of(const Diagnostics& diagnostics) {
  py::list list;
  for (const GrowthDiagnostic& one : diagnostics) list.append(py::make_tuple(one.first, one.count, name(one.cause)));
  return list;
}

std::function<bool(const GrowthProgress&)> growth_progress(const ProgressCallback& callback, double length) {
  if (!callback.given()) return {};
  return [&callback, length](const GrowthProgress& progress) {
    const std::string text =
        std::to_string(progress.iterates) + " iterates, " + std::to_string(progress.points) + " points";
    return std::isfinite(length) ? callback(std::min(progress.length / length, 1.0), text) : callback(text);
  };
}

py::dict grow_branch(const System& system, const py::object& saddle, const std::string& side, const py::object& branch,
                     double tolerance, int iterates, double length, int period, double max_length,
                     std::size_t max_points, const py::object& box, int threads, const py::object& progress) {
  const ProgressCallback callback(progress);
  const PlanarMap& map = map_of(system);
  const Point guess = point_from(saddle);
  const ManifoldSide which = side_named(side);
  LocalManifoldOptions local_options;
  local_options.period = period;
  const LocalManifold local = long_call(threads, [&] { return local_manifold(map, guess, which, local_options); });
  const Branch towards = branch_of(local, branch);
  GrowthOptions options;
  options.tolerance = tolerance;
  options.iterates = iterates;
  options.length = length;
  options.max_length = max_length;
  options.max_points = max_points;
  if (!box.is_none()) options.box = rectangle_from(box);
  options.progress = growth_progress(callback, length);
  GrownManifold grown = long_call(threads, [&] { return grow(map, local, towards, options); });
  if (grown.stop == GrowthStop::cancelled) throw Cancelled();
  py::dict result;
  result["points"] = array_of(std::move(grown.points));
  result["parameters"] = array_of(std::move(grown.parameters));
  result["generation_begin"] = array_of(std::move(grown.generation_begin));
  result["diagnostics"] = list_of(grown.diagnostics);
  result["stop"] = name(grown.stop);
  result["length"] = grown.length;
  result["images"] = grown.images;
  result["saddle"] = pair_of(local.saddle);
  result["multiplier"] = local.multiplier;
  result["defect"] = local.defect_across;
  return result;
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
  options.progress = growth_progress(callback, std::nan(""));
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
  module.def("grow", grow_branch, py::arg("system"), py::arg("saddle"), py::arg("side"), py::arg("branch"),
             py::arg("tolerance"), py::arg("iterates"), py::arg("length"), py::arg("period"), py::arg("max_length"),
             py::arg("max_points"), py::arg("box"), py::arg("threads"), py::arg("progress"));
  module.def("curve_images", images, py::arg("system"), py::arg("curve").noconvert(), py::arg("closed"),
             py::arg("first"), py::arg("last"), py::arg("tolerance"), py::arg("max_length"), py::arg("max_points"),
             py::arg("box"), py::arg("threads"), py::arg("progress"));
}

}  // namespace lober::python

// Pages of results and of curves, as HTML.
#include <pybind11/stl.h>

#include <vector>

#include "lober/base/error.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/outcome.hpp"
#include "viewer/page.hpp"
#include "viewer/scenes/scenes.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

std::string page_with_title(viewer::Scene scene, const std::string& title) {
  if (!title.empty()) scene.title = title;
  const py::gil_scoped_release unlocked;
  return viewer::page_of(scene);
}

std::string page_of_run(const OperationRun& run, const std::string& title) {
  std::optional<viewer::Scene> scene = viewer::scene_of(*run.operation, run.outcome);
  if (!scene) throw UsageError("there are no pages of " + run.operation->name);
  for (const std::string& remark : run.outcome.remarks) scene->notes.push_back(remark);
  return page_with_title(std::move(*scene), title);
}

std::string page_of_curves(const std::vector<Array>& curves, const std::vector<std::string>& names,
                           const std::vector<bool>& closed, const std::string& title) {
  std::vector<viewer::Line> lines;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    lines.push_back({names.at(k), {points_of(curves[k]), closed.at(k)}});
  }
  return page_with_title(viewer::curves_scene(lines), title);
}

}  // namespace

void bind_pages(py::module_& module) {
  module.def("page_of_run", page_of_run, py::arg("run"), py::arg("title"));
  module.def("page_of_curves", page_of_curves, py::arg("curves"), py::arg("names"), py::arg("closed"),
             py::arg("title"));
}

}  // namespace lober::python

// Batches that other processes compute: lober/_dask.py hands portions to them.
#include "engine/batch/shared_run.hpp"

#include <pybind11/stl.h>

#include "engine/batch/queue/kept_curves.hpp"
#include "python/bindings/batch_options.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/keywords.hpp"
#include "python/bindings/module.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

using lober::detail::KeptCurves;
using lober::detail::SharedRun;
using Jobs = std::vector<std::uint32_t>;

std::unique_ptr<SharedRun> start(const std::string& path, const std::optional<std::string>& text,
                                 const py::kwargs& given) {
  const BatchOptions options = batch_options(given);
  return long_call(0, [&] { return std::make_unique<SharedRun>(manifest_of(path, text), options); });
}

py::dict report(const SharedRun& run) {
  const BatchReport& all = run.report();
  py::dict parts;
  parts["jobs"] = all.jobs;
  parts["finished_before"] = all.finished_before;
  parts["run"] = all.queue.jobs;
  parts["failed"] = all.queue.failed;
  parts["damaged"] = all.damaged;
  parts["hidden"] = all.hidden;
  parts["stored_meanwhile"] = all.stored_meanwhile;
  return parts;
}

// The results, the points of the curves of all jobs, the seconds of the threads in jobs, and the warnings.
py::tuple run_portion(const std::string& portion, const std::string& manifest_path, const py::kwargs& given) {
  lober::detail::PortionOptions options;
  options.manifest_path = manifest_path;
  std::shared_ptr<KeptCurves> kept;  // until the end of the call, whoever lets go of it meanwhile
  Keywords(given)
      .take("files_root", options.files_root)
      .take("output_root", options.output_root)
      .take("store", options.store)
      .take("threads", options.queue.threads)
      .take("memory", options.queue.memory)
      .take("names", options.names)
      .take("kept", kept)
      .end();
  options.kept = kept.get();
  const lober::detail::PortionResults done =
      long_call(options.queue.threads, [&] { return lober::detail::run_portion(portion, options); });
  return py::make_tuple(py::bytes(done.results), done.queue.points, done.queue.operation_seconds, done.queue.warnings);
}

py::dict counts_of(const KeptCurves& kept) {
  const KeptCurves::Counts counts = kept.counts();
  py::dict parts;
  parts["curves"] = counts.curves;
  parts["idle_bytes"] = counts.idle_bytes;
  parts["occupied_bytes"] = counts.occupied_bytes;
  parts["found"] = counts.found;
  parts["kept"] = counts.kept;
  parts["dropped"] = counts.dropped;
  return parts;
}

}  // namespace

void bind_shared_run(py::module_& module) {
  py::class_<SharedRun>(module, "SharedRun")
      .def_property_readonly("pending", &SharedRun::pending)
      .def_property_readonly("has_outputs", &SharedRun::has_outputs)
      .def_property_readonly("report", report)
      .def("next_portion", &SharedRun::next_portion, py::arg("processes"))
      .def(
          "encoded", [](const SharedRun& run, const Jobs& jobs) { return py::bytes(run.encoded(jobs)); },
          py::arg("jobs"))
      .def(
          "files", [](const SharedRun& run, const Jobs& jobs) { return run.files(jobs); }, py::arg("jobs"))
      .def(
          "add",
          [](SharedRun& run, const Jobs& jobs, const std::string& results) {
            const py::gil_scoped_release released;
            run.add(jobs, results);
          },
          py::arg("jobs"), py::arg("results"))
      .def("fail", &SharedRun::fail, py::arg("job"), py::arg("message"))
      .def("finish", &SharedRun::finish, py::arg("how"), py::call_guard<py::gil_scoped_release>());
  py::class_<KeptCurves, std::shared_ptr<KeptCurves>>(module, "KeptCurves")
      .def("set_budget", &KeptCurves::set_budget, py::arg("budget"), py::call_guard<py::gil_scoped_release>())
      .def_property_readonly("counts", counts_of);
  module.def("kept_curves", [] { return std::make_shared<KeptCurves>(); });
  module.def("start_shared_run", start, py::arg("path"), py::arg("text"));
  module.def("run_portion", run_portion, py::arg("portion"), py::arg("manifest_path"));
}

}  // namespace lober::python

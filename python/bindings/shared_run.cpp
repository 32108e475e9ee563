// Batches that other processes compute: lober/batch_dask hands portions to them.
#include "engine/batch/shared_run.hpp"

#include <pybind11/stl.h>

#include "lober/batch.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

using lober::detail::SharedRun;
using Jobs = std::vector<std::uint32_t>;

std::unique_ptr<SharedRun> start(const std::string& path, const std::optional<std::string>& text,
                                 const std::string& store, std::pair<std::size_t, std::size_t> shard,
                                 const std::string& output_root, int threads) {
  BatchOptions options;
  options.store = store;
  options.shard = {shard.first, shard.second};
  options.output_root = output_root;
  options.queue.threads = threads;
  return long_call(0, [&] {
    return std::make_unique<SharedRun>(
        text ? lober::detail::parse_manifest(*text, path) : lober::detail::read_manifest(path), options);
  });
}

py::dict report(const SharedRun& run) {
  const BatchReport& all = run.report();
  py::dict parts;
  parts["jobs"] = all.jobs;
  parts["finished_before"] = all.finished_before;
  parts["run"] = all.queue.jobs;
  parts["failed"] = all.queue.failed;
  parts["damaged"] = all.damaged;
  return parts;
}

// The results, the points of the curves of all jobs, and the seconds of the threads in jobs.
py::tuple run_portion(const std::string& portion, const std::string& manifest_path, const std::string& files_root,
                      const std::string& output_root, const std::string& store, int threads, std::size_t memory,
                      std::vector<std::pair<std::string, std::string>> names) {
  const lober::detail::PortionResults done = long_call(threads, [&] {
    return lober::detail::run_portion(portion, {.manifest_path = manifest_path,
                                                .files_root = files_root,
                                                .output_root = output_root,
                                                .store = store,
                                                .queue = {.threads = threads, .memory = memory},
                                                .names = std::move(names)});
  });
  return py::make_tuple(py::bytes(done.results), done.queue.points, done.queue.operation_seconds);
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
  module.def("start_shared_run", start, py::arg("path"), py::arg("text"), py::arg("store"), py::arg("shard"),
             py::arg("output_root"), py::arg("threads"));
  module.def("run_portion", run_portion, py::arg("portion"), py::arg("manifest_path"), py::arg("files_root"),
             py::arg("output_root"), py::arg("store"), py::arg("threads"), py::arg("memory"), py::arg("names"));
}

}  // namespace lober::python

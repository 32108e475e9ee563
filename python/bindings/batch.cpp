// Batches: a manifest is run into a store, and a store is asked; lober/batch.py has the classes.
#include <pybind11/stl.h>

#include "engine/batch/batch.hpp"
#include "engine/batch/export/export.hpp"
#include "python/bindings/batch_options.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

using lober::detail::Plan;
using lober::detail::Store;

std::string text_of(const QueueProgress& progress) {
  std::string text = std::to_string(progress.done) + " of " + std::to_string(progress.jobs) + " jobs";
  if (progress.failed != 0) text += ", " + std::to_string(progress.failed) + " failed";
  return text;
}

py::dict dict_of_report(const BatchReport& report) {
  py::dict parts;
  parts["jobs"] = report.jobs;
  parts["finished_before"] = report.finished_before;
  parts["run"] = report.queue.jobs;
  parts["failed"] = report.queue.failed;
  parts["stopped"] = report.queue.stopped;
  parts["points"] = report.queue.points;
  parts["threads"] = report.queue.threads;
  parts["seconds"] = report.wall_seconds;
  parts["damaged"] = report.damaged;
  parts["hidden"] = report.hidden;
  parts["stored_meanwhile"] = report.stored_meanwhile;
  parts["warnings"] = report.queue.warnings;
  return parts;
}

py::dict run_manifest(const std::string& path, const std::optional<std::string>& text, const py::object& progress,
                      const py::kwargs& given) {
  const ProgressCallback callback(progress);
  BatchOptions options = batch_options(given);
  return dict_of_report(long_call(options.queue.threads, [&] {
    // The progress is called by a thread of its own, which has no scope.
    const CancellationScope* const scope = CancellationScope::current();
    options.progress = [&](const QueueProgress& now) {
      if (scope->cancelled()) return false;
      return !callback.given() || callback(now.cost > 0 ? now.cost_done / now.cost : 0, text_of(now));
    };
    return lober::detail::run_batch(manifest_of(path, text), options);
  }));
}

py::dict dict_of_counts(const ExportCounts& counts) {
  py::dict parts;
  parts["done"] = counts.done;
  parts["failed"] = counts.failed;
  parts["missing"] = counts.missing;
  parts["damaged"] = counts.damaged;
  return parts;
}

// The counts, and of each message of a failure: itself, its first job and the number of its jobs.
py::tuple survey_store(const std::string& path) {
  const lober::detail::StoreSurvey found = long_call(0, [&] { return lober::detail::survey(Store::open(path)); });
  py::list failures;
  for (const auto& failure : found.failures) {
    failures.append(py::make_tuple(failure.message, failure.first, failure.jobs));
  }
  return py::make_tuple(dict_of_counts(found.counts), failures);
}

py::dict export_table(const std::string& store, const std::string& path, const std::string& format,
                      const std::optional<std::string>& operation) {
  const ExportFormat kind = export_format(format.empty() ? path : "." + format);
  return dict_of_counts(long_call(0, [&] { return export_results(store, path, kind, operation); }));
}

// The operations of the plan, each once, in its order.
std::vector<std::string> operations_of(const std::string& store) {
  const std::optional<Plan> plan = long_call(0, [&] { return Store::open(store).plan(); });
  std::vector<std::string> names;
  for (std::size_t k = 0; plan && k < plan->groups.size(); ++k) {
    const std::string& name = plan->groups[k].operation->name;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

py::list runs_of(const std::string& store) {
  py::list all;
  for (const Store::Run& run : long_call(0, [&] { return Store::open(store).runs(); })) {
    py::dict parts;
    parts["started"] = run.started;
    parts["ended"] = run.ended;
    parts["how"] = run.how;
    parts["version"] = run.version;
    parts["commit"] = run.commit;
    parts["compiler"] = run.compiler;
    parts["flags"] = run.flags;
    parts["host"] = run.host;
    parts["shard"] = run.shard;
    parts["threads"] = run.threads;
    parts["folder"] = run.folder;
    parts["manifest"] = run.manifest;
    all.append(parts);
  }
  return all;
}

// The work of a manifest, before anything is computed.
py::dict check_manifest(const std::string& path, const std::optional<std::string>& text) {
  const lober::detail::Estimate sum = long_call(0, [&] { return estimate(make_plan(manifest_of(path, text)), path); });
  py::dict parts;
  parts["jobs"] = sum.jobs;
  parts["curves"] = sum.curves;
  parts["files"] = sum.files;
  parts["points"] = sum.points;
  parts["points_in_jobs"] = sum.points_in_jobs;
  parts["memory"] = sum.memory;
  parts["core_seconds"] = sum.core_seconds;
  return parts;
}

py::list columns_of(std::span<const lober::detail::Column> columns) {
  py::list list;
  for (const lober::detail::Column& column : columns) {
    list.append(py::make_tuple(column.name, column.unit, column.meaning));
  }
  return list;
}

// All operations of batches: what it does, the names, units and meanings of its columns, its lists, and its view.
py::dict batch_operations() {
  py::dict all;
  for (const lober::detail::Operation& operation : lober::detail::all_operations()) {
    py::dict parts;
    parts["summary"] = operation.summary;
    parts["columns"] = columns_of(operation.columns);
    parts["lists"] = operation.lists;
    parts["view"] = operation.view;
    all[operation.name.c_str()] = parts;
  }
  return all;
}

}  // namespace

void bind_batch(py::module_& module) {
  module.def("batch_run", run_manifest, py::arg("path"), py::arg("text"), py::arg("progress"));
  module.def("batch_check", check_manifest, py::arg("path"), py::arg("text"));
  module.def("batch_survey", survey_store, py::arg("store"));
  module.def("batch_export", export_table, py::arg("store"), py::arg("path"), py::arg("format"), py::arg("operation"));
  module.def(
      "batch_merge",
      [](const std::string& target, const std::vector<std::string>& stores) {
        return long_call(0, [&] { return merge_stores(target, stores); });
      },
      py::arg("target"), py::arg("stores"));
  module.def("batch_operations_of", operations_of, py::arg("store"));
  module.def("batch_runs", runs_of, py::arg("store"));
  module.def("batch_operations", batch_operations);
}

}  // namespace lober::python

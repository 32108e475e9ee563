#include "lober/escape.hpp"

#include <pybind11/stl.h>

#include "python/bindings/agreement.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/system.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

struct EscapeRow {
  std::uint32_t entry = 0, exit = 0;
  std::int32_t crossings = 0, iterates = 0;
  double fraction = 0, error = 0, other = 0, other_error = 0;
};

const char* name_of(EscapeStop stop) {
  switch (stop) {
    case EscapeStop::done:
      return "done";
    case EscapeStop::points:
      return "points";
    case EscapeStop::work:
      return "work";
    case EscapeStop::budget:
      return "budget";
    case EscapeStop::lost:
      return "lost";
    case EscapeStop::cancelled:
      break;
  }
  return "cancelled";
}

py::list curves_of(std::vector<TubeCurve>& curves) {
  py::list list;
  for (TubeCurve& curve : curves) list.append(array_of(std::move(curve.image.points)));
  return list;
}

py::dict dict_of(Bottleneck& bottleneck) {
  py::dict one;
  one["energy"] = bottleneck.orbit.energy;
  one["orbit_period"] = bottleneck.orbit.period;
  one["multiplier"] = bottleneck.multiplier;
  one["action"] = py::make_tuple(bottleneck.orbit.action, bottleneck.orbit.action_error);
  one["area"] = py::make_tuple(bottleneck.area, bottleneck.area_error);
  one["entry"] = curves_of(bottleneck.entry);
  one["exit"] = curves_of(bottleneck.exit);
  return one;
}

py::dict escape_of(const System& system, double energy, int crossings, double tolerance, std::size_t max_points,
                   const std::optional<double>& budget, int threads, const py::object& progress) {
  if (!system.flow) throw UsageError("escape needs a flow, and system " + system.info.name + " is a map");
  if (!system.section) throw UsageError("system " + system.info.name + " has no section of its own");
  if (system.saddles.empty()) throw UsageError("system " + system.info.name + " names no saddles");
  const ProgressCallback callback(progress);
  EscapeOptions options;
  options.crossings = crossings;
  options.tolerance = tolerance;
  options.max_points = max_points;
  if (budget) {
    if (!(*budget > 0)) throw UsageError("escape: the budget has to be a number of seconds above 0");
    options.budget = *budget;
  }
  if (callback.given()) {
    options.progress = [&](const EscapeProgress& now) { return callback(now.fraction, now.what); };
  }
  Escape found =
      long_call(threads, [&] { return escape(*system.flow, *system.section, energy, system.saddles, options); });
  if (found.stop == EscapeStop::cancelled) throw Cancelled();
  std::vector<EscapeRow> rows;
  for (const EscapeFraction& row : found.table) {
    rows.push_back({static_cast<std::uint32_t>(row.entry), static_cast<std::uint32_t>(row.exit), row.crossings,
                    row.iterates, row.fraction, row.error, row.other, row.other_error});
  }
  py::list bottlenecks;
  for (Bottleneck& bottleneck : found.bottlenecks) bottlenecks.append(dict_of(bottleneck));
  py::dict result;
  result["energy"] = found.energy;
  result["table"] = array_of(std::move(rows));
  result["crossings"] = found.crossings;
  result["stop"] = name_of(found.stop);
  result["bottlenecks"] = bottlenecks;
  py::list also_open;
  for (const SaddlePoint& saddle : found.also_open) also_open.append(saddle.at);
  result["also_open"] = also_open;
  result["comparisons"] = comparisons_of(found.agreement);
  return result;
}

}  // namespace

void bind_escape(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(EscapeRow, entry, exit, crossings, iterates, fraction, error, other, other_error);
  module.def("escape", escape_of, py::arg("system"), py::arg("energy"), py::arg("crossings"), py::arg("tolerance"),
             py::arg("max_points"), py::arg("budget"), py::arg("threads"), py::arg("progress"));
}

}  // namespace lober::python

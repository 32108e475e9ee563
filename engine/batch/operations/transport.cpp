// `transport`: flux out of a region of a system, iterate by iterate, from its equations alone. No curves.
#include "lober/transport.hpp"

#include <algorithm>

#include "engine/base/text.hpp"
#include "engine/batch/operations/named_system.hpp"
#include "engine/batch/operations/table.hpp"
#include "lober/error.hpp"

namespace lober::detail {
namespace {

Result run_transport(JobCurves curves, const Options& options) {
  const System system =
      system_of(options.text("system"), options.reals_of("parameters"), options.real("integration_tolerance"));
  TransportOptions how;
  how.iterates = static_cast<int>(options.whole("iterates"));
  how.tolerance = options.real("tolerance");
  constexpr std::size_t bytes_per_point = 240;  // of two manifolds that are grown, and what is made of them
  how.max_points = std::min(how.max_points, std::max<std::size_t>(curves.allowance().most() / bytes_per_point, 1000));
  how.progress = [&](const std::string&) {
    curves.allowance().check();
    return true;
  };
  const Transport found = transport(system, how);
  const ManifoldTangle& manifolds = found.manifolds();
  const TransportBoundary& first = found.boundaries.front();
  if (const auto apart = found.agreement.disagreements(); !apart.empty()) {
    throw DataError("two routes disagree: " + apart.front().what + " by " + apart.front().first_by + " and by " +
                    apart.front().second_by + " differ by " + format_number(apart.front().difference()) +
                    ", more than their error bars " + format_number(apart.front().bar));
  }
  Result record;
  record.values = {found.regions.front().area.value,
                   first.flux12.value,
                   first.flux21.value,
                   first.lobe_area12.value,
                   first.lobe_area21.value,
                   first.lobe_area12_by_action,
                   first.lobe_area21_by_action,
                   static_cast<double>(manifolds.period()),
                   static_cast<double>(manifolds.u.points.size()),
                   static_cast<double>(manifolds.s.points.size())};
  record.lists.resize(4);
  for (const TransportStep& step : found.steps) {
    record.lists[0].push_back(step.flux(1, 0).value);
    record.lists[1].push_back(step.total(1, 0).value);
    record.lists[2].push_back(step.total(1, 0).error);
    record.lists[3].push_back(step.by_boundaries(1, 0).value);
  }
  return record;
}

void check_options(const Options& options) {
  try {
    const System system = system_of(options.text("system"), options.reals_of("parameters"), 1e-12);
    // A member of a grid that has none for its parameters fails alone.
    if (!system.connection && system.no_connection.empty())
      throw UsageError(options.text("system") + " names no manifolds of interest");
  } catch (const UsageError& error) {
    throw UsageError(std::string("system: ") + error.what());
  }
}

}  // namespace

Operation transport_operation() {
  Operation operation;
  operation.name = "transport";
  operation.view = "transports";
  operation.arity = Arity::none;
  operation.summary = "flux and transport of the turnstile of a system, as lober transport";
  operation.options = {
      {"system", "", "name of the system, or its shared library"},
      {"parameters.*", 0.0, "parameters of the system, by name; those left out take their defaults"},
      {"iterates", std::int64_t{7}, "number of iterates n of a(n) and T(n)", {}, 1, 1000},
      {"tolerance", 1e-5, "largest distance between the manifolds and their polygons", {}, 1e-15},
      {"integration_tolerance", 1e-12, "error of a step of the integration of a flow", {}, 1e-16, 1e-2}};
  for (const char* const name :
       {"region", "flux12", "flux21", "lobe_area12", "lobe_area21", "lobe_area12_by_action", "lobe_area21_by_action"}) {
    operation.columns.push_back({name, Column::Kind::real});
  }
  for (const char* const name : {"period", "points_u", "points_s"}) {
    operation.columns.push_back({name, Column::Kind::count});
  }
  // a21(n), T21(n), estimated error of T21(n), and T21(n) by the boundary method, n = 1, 2, ...
  operation.lists = {"a21", "total21", "total21_error", "total21_by_boundaries"};
  operation.check = check_options;
  operation.requirements = [](const Options&) { return Requirements{}; };
  operation.run = run_transport;
  operation.cost = [](std::size_t) { return 2e5; };
  operation.memory = std::size_t{64} << 20;
  return operation;
}

}  // namespace lober::detail

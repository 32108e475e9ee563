// `lober tangle SYSTEM`, or `--system NAME`: grows the manifolds from the equations, and shows them as it shows
// manifolds from files, with the areas of the turnstile by action beside those by geometry.

#include "cli/tangle/system_tangle_command.hpp"

#include <algorithm>

#include "cli/program/command_line.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/system_options.hpp"
#include "cli/program/table_options.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/tangle/tangle_outputs.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/base/threads.hpp"

namespace lober::cli {
namespace {

struct SystemTangleRequest {
  SystemRequest system;
  std::vector<operations::OptionSetting> settings;
  TangleOutputs outputs;
  int threads = 0;
};

TangleReport compute(const SystemTangleRequest& request, Progress& progress) {
  TangleReport report;
  report.origin = system_input_of(request.system);
  operations::Context context;
  context.progress = told_to(progress);
  report.outcome = report.operation().run(std::array<operations::Input, 1>{*report.origin},
                                          checked_options(report.operation(), request.settings), context);
  const ManifoldTangle& manifolds = *report.manifolds();
  report.read_seconds = report.outcome.as<operations::SystemTangle>().growth_seconds - manifolds.tangle.timing.total;
  for (const bool unstable : {true, false}) {
    const GrownManifold& grown = unstable ? manifolds.u : manifolds.s;
    NamedCurve& input = report.inputs[unstable ? 0 : 1];
    input.file = (unstable ? "unstable manifold of " : "stable manifold of ") + report.origin->system->info.name;
    input.curve.closed = false;
    input.curve.points.assign(grown.points.begin(), grown.points.end());
  }
  return report;
}

void run(const SystemTangleRequest& request) {
  const detail::Stopwatch watch;
  check_outputs(request.outputs.files(), files_of_system(request.system.name));
  TangleReport report;
  {
    Progress progress;
    progress.phase("growing", 0, 0.9);
    report = compute(request, progress);
    progress.phase("writing", 0.9, 1);
    write_tangle(request.outputs, report, [&] { return watch.seconds(); });
  }
  print_tangle(request.outputs, report);
  require_agreement(report.outcome.agreement);
}

}  // namespace

bool names_system(const std::vector<std::string>& arguments) {
  return std::any_of(arguments.begin(), arguments.end(), [](const std::string& argument) {
    return argument == "--system" || argument.starts_with("--system=") || argument == "--param" ||
           argument.starts_with("--param=") || is_system(argument);
  });
}

void run_system_tangle(const std::vector<std::string>& arguments) {
  SystemTangleRequest request;
  OptionParser parser(
      "Finds the tangle of a system's manifolds, which are grown from its equations: pips, lobes, boundary and "
      "turnstile, with areas by geometry and by action.",
      "lober tangle");
  add_system_option(parser, request.system.name, true);
  add_parameter_option(parser, request.system.parameters);
  const TableOptions options(parser, operations::named("manifold_tangle"));
  add_integration_option(parser, request.system.integration);
  request.outputs.add_options(parser);
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return;
  request.settings = options.settings();
  run_with_threads(request.threads, [&] { run(request); });
}

}  // namespace lober::cli

// `lober tangle SYSTEM`, or `--system NAME`: grows the manifolds from the equations, and shows them as it shows
// manifolds from files, with the areas of the turnstile by action beside those by geometry.

#include "cli/tangle/system_tangle_command.hpp"

#include <algorithm>

#include "cli/program/command_line.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/system_options.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/tangle/tangle_outputs.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/threads.hpp"

namespace lober::cli {
namespace {

struct SystemTangleRequest {
  SystemRequest system;
  ManifoldTangleOptions options;
  TangleOutputs outputs;
  int threads = 0;
};

TangleReport compute(const SystemTangleRequest& request, Progress& progress) {
  TangleReport report;
  report.origin.emplace();
  TangleOrigin& origin = *report.origin;
  origin.system = system_of(request.system, parameter_values(request.system.parameters));
  origin.integration = request.system.integration;
  origin.tolerance = request.options.tolerance;
  const Connection connection = connection_of(request.system, origin.system);
  ManifoldTangleOptions options = request.options;
  if (!request.system.bip.empty()) options.bip_near = connection.bip;
  options.progress = [&](const std::string& line) { return progress.step(line); };
  const detail::Stopwatch watch;
  origin.manifolds = grow_tangle(*origin.system.map, connection, options);
  report.timing.read = watch.seconds() - origin.manifolds->tangle.timing.total;
  report.result = origin.manifolds->tangle;
  report.agreement = agreement_of(*origin.manifolds);
  report.options.bip = origin.manifolds->bip;
  report.options.period = report.result.images.period;
  report.options.smooth = options.smooth;
  for (const bool unstable : {true, false}) {
    const GrownManifold& grown = unstable ? origin.manifolds->u : origin.manifolds->s;
    NamedCurve& input = report.inputs[unstable ? 0 : 1];
    input.file = (unstable ? "unstable manifold of " : "stable manifold of ") + origin.system.info.name;
    input.curve.closed = false;
    input.curve.points.assign(grown.points.begin(), grown.points.end());
  }
  measure_lobes(request.outputs, report);
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
  require_agreement(report.agreement);
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
  add_system_options(parser, request.system, true);
  add_tolerance_option(parser, request.options.tolerance, manifold_tolerance_help);
  parser
      .add("--before", request.options.before,
           "The number of pre-images of the bip up to which manifolds are grown (default: 1).")
      .range(1, max_iterates)
      .value("N");
  parser
      .add("--after", request.options.after,
           "The number of images of the bip up to which manifolds are grown (default: 0).")
      .range(0, max_iterates)
      .value("N");
  add_max_points_option(parser, request.options.max_points, manifold_points_help);
  parser
      .add("--budget", request.options.budget,
           "The wall-clock time that growing the manifolds may take, in seconds (default: a limit on the work instead, "
           "about 20 s, which gives the same result on every machine).")
      .positive()
      .value("SECONDS");
  request.outputs.add_options(parser);
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return;
  run_with_threads(request.threads, [&] { run(request); });
}

}  // namespace lober::cli

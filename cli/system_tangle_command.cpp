// `lober tangle --system NAME`: grows the manifolds from the equations, and shows them as it shows manifolds from
// files, with the areas of the turnstile by action beside those by geometry.

#include "cli/system_tangle_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/command_line.hpp"
#include "cli/progress.hpp"
#include "cli/tangle_report.hpp"
#include "engine/stopwatch.hpp"

namespace lober::cli {
namespace {

struct Request {
  SystemRequest system;
  ManifoldTangleOptions options;
  std::string lobes, boundary, pips, graph, json, svg;
  bool overlaps = false;
  int threads = 0;
};

std::vector<Output> outputs_of(const Request& request) {
  std::vector<Output> outputs;
  for (const auto& [option, path] : {std::pair{"--json", request.json},
                                     {"--graph", request.graph},
                                     {"--lobes", request.lobes},
                                     {"--boundary", request.boundary},
                                     {"--pips", request.pips},
                                     {"--svg", request.svg}}) {
    if (!path.empty()) outputs.push_back({option, path});
  }
  return outputs;
}

TangleReport compute(const Request& request, Progress& progress) {
  TangleReport report;
  report.origin.emplace();
  TangleOrigin& origin = *report.origin;
  origin.system = system_of(request.system, parameter_values(request.system.parameters));
  origin.integration = request.system.integration;
  origin.tolerance = request.options.tolerance;
  const Connection connection = connection_of(request.system, origin.system);
  ManifoldTangleOptions options = request.options;
  double fraction = 0;  // nobody knows how long the manifolds have to be
  options.progress = [&](const std::string&) { return progress.advance(fraction += 0.25 * (1 - fraction)); };
  const Stopwatch watch;
  origin.manifolds = grow_tangle(*origin.system.map, connection, options);
  report.timing.read = watch.seconds() - origin.manifolds->tangle.timing.total;
  report.result = origin.manifolds->tangle;
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
  const Stopwatch measure_watch;
  report.shapes = lobe_shapes(report.result);
  report.timing.measures = measure_watch.seconds();
  if (request.overlaps) {
    const Stopwatch overlap_watch;
    report.overlaps = overlaps(report.result);
    report.timing.overlaps = overlap_watch.seconds();
  }
  return report;
}

void run(const Request& request) {
  const Stopwatch watch;
  const std::vector<Output> outputs = outputs_of(request);
  check_outputs(outputs, {});
  TangleReport report;
  {
    Progress progress;
    progress.phase("growing", 0, 0.9);
    report = compute(request, progress);
    progress.phase("writing", 0.9, 1);
    const Stopwatch write_watch;
    if (!request.lobes.empty()) write_tangle_lobes(request.lobes, report);
    if (!request.boundary.empty()) write_tangle_boundary(request.boundary, report);
    if (!request.pips.empty()) write_tangle_pips(request.pips, report);
    if (!request.graph.empty()) write_tangle_graph(request.graph, report);
    if (!request.svg.empty()) write_tangle_picture(request.svg, report);
    report.timing.write = write_watch.seconds();
    if (!request.json.empty()) write_tangle_json(request.json, report, [&] { return watch.seconds(); });
  }
  // Standard output holds one thing only.
  if (std::none_of(outputs.begin(), outputs.end(), [](const Output& output) { return output.path == "-"; })) {
    print(tangle_table(report));
  }
}

}  // namespace

bool names_system(const std::vector<std::string>& arguments) {
  return std::any_of(arguments.begin(), arguments.end(), [](const std::string& argument) {
    return argument == "--system" || argument.starts_with("--system=");
  });
}

void run_system_tangle(const std::vector<std::string>& arguments) {
  Request request;
  CLI::App app(
      "Tangle of a system's manifolds, grown from its equations: pips, lobes, boundary, turnstile, with areas by "
      "geometry and by action.",
      "lober tangle");
  add_system_options(app, request.system, false);
  app.add_option("--tolerance", request.options.tolerance,
                 "how far the manifolds may lie from their polygons (default 1e-5); errors of areas are far smaller")
      ->check(CLI::PositiveNumber)
      ->type_name("LENGTH");
  app.add_option("--before", request.options.before, "pre-images of the bip that are wanted (default 1)")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  app.add_option("--after", request.options.after, "images of the bip that are wanted (default 0)")
      ->check(CLI::Range(0, 1000))
      ->type_name("N");
  app.add_option("--max-points", request.options.most_points, "of each manifold")
      ->check(CLI::Range(std::size_t{2}, std::size_t{2'147'483'646}))
      ->type_name("N");
  app.add_option("--lobes", request.lobes, "write the lobes as Tecplot zones, closed")->type_name("FILE");
  app.add_option("--boundary", request.boundary, "write the boundary as an open polyline")->type_name("FILE");
  app.add_option("--pips", request.pips, "write the pips")->type_name("FILE");
  app.add_flag("--overlaps", request.overlaps, "the area that each two lobes have in common too");
  app.add_option("--graph", request.graph, "write every crossing with its place on both manifolds (JSON)")
      ->type_name("FILE");
  app.add_option("--json", request.json, "write everything as one JSON object (- for standard output)")
      ->type_name("FILE");
  app.add_option("--svg", request.svg, "draw manifolds, pips, lobes and boundary")->type_name("FILE");
  app.add_option("--threads", request.threads, "how many (default: all); the results are the same bits")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  if (!parse_arguments(app, arguments)) return;
  with_thread_limit(request.threads, [&] { run(request); });
}

}  // namespace lober::cli

// `lober fixed-points SYSTEM`: makes the system, searches the box, shows the points.

#include "cli/fixed_points/fixed_points_command.hpp"

#include "cli/fixed_points/fixed_points_report.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/system_options.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/threads.hpp"

namespace lober::cli {
namespace {

struct FixedPointsRequest {
  std::string system;
  std::vector<std::string> parameters;
  std::vector<double> box;
  IntegrationOptions integration;
  FixedPointOptions options;
  int turns = 0, max_grid = 384, threads = 0;
  std::string csv, json;
};

void add_options(OptionParser& parser, FixedPointsRequest& request) {
  add_system_option(parser, request.system, true);
  add_parameter_option(parser, request.parameters);
  parser
      .add("--box", request.box,
           "Two corners of the box that is searched, X0 < X1 and Y0 < Y1, in the coordinates of the map (default: the "
           "system's window).")
      .comma_separated()
      .count(4)
      .value("X0,Y0,X1,Y1");
  parser
      .add("--period", request.options.period,
           "The period, in iterates of the map; points whose least period divides it are found too (default: 1).")
      .range(1, 1000)
      .value("P");
  parser
      .add("--turns", request.turns,
           "The shifts of the plane, of those after which the system repeats, by which a point moves in a period: the "
           "turns of a lifted angle (default: 0).")
      .range(-1'000'000, 1'000'000)
      .value("M");
  parser
      .add("--grid", request.options.grid,
           "The points a side of the grid of the first scan; each further one has twice as many (default: 48).")
      .range(2, 4096)
      .value("N");
  parser.add("--max-grid", request.max_grid, "The points a side of the grid of the last scan (default: 384).")
      .range(2, 16384)
      .value("N");
  parser
      .add("--budget", request.options.budget,
           "The wall time that the search may take, in seconds; points found by then are shown (default: by work, not "
           "by "
           "time: some seconds on one core).")
      .range(0.01, 1e9)
      .value("SECONDS");
  add_integration_option(parser, request.integration);
  parser.add("--csv", request.csv, "Write the points to FILE as comma-separated columns (default: no file).")
      .value("FILE");
  add_json_option(parser, request.json);
  add_threads_option(parser, request.threads);
}

Rectangle box_of(const FixedPointsRequest& request, const System& system) {
  if (request.box.empty()) return system.window;
  return Rectangle::of({request.box[0], request.box[1]}, {request.box[2], request.box[3]});
}

void check(const FixedPointsRequest& request) {
  if (!request.box.empty() && !(request.box[0] < request.box[2] && request.box[1] < request.box[3])) {
    throw UsageError("--box: the corners have to have X0 < X1 and Y0 < Y1");
  }
  if (request.max_grid < request.options.grid) {
    throw UsageError("--max-grid has to be at least --grid, which is " + std::to_string(request.options.grid));
  }
}

void run(const FixedPointsRequest& request) {
  const detail::Stopwatch watch;
  std::vector<Output> outputs;
  if (!request.csv.empty()) outputs.push_back({"--csv", request.csv});
  if (!request.json.empty()) outputs.push_back({"--json", request.json});
  check_outputs(outputs, files_of_system(request.system));
  FixedPointsReport report;
  report.system = system_of({request.system, request.parameters, request.integration, {}, {}, {}, {}, {}},
                            parameter_values(request.parameters));
  if (request.turns != 0 && report.system.lattice == Point{}) {
    throw UsageError("system " + report.system.info.name + " does not repeat after a shift; leave --turns out");
  }
  report.integration = request.integration;
  report.box = box_of(request, report.system);
  report.options = request.options;
  report.turns = request.turns;
  report.options.shift = {request.turns * report.system.lattice.x, request.turns * report.system.lattice.y};
  report.max_grid = request.max_grid;
  {
    Progress progress;
    progress.phase("searching", 0, 1);
    const detail::Stopwatch search_watch;
    report.search = search_fixed_points(*report.system.map, report.box, report.options, report.max_grid, [&](int grid) {
      return progress.step("grid of " + std::to_string(grid) + " x " + std::to_string(grid));
    });
    report.search_seconds = search_watch.seconds();
    if (!request.csv.empty()) write_fixed_points_csv(request.csv, report);
    if (!request.json.empty()) write_fixed_points_json(request.json, report, [&] { return watch.seconds(); });
  }
  if (!takes_standard_output(outputs)) print(fixed_points_table(report));
}

}  // namespace

void run_fixed_points(const std::vector<std::string>& arguments) {
  FixedPointsRequest request;
  OptionParser parser(
      "Finds the fixed and periodic points of a map, or of a flow's Poincare map, in a box, with their multipliers, "
      "residues and types.",
      "lober fixed-points");
  add_options(parser, request);
  if (!parser.parse(arguments)) return;
  check(request);
  run_with_threads(request.threads, [&] { run(request); });
}

}  // namespace lober::cli

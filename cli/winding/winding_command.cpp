// `lober winding CURVE`: reads the curve and the points, asks the engine, and hands its findings to the reports.

#include "cli/winding/winding_command.hpp"

#include <array>

#include "cli/picture/picture_options.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/output_names.hpp"
#include "cli/program/point_arguments.hpp"
#include "cli/program/progress.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/report.hpp"
#include "cli/report/table.hpp"
#include "cli/winding/winding_report.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/base/threads.hpp"
#include "lober/curve/drawing.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_cells = 100'000'000;

struct WindingRequest {
  std::string curve;
  Periods periods;
  std::vector<std::string> at;
  std::vector<int> grid;
  std::vector<double> box;
  std::string output, json;
  PictureRequest picture;
  int threads = 0;
};

void add_options(OptionParser& parser, WindingRequest& request) {
  parser.add_example("lober winding examples/resonance.dat --at 0,0", "about the origin");
  parser.add_example("lober winding examples/loops.csv --grid 20,20", "on a grid, of a curve that crosses itself");
  parser
      .add("CURVE", request.curve,
           "The closed curve, which may cross itself: FILE, or FILE#ZONE for one zone of it (by number from 0, or by "
           "title).")
      .required();
  add_periodic_option(parser, request.periods);
  const Option at = parser
                        .add("--at", request.at,
                             "A point X,Y, in the coordinates of the curve, or a FILE of points, all zones of it, "
                             "FILE#ZONE or FILE:COLUMNS; several may follow. One of --at and --grid has to be given.")
                        .value("X,Y|FILE");
  const Option grid = parser
                          .add("--grid", request.grid,
                               "The numbers of columns and rows of a grid; the points are the centres of its cells.")
                          .comma_separated()
                          .count(2)
                          .range(1, 1'000'000)
                          .value("NX,NY")
                          .excludes(at);
  parser
      .add("--box", request.box,
           "Two corners of the grid, X0 < X1 and Y0 < Y1 (default: the curve's box, widened by a twentieth on each "
           "side).")
      .comma_separated()
      .count(4)
      .value("X0,Y0,X1,Y1")
      .needs(grid);
  parser
      .add("-o,--output", request.output,
           "Write x, y, winding, on and j of each point to FILE, whose ending .npy, .csv, .txt, .dat (Tecplot) or .raw "
           "is its format; with --grid the array in an NPY file is rows x columns x 5; - is text on standard output "
           "(default: no file).")
      .value("FILE");
  add_picture_options(parser, request.picture, "the winding numbers of the cells and the curve").needs(grid);
  add_json_option(parser, request.json);
  add_table_option(parser);
  add_threads_option(parser, request.threads);
}

// Checks that the parser cannot make.
void check(const WindingRequest& request) {
  if (request.at.empty() && request.grid.empty()) {
    throw UsageError("the points are missing; give --at or --grid (see lober winding --help)");
  }
  if (!request.grid.empty() &&
      static_cast<std::size_t>(request.grid[0]) * static_cast<std::size_t>(request.grid[1]) > max_cells) {
    throw UsageError("--grid: there can be at most 100000000 cells; give fewer columns or rows");
  }
  if (!request.box.empty() && !(request.box[0] < request.box[2] && request.box[1] < request.box[3])) {
    throw UsageError("--box: the corners have to have X0 < X1 and Y0 < Y1");
  }
  if (!request.picture.data.empty() && request.grid.empty()) throw UsageError("--data needs --grid");
  if (!request.output.empty()) (void)table_format(request.output);
}

std::vector<std::string> inputs_of(const WindingRequest& request) {
  std::vector<std::string> inputs = point_files("--at", request.at);
  inputs.insert(inputs.begin(), request.curve);
  return inputs;
}

WindingGrid grid_of(const WindingRequest& request, CurveView curve) {
  WindingGrid grid{{}, static_cast<std::size_t>(request.grid[0]), static_cast<std::size_t>(request.grid[1])};
  if (!request.box.empty()) {
    grid.window = Rectangle::of({request.box[0], request.box[1]}, {request.box[2], request.box[3]});
  } else {
    grid.window = widened(include({}, curve.points), 0.05);
  }
  return grid;
}

WindingReport compute(const WindingRequest& request, Progress& progress) {
  WindingReport report;
  progress.phase("reading", 0, 0.2);
  const detail::Stopwatch read_watch;
  progress.file(0, 1);
  report.input = read_curve(request.curve, true, {.periods = request.periods});
  report.points = points_of("--at", request.at, &report.input.curve);
  if (request.periods.any()) {  // each to the sheet on which the curve is
    const Rectangle box = include({}, report.input.curve.points);
    const std::array<Point, 2> corners{Point{box.min_x, box.min_y}, Point{box.max_x, box.max_y}};
    for (Point& point : report.points) move_near({&point, 1}, corners, request.periods);
  }
  report.read_seconds = read_watch.seconds();
  const detail::Stopwatch index_watch;
  const IndexedCurve curve(report.input.curve);
  report.signed_area = signed_area(report.input.curve);
  report.index_seconds = index_watch.seconds();
  if (!request.grid.empty()) {
    report.grid = grid_of(request, report.input.curve);
    report.points = cell_centres(report.grid->window, report.grid->columns, report.grid->rows);
  }
  progress.of(static_cast<double>(report.points.size()), "points");
  progress.phase("winding numbers", 0.2, 0.8);
  const detail::Stopwatch winding_watch;
  const operations::Operation& operation = operations::named("winding");
  const std::array<operations::Input, 2> inputs{operations::CurveInput{report.input.curve, request.curve, &curve},
                                                std::span<const Point>(report.points)};
  operations::Context context;
  context.progress = [&](double fraction, const std::string&) { return progress.advance(fraction); };
  report.outcome = operation.run(inputs, {operation.options, {}}, context);
  report.winding_seconds = winding_watch.seconds();
  return report;
}

void run(const WindingRequest& request) {
  const detail::Stopwatch watch;
  std::vector<Output> outputs = request.picture.outputs();
  for (const auto& [option, path] : {std::pair{"-o", request.output}, {"--json", request.json}}) {
    if (!path.empty()) outputs.push_back({option, path});
  }
  check_outputs(outputs, inputs_of(request));
  WindingReport report;
  {
    Progress progress;
    report = compute(request, progress);
    progress.phase("writing", 0.8, 1);
    const detail::Stopwatch write_watch;
    if (!request.output.empty()) write_winding_columns(request.output, report);
    if (request.picture.asked()) write_figure(request.picture, winding_figure(report));
    report.write_seconds = write_watch.seconds();
    if (!request.json.empty()) write_winding_json(request.json, report, [&] { return watch.seconds(); });
  }
  if (!takes_standard_output(outputs)) print_report(winding_table(report));
  require_agreement(report.outcome.agreement);
}

}  // namespace

void run_winding(const std::vector<std::string>& arguments) {
  WindingRequest request;
  OptionParser parser(
      "Computes how often a closed curve, which may cross itself, winds round points, and the interior function J.",
      "lober winding");
  add_options(parser, request);
  if (!parser.parse(arguments)) return;
  check(request);
  run_with_threads(request.threads, [&] { run(request); });
}

}  // namespace lober::cli

// `lober levels SYSTEM`: samples the energy on a grid, follows its levels, and hands them to those who show them.

#include "cli/levels/levels_command.hpp"

#include <algorithm>
#include <cmath>

#include "cli/levels/levels_report.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/output_names.hpp"
#include "cli/program/progress.hpp"
#include "cli/report/svg.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/error.hpp"
#include "lober/threads.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_shaded = 8;  // levels

struct LevelsRequest {
  SystemRequest system;
  double time = 0;
  std::vector<double> at, box, grid;
  std::vector<double> energy;  // none or one
  std::size_t number = 24;
  std::string output, svg, json;
  int threads = 0;
};

void add_options(OptionParser& parser, LevelsRequest& request) {
  add_system_option(parser, request.system.name, true);
  add_parameter_option(parser, request.system.parameters);
  const Option at =
      parser.add("--at", request.at, "The values of the levels, separated by commas (default: --number values).")
          .comma_separated()
          .count(1, 1000)
          .value("E1,E2,...");
  const Option number =
      parser
          .add("--number", request.number,
               "The number of levels, at values that divide the cells of the grid evenly (default: 24); those through "
               "saddles come on top.")
          .range(std::size_t{1}, std::size_t{1000})
          .value("N")
          .excludes(at);
  parser
      .add("--energy", request.energy,
           "Show Hill's region of this energy: where the potential exceeds it no motion is possible (flows of two "
           "degrees of freedom).")
      .count(1)
      .value("E")
      .excludes(at)
      .excludes(number);
  parser.add("--time", request.time, "The time at which a forced flow is looked at (default: 0).").value("T");
  parser
      .add("--box", request.box,
           "Two corners of the box that is looked at, X0 < X1 and Y0 < Y1 (default: the system's window and saddles "
           "for a planar flow, a square about the origin with the saddles else).")
      .comma_separated()
      .count(4)
      .value("X0,Y0,X1,Y1");
  parser
      .add("--grid", request.grid,
           "The number of cells across and up; details smaller than a cell are missed (default: 480, and as many up as "
           "make them square).")
      .comma_separated()
      .count(2)
      .value("NX,NY");
  parser
      .add("-o,--output", request.output,
           "Write the curves to FILE as Tecplot zones (.dat); their vertices lie on the level to rounding (default: "
           "no file).")
      .value("FILE");
  parser.add("--svg", request.svg, "Draw the level curves as an SVG picture in FILE (default: no file).").value("FILE");
  add_json_option(parser, request.json);
  add_threads_option(parser, request.threads);
}

void check(const LevelsRequest& request) {
  if (!request.box.empty() && !(request.box[0] < request.box[2] && request.box[1] < request.box[3])) {
    throw UsageError("--box: the corners have to have X0 < X1 and Y0 < Y1");
  }
  for (const double cells : request.grid) {
    if (!(cells >= 1 && cells <= 30'000 && cells == std::floor(cells))) {
      throw UsageError("--grid NX,NY: both have to be whole numbers from 1 to 30000");
    }
  }
  for (const auto& [option, values] :
       {std::pair{"--at", &request.at}, {"--energy", &request.energy}, {"--box", &request.box}}) {
    for (const double value : *values) {
      if (!std::isfinite(value)) throw UsageError(std::string(option) + ": the numbers have to be finite");
    }
  }
  if (!std::isfinite(request.time)) throw UsageError("--time: the number has to be finite");
  if (!request.output.empty() && (request.output == "-" || format_of(request.output) != PointFormat::tecplot)) {
    throw UsageError("-o " + request.output + ": several curves need a Tecplot file (.dat)");
  }
}

// Saddles near the ends of the system's connections, or near those that bound its well.
std::vector<Equilibrium> saddles_of(const System& system, double time) {
  std::vector<FlowState> guesses;
  if (system.flow->dimension() == 4) {
    guesses = system.saddles;
  } else {
    std::vector<Connection> connections = system.further;
    if (system.connection) connections.insert(connections.begin(), *system.connection);
    for (const Connection& connection : connections) {
      guesses.push_back({connection.from.x, connection.from.y});
      guesses.push_back({connection.to.x, connection.to.y});
    }
  }
  std::vector<Equilibrium> saddles;
  for (const FlowState& guess : guesses) {
    try {
      const Equilibrium found = equilibrium_near(*system.flow, guess, time);
      const auto same = [&](const Equilibrium& other) {
        return std::hypot(found.at.x - other.at.x, found.at.y - other.at.y) < 1e-6;
      };
      if (found.saddle && std::none_of(saddles.begin(), saddles.end(), same)) saddles.push_back(found);
    } catch (const DataError&) {
      continue;  // none there at this moment
    }
  }
  return saddles;
}

Rectangle box_of(const LevelsRequest& request, const LevelsReport& report) {
  if (!request.box.empty()) {
    return Rectangle::of({request.box[0], request.box[1]}, {request.box[2], request.box[3]});
  }
  if (report.system.flow->dimension() == 2) {
    // With all saddles, which the window may leave out, and some room about them.
    Rectangle box = report.system.picture;
    const double room_x = 0.1 * box.width(), room_y = 0.1 * box.height();
    for (const Equilibrium& saddle : report.saddles) {
      Rectangle with_it = box;
      with_it.add(saddle.at);
      if (with_it == box) continue;
      box.add({saddle.at.x - room_x, saddle.at.y - room_y});
      box.add({saddle.at.x + room_x, saddle.at.y + room_y});
    }
    return box;
  }
  // The well about the origin that the saddles bound.
  double reach = 0.5;
  for (const Equilibrium& saddle : report.saddles) {
    reach = std::max({reach, std::fabs(saddle.at.x), std::fabs(saddle.at.y)});
  }
  return Rectangle::of({-1.5 * reach, -1.5 * reach}, {1.5 * reach, 1.5 * reach});
}

// Values that divide the nodes of the grid evenly.
std::vector<double> spread_levels(const LevelGrid& grid, std::size_t number) {
  std::vector<double> values;
  for (std::size_t row = 0; row <= grid.rows(); ++row) {
    for (std::size_t column = 0; column <= grid.columns(); ++column) {
      if (std::isfinite(grid.value(column, row))) values.push_back(grid.value(column, row));
    }
  }
  if (values.empty()) throw DataError("the energy has no value anywhere in the box");
  std::sort(values.begin(), values.end());
  std::vector<double> levels;
  for (std::size_t k = 0; k < number; ++k) levels.push_back(values[(2 * k + 1) * (values.size() - 1) / (2 * number)]);
  return levels;
}

// Also through the saddles, unless the levels are given or Hill's region is asked for.
void choose_levels(const LevelsRequest& request, const LevelGrid& grid, LevelsReport& report) {
  std::vector<double> values = request.at;
  if (report.energy) values = {*report.energy};
  if (values.empty()) {
    values = spread_levels(grid, request.number);
    for (const Equilibrium& saddle : report.saddles) values.push_back(saddle.energy);
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  for (const double value : values) {
    const auto near = [&](double other) { return std::fabs(value - other) <= 1e-12 * (1 + std::fabs(value)); };
    // Saddles of one symmetry differ by rounding.
    if (!report.levels.empty() && near(report.levels.back().value)) continue;
    Level level{value, {}, {}};
    for (const Equilibrium& saddle : report.saddles) {
      if (near(saddle.energy)) level.saddle = saddle.at;
    }
    report.levels.push_back(std::move(level));
  }
  report.shaded = !request.at.empty() && report.levels.size() <= max_shaded;
}

void run(const LevelsRequest& request) {
  const detail::Stopwatch watch;
  std::vector<Output> outputs;
  for (const auto& [option, path] :
       {std::pair{"-o", request.output}, {"--svg", request.svg}, {"--json", request.json}}) {
    if (!path.empty()) outputs.push_back({option, path});
  }
  check_outputs(outputs, files_of_system(request.system.name));
  LevelsReport report;
  report.system = system_of(request.system, parameter_values(request.system.parameters));
  report.time = request.time;
  if (!report.system.flow) {
    throw UsageError(report.system.info.name + " is a map; level curves of energy are those of a flow");
  }
  const PlaneFunction energy = energy_of(*report.system.flow, request.time);
  if (!request.energy.empty()) {
    if (report.system.flow->dimension() == 2) {
      throw UsageError("--energy: Hill's region belongs to flows of two degrees of freedom; use --at");
    }
    report.energy = request.energy[0];
  }
  report.saddles = saddles_of(report.system, request.time);
  const Rectangle box = box_of(request, report);
  const View view(box);
  const auto columns = static_cast<std::size_t>(request.grid.empty() ? 480 : request.grid[0]);
  const auto rows = static_cast<std::size_t>(
      request.grid.empty() ? std::max(1.0, std::round(480 * view.height() / view.width())) : request.grid[1]);
  const LevelGrid grid(energy, box, columns, rows);
  choose_levels(request, grid, report);
  {
    Progress progress;
    progress.phase("levels", 0, 1);
    for (std::size_t k = 0; k < report.levels.size(); ++k) {
      report.levels[k].curves = grid.curves(report.levels[k].value);
      if (!progress.advance(static_cast<double>(k + 1) / static_cast<double>(report.levels.size()))) {
        throw Cancelled();
      }
    }
    report.seconds = watch.seconds();
    if (!request.output.empty()) write_levels(request.output, report);
    if (!request.svg.empty()) write_levels_picture(request.svg, report, grid);
    if (!request.json.empty()) write_levels_json(request.json, report, grid, [&] { return watch.seconds(); });
  }
  if (!takes_standard_output(outputs)) print(levels_table(report, grid));
}

}  // namespace

void run_levels(const std::vector<std::string>& arguments) {
  LevelsRequest request;
  OptionParser parser(
      "Computes level curves of the energy of a flow: streamlines of a planar flow with those through its saddles, "
      "curves of equal potential and Hill's region of a flow of two degrees of freedom.",
      "lober levels");
  add_options(parser, request);
  if (!parser.parse(arguments)) return;
  check(request);
  run_with_threads(request.threads, [&] { run(request); });
}

}  // namespace lober::cli

// `lober levels SYSTEM`: runs the operation, and hands the levels to those who show them.

#include "cli/levels/levels_command.hpp"

#include <array>

#include "cli/levels/levels_report.hpp"
#include "cli/picture/picture_options.hpp"
#include "cli/picture/system_figure.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/log.hpp"
#include "cli/program/output_names.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/table_options.hpp"
#include "cli/report/outcome_json.hpp"
#include "cli/report/table.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/base/error.hpp"
#include "lober/base/threads.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_shaded = 8;  // levels

struct LevelsRequest {
  SystemRequest system;
  std::vector<operations::OptionSetting> settings;
  std::string output, json, format;
  PictureRequest picture;
  bool periodic_orbits = false;
  int threads = 0;
};

// The orbits in the bottlenecks that the energy opens.
std::vector<std::vector<Point>> periodic_orbits_of(const System& system, double energy) {
  std::vector<std::vector<Point>> orbits;
  for (const FlowState& guess : system.saddles) {
    const SaddlePoint saddle = saddle_point(*system.flow, guess);
    if (!(energy > saddle.energy)) continue;
    orbits.push_back(orbit_positions(*system.flow, periodic_orbit(*system.flow, saddle, energy, {.tolerance = 1e-13})));
  }
  if (orbits.empty()) {
    log_warning("--periodic-orbits: there are none, as the energy is not above that of a saddle of " +
                system.info.name);
  }
  return orbits;
}

void run(const LevelsRequest& request) {
  const detail::Stopwatch watch;
  std::vector<Output> outputs = request.picture.outputs();
  for (const auto& [option, path] : {std::pair{"-o", request.output}, {"--json", request.json}}) {
    if (!path.empty()) outputs.push_back({option, path});
  }
  check_outputs(outputs, files_of_system(request.system.name));
  const operations::Operation& operation = operations::named("levels");
  const operations::Options options = checked_options(operation, request.settings);
  const operations::SystemInput input = system_input_of(request.system);
  LevelsReport report{*input.system, options.real("time")};
  if (options.find("energy") != nullptr) report.energy = options.real("energy");
  {
    Progress progress;
    progress.phase("levels", 0, 1);
    operations::Context context;
    context.progress = told_to(progress);
    report.outcome = operation.run(std::array<operations::Input, 1>{input}, options, context);
    const double seconds = watch.seconds();
    report.shaded = options.find("at") != nullptr && report.result().levels.size() <= max_shaded;
    if (!request.output.empty()) write_levels(request.output, request.format, report);
    if (request.periodic_orbits) report.orbits = periodic_orbits_of(report.system, *report.energy);
    if (request.picture.asked()) write_figure(request.picture, levels_figure(report));
    if (!request.json.empty()) {
      write_outcome_json(request.json, "levels", {{"system", system_json(report.system, input.integration)}}, operation,
                         report.outcome, [&] {
                           return Json{{"levels", seconds}, {"total", watch.seconds()}};
                         });
    }
  }
  if (!takes_standard_output(outputs)) print_report(levels_table(report));
}

}  // namespace

void run_levels(const std::vector<std::string>& arguments) {
  LevelsRequest request;
  const operations::Operation& operation = operations::named("levels");
  OptionParser parser(operation.summary.c_str(), "lober levels");
  add_system_option(parser, request.system.name, true);
  add_parameter_option(parser, request.system.parameters);
  const TableOptions options(parser, operation);
  options["number"].excludes(options["at"]).excludes(options["energy"]);
  options["energy"].excludes(options["at"]);
  const Option output = parser
                            .add("-o,--output", request.output,
                                 ("Write the curves to FILE, whose ending is its format: " + written_endings() +
                                  "; their vertices lie on the level to rounding (default: no file).")
                                     .c_str())
                            .value("FILE");
  add_format_option(parser, request.format).needs(output);
  const Option picture = add_picture_options(parser, request.picture, "the level curves");
  parser
      .add_flag("--periodic-orbits", request.periodic_orbits,
                "Draw the periodic orbits in the bottlenecks of Hill's region too.")
      .needs(picture)
      .needs(options["energy"]);
  add_json_option(parser, request.json);
  add_table_option(parser);
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return;
  if (!request.output.empty() && !takes_several(request.output, request.format)) {
    throw UsageError("-o " + request.output +
                     ": several curves need a format that holds several, as .dat (Tecplot), .npz or .geojson");
  }
  request.settings = options.settings();
  run_with_threads(request.threads, [&] { run(request); });
}

}  // namespace lober::cli

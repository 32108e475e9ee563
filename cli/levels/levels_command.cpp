// `lober levels SYSTEM`: runs the operation, and hands the levels to those who show them.

#include "cli/levels/levels_command.hpp"

#include <array>

#include "cli/levels/levels_report.hpp"
#include "cli/picture/picture_options.hpp"
#include "cli/program/command_line.hpp"
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
  int threads = 0;
};

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
  LevelsReport report{*input.system, options.real("time"), {}, false, {}};
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
  parser
      .add("-o,--output", request.output,
           ("Write the curves to FILE, whose ending is its format: " + written_endings() +
            "; their vertices lie on the level to rounding (default: no file).")
               .c_str())
      .value("FILE");
  add_format_option(parser, request.format);
  add_picture_options(parser, request.picture, "the level curves");
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

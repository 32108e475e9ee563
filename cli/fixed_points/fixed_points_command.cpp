// `lober fixed-points SYSTEM`: runs the operation, and hands the points to those who show them.

#include "cli/fixed_points/fixed_points_command.hpp"

#include <array>

#include "cli/fixed_points/fixed_points_report.hpp"
#include "cli/picture/picture_options.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/system_options.hpp"
#include "cli/program/table_options.hpp"
#include "cli/report/outcome_json.hpp"
#include "cli/report/table.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/base/threads.hpp"

namespace lober::cli {
namespace {

struct FixedPointsRequest {
  SystemRequest system;
  std::vector<operations::OptionSetting> settings;
  std::string csv, json;
  PictureRequest picture;
  int threads = 0;
};

void run(const FixedPointsRequest& request) {
  const detail::Stopwatch watch;
  const std::vector<Output> outputs = checked_outputs({{"--csv", request.csv}, {"--json", request.json}},
                                                      files_of_system(request.system.name), request.picture.outputs());
  const operations::Operation& operation = operations::named("fixed_points");
  const operations::Options options = checked_options(operation, request.settings);
  const operations::SystemInput input = system_input_of(request.system);
  FixedPointsReport report{*input.system, options.find("budget") != nullptr, {}};
  {
    Progress progress;
    progress.phase("searching", 0, 1);
    operations::Context context;
    context.progress = told_to(progress);
    const detail::Stopwatch search_watch;
    report.outcome = operation.run(std::array<operations::Input, 1>{input}, options, context);
    const double search_seconds = search_watch.seconds();
    if (!request.csv.empty()) write_fixed_points_csv(request.csv, report);
    if (request.picture.asked()) write_figure(request.picture, fixed_points_figure(report, request.picture));
    if (!request.json.empty()) {
      write_outcome_json(request.json, "fixed-points", {{"system", system_json(report.system, input.integration)}},
                         operation, report.outcome, [&] {
                           return Json{{"search", search_seconds}, {"total", watch.seconds()}};
                         });
    }
  }
  if (!takes_standard_output(outputs)) print_report(fixed_points_table(report));
}

}  // namespace

void run_fixed_points(const std::vector<std::string>& arguments) {
  FixedPointsRequest request;
  const operations::Operation& operation = operations::named("fixed_points");
  OptionParser parser(operation.summary.c_str(), "lober fixed-points");
  add_system_option(parser, request.system.name, true);
  add_parameter_option(parser, request.system.parameters);
  const TableOptions options(parser, operation);
  add_integration_option(parser, request.system.integration);
  parser.add("--csv", request.csv, "Write the points to FILE as comma-separated columns (default: no file).")
      .value("FILE");
  add_picture_options(parser, request.picture, "the points, with the directions of the manifolds of saddles,",
                      "the residues");
  add_json_option(parser, request.json);
  add_table_option(parser);
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return;
  request.settings = options.settings();
  run_with_threads(request.threads, [&] { run(request); });
}

}  // namespace lober::cli

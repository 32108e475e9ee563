// `lober densify CURVE [AGAINST]`: reads the curves, runs the operation, writes the points.

#include "cli/densify/densify_command.hpp"

#include <optional>

#include "cli/densify/densify_report.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/curves_run.hpp"
#include "cli/program/log.hpp"
#include "cli/program/option_names.hpp"
#include "cli/program/output_names.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/table_options.hpp"
#include "cli/report/curve_file.hpp"
#include "cli/report/outcome_json.hpp"
#include "cli/report/table.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/base/threads.hpp"

namespace lober::cli {
namespace {

using operations::RefinedCurve;

struct DensifyRequest {
  std::vector<std::string> curves;
  Periods periods;
  std::string output, against_output, json, format;
  PictureRequest picture;
  bool open = false, open_against = false;
  std::vector<operations::OptionSetting> settings;
  int threads = 0;
};

// Nothing when the arguments asked for help, which is printed.
std::optional<DensifyRequest> parse_densify(const std::vector<std::string>& arguments) {
  DensifyRequest request;
  OptionParser parser(
      "Inserts points into a curve, or removes them. The steps are taken in the order --simplify, criteria "
      "(--max-length, --hobson, --angle, --distance-angle), --passes, --crossings.",
      "lober densify");
  parser
      .add("CURVES", request.curves,
           "The curve, and the one AGAINST which it is refined by --passes and --crossings: FILE, or FILE#ZONE for one "
           "zone of it (by number from 0, or by title).")
      .value("CURVE [AGAINST]")
      .required()
      .count(1, 2);
  add_periodic_option(parser, request.periods);
  add_points_option(parser, request.output, request.format, true);
  parser.add_flag("--open", request.open, "Read CURVE as an open curve: its last vertex is not joined to the first.");
  parser.add_flag("--open-against", request.open_against, "Read AGAINST as an open curve.");
  const TableOptions options(parser, operations::named("densify"), {"closed", "closed_against"},
                             {.at_end = " -o fine.npy"});
  options["points"].needs(options["passes"]);
  parser
      .add("--against-output", request.against_output,
           "Write AGAINST with the same vertices inserted to FILE, in a format of -o (default: no file).")
      .needs(options["crossings"])
      .value("FILE");
  add_picture_options(parser, request.picture, "the curve with the points that were inserted or removed");
  add_json_option(parser, request.json, "a report of the steps");
  add_table_option(parser);
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return std::nullopt;
  request.settings = options.settings();
  const auto given = [&](const char* key) { return options[key].given(); };
  const bool criteria = given("max_length") || given("hobson") || given("angle") || given("distance_angle");
  const bool near = given("passes") || given("crossings");
  if (near && request.curves.size() < 2) {
    throw UsageError("--passes and --crossings need AGAINST (see lober densify --help)");
  }
  if (!near && request.curves.size() == 2) {
    throw UsageError("AGAINST is given without --passes or --crossings; give one of them (see lober densify --help)");
  }
  if (!near && request.open_against) throw UsageError("--open-against needs AGAINST (see lober densify --help)");
  if (!near && !criteria && !given("simplify") && !given("min_length")) {
    throw UsageError(
        "no step is given; give --simplify, --max-length, --hobson, --angle, --distance-angle, --passes or "
        "--crossings");
  }
  request.settings.push_back({"closed", !request.open});
  request.settings.push_back({"closed_against", !request.open_against});
  (void)curve_format(request.output, request.format, false);
  if (!request.against_output.empty()) (void)curve_format(request.against_output, request.format, false);
  return request;
}

void run(const DensifyRequest& request) {
  const detail::Stopwatch watch;
  const std::vector<Output> outputs =
      checked_outputs({{"-o", request.output}, {"--against-output", request.against_output}, {"--json", request.json}},
                      request.curves, request.picture.outputs());
  const operations::Operation& operation = operations::named("densify");
  const operations::Options options = checked_options(operation, request.settings);
  std::vector<NamedCurve> curves;
  operations::Outcome outcome;
  {
    Progress progress;
    progress.phase("reading", 0, 0.3);
    const detail::Stopwatch read_watch;
    std::vector<operations::Input> inputs;
    curves.reserve(request.curves.size());
    for (const std::string& file : request.curves) {
      progress.file(curves.size(), request.curves.size());
      curves.push_back(
          read_curve(file, curves.empty() ? !request.open : !request.open_against, {.periods = request.periods}));
      if (curves.size() == 2) warn_of_longitudes(curves[0], curves[1], request.periods);
      if (curves.size() == 2) move_near(curves[1].curve.points, curves[0].curve.points, request.periods);
      inputs.emplace_back(operations::CurveInput{curves.back().curve, file});
    }
    if (curves.size() == 2) require_same_columns(curves[0].curve, curves[1].curve);
    const double read_seconds = read_watch.seconds();
    progress.of(static_cast<double>(curves[0].curve.points.size()), "points");
    progress.phase("densifying", 0.3, 0.8);
    const detail::Stopwatch densify_watch;
    operations::Context context;
    context.progress = told_to(progress);
    outcome = operation.run(inputs, options, context);
    if (curves.size() == 2) {
      const std::string warning = period_warning(curves[0].curve, curves[1].curve, request.periods);
      if (!warning.empty()) outcome.remarks.push_back(warning);
    }
    const double densify_seconds = densify_watch.seconds();
    progress.phase("writing", 0.8, 1);
    const detail::Stopwatch write_watch;
    const auto& found = outcome.as<RefinedCurve>();
    CurveFileOptions file{
        .format = request.format, .closed = !request.open, .notes = notes_of("densify", outcome, notes_on(curves))};
    write_curve_file(request.output, found.points, file);
    file.closed = !request.open_against;
    if (!request.against_output.empty()) write_curve_file(request.against_output, found.against->points, file);
    if (request.picture.asked()) write_figure(request.picture, densify_figure(curves, found));
    const double write_seconds = write_watch.seconds();
    if (!request.json.empty()) {
      write_outcome_json(request.json, "densify", {{"inputs", files_json(curves)}}, operation, outcome, [&] {
        return Json{
            {"read", read_seconds}, {"densify", densify_seconds}, {"write", write_seconds}, {"total", watch.seconds()}};
      });
    }
  }
  if (!takes_standard_output(outputs)) print_report(densify_summary(curves, outcome.as<RefinedCurve>()));
  log_remarks(outcome.remarks);
  if (!outcome.incomplete.empty()) log_warning(with_option_names(outcome.incomplete));
}

}  // namespace

void run_densify(const std::vector<std::string>& arguments) {
  const std::optional<DensifyRequest> request = parse_densify(arguments);
  if (request) run_with_threads(request->threads, [&] { run(*request); });
}

}  // namespace lober::cli

// `lober escape SYSTEM`: finds orbits, tubes and the table of escape, and hands them to those who show them.

#include "cli/escape/escape_command.hpp"

#include <algorithm>
#include <array>

#include "cli/escape/escape_report.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/log.hpp"
#include "cli/program/point_arguments.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/system_options.hpp"
#include "cli/program/table_options.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/outcome_json.hpp"
#include "cli/report/table.hpp"
#include "cli/view/page_output.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/base/cancellation.hpp"
#include "lober/base/error.hpp"
#include "lober/base/threads.hpp"
#include "lober/curve/files.hpp"

namespace lober::cli {
namespace {

struct EscapeRequest {
  std::string system;
  std::vector<std::string> parameters, saddles;
  std::vector<operations::OptionSetting> settings;
  bool lists_counts = false;  ///< whether counts of trajectories were asked for
  std::string json, html, curves, tubes, tubes_of, format;
  std::vector<std::string> trajectories;
  PictureRequest picture;
  int threads = 0;
};

std::optional<EscapeRequest> parse_escape(const std::vector<std::string>& arguments) {
  EscapeRequest request;
  const operations::Operation& operation = operations::named("escape");
  OptionParser parser(operation.summary.c_str(), "lober escape");
  parser
      .add("SYSTEM", request.system,
           "The name of a built-in system (capsize or pcr3bp), or the path of a shared library (lober_system.h).")
      .required();
  add_parameter_option(parser, request.parameters);
  parser
      .add("--saddle", request.saddles,
           "A saddle of the potential: its number among those of the system, from 1, or a position near it, or four "
           "coordinates; the option may be repeated (default: all saddles of the system).")
      .value("K|X,Y[,PX,PY]");
  const TableOptions options(parser, operation, {"saddle"});
  const Option count = options["monte_carlo"];
  options["seed"].needs(count);
  add_json_option(parser, request.json);
  add_picture_options(parser, request.picture, "the curves on the section");
  add_html_option(parser, request.html);
  const Option curves = parser
                            .add("--curves", request.curves,
                                 "Write the periodic orbits, as points of position, and the curves of all tubes on the "
                                 "section, their images and pre-images to FILE, in the format of its ending (default: "
                                 "no file).")
                            .value("FILE");
  add_format_option(parser, request.format).needs(curves);
  const Option tubes =
      parser
          .add("--tubes", request.tubes,
               "Write the surfaces of the tubes between their orbits and the section to FILE, in the coordinates x, y "
               "and "
               "the velocity on the section: as legacy VTK (.vtk), or drawn as .svg, .pdf or .png (default: no file).")
          .value("FILE");
  parser
      .add("--tubes-of", request.tubes_of,
           "The manifold whose tubes --tubes shows: unstable, of what enters, or stable, of what leaves (default: "
           "both).")
      .one_of({"unstable", "stable"})
      .value("MANIFOLD")
      .needs(tubes);
  parser
      .add("--trajectory", request.trajectories,
           "The point of the section, in its coordinates, from which the picture of --tubes shows a trajectory: until "
           "it "
           "has left, or comes back to the section; the option may be repeated (default: none).")
      .value("Y,VY")
      .needs(tubes);
  add_table_option(parser);
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return std::nullopt;
  if (!request.tubes.empty() && is_vtk(request.tubes) && !request.trajectories.empty()) {
    throw UsageError("--trajectory belongs to the picture of tubes; give --tubes FILE the ending .svg, .pdf or .png");
  }
  request.settings = options.settings();
  if (!request.saddles.empty()) {
    std::string all;
    for (const std::string& saddle : request.saddles) all += (all.empty() ? "" : ";") + saddle;
    request.settings.push_back({"saddle", all});
  }
  const operations::Options checked = checked_options(operation, request.settings);
  request.lists_counts = count.given() && checked.whole("monte_carlo") > 0;
  if (checked.whole("crossings") == 0 && request.lists_counts) {
    throw UsageError("--monte-carlo checks the table, which --crossings 0 leaves out; give --crossings of at least 1");
  }
  return request;
}

// Rows are printed as they are known; the last ones with the check by trajectories behind them.
void compute(const EscapeRequest& request, bool print_at_once, EscapeReport& report, Progress& progress) {
  const operations::Operation& operation = operations::named("escape");
  const ParameterValues values = parameter_values(request.parameters);
  report.options = checked_options(operation, request.settings);
  report.tubes.unstable = request.tubes_of != "stable";
  report.tubes.stable = request.tubes_of != "unstable";
  for (const Point& start : points_of("--trajectory", request.trajectories)) report.tubes.trajectories.push_back(start);
  const bool by_parameter =
      std::any_of(values.begin(), values.end(), [](const auto& value) { return value.first == "energy"; });
  if (by_parameter && report.options.find("energy") != nullptr) {
    throw UsageError("the energy is given twice, by --energy and by --param energy; give it once");
  }
  const operations::SystemInput input = operations::system_input(request.system, values);
  report.system = input.system->info;
  report.flow = input.system->flow;
  progress.phase("tubes", 0, 0.95);
  operations::Context context;
  context.keeps_what_is_known = true;
  context.progress = [&](double fraction, const std::string&) { return progress.advance(fraction); };
  bool agreed = true;
  if (print_at_once) {
    context.on_part = [&](const void* known) {
      const auto& so_far = *static_cast<const Escape*>(known);
      if (agreed) print_report(agreement_text(so_far.agreement));
      agreed = so_far.agreement.agrees();
      if (so_far.crossings == 1) print_report(escape_heading(report.system.name, so_far));
      print_report(escape_rows(so_far, so_far.crossings));
    };
  }
  const detail::Stopwatch watch;
  report.outcome = operation.run(std::array<operations::Input, 1>{input}, report.options, context);
  report.escape_seconds = watch.seconds();
  report.lists_counts = request.lists_counts && report.result().counted;
  for (Parameter& parameter : report.system.parameters) {
    if (parameter.name == "energy") parameter.value = report.result().energy;
  }
  if (print_at_once && report.result().crossings > 0 && agreed) print_report(agreement_text(report.outcome.agreement));
}

// After all numbers are out: a picture that cannot be drawn costs none of them.
void draw(const PictureRequest& request, const EscapeReport& report) {
  Figure figure;
  try {
    figure = escape_figure(report);
  } catch (const DataError& error) {
    log_warning("--picture: no picture is drawn: " + std::string(error.what()));
    return;
  }
  write_figure(request, figure);
}

void run(const EscapeRequest& request) {
  const detail::Stopwatch watch;
  std::vector<Output> outputs = request.picture.outputs();
  for (const auto& [option, path] : {std::pair{"--json", request.json},
                                     {"--html", request.html},
                                     {"--curves", request.curves},
                                     {"--tubes", request.tubes}}) {
    if (!path.empty()) outputs.push_back({option, path, option == std::string_view("--curves") ? request.format : ""});
  }
  std::vector<std::string> files = files_of_system(request.system);
  for (std::string& file : point_files("--trajectory", request.trajectories)) files.push_back(std::move(file));
  check_outputs(outputs, files);
  const bool printing = !takes_standard_output(outputs);
  // Rows are printed as soon as they are known; where trajectories are asked for they may take long, and if they
  // contradict a row the first line says so.
  const bool print_at_once = printing && !request.lists_counts;
  EscapeReport report;
  std::optional<CancellationScope> shield;  // what is known is written, even after an interrupt
  {
    Progress progress;
    compute(request, print_at_once, report, progress);
    if (report.result().stop == EscapeStop::cancelled) {
      shield.emplace(CancellationScope::Shield{});
    } else {
      progress.phase("writing", 0.95, 1);
    }
    if (!request.curves.empty()) write_escape_curves(request.curves, request.format, report);
    if (!request.tubes.empty()) write_escape_tubes(request.tubes, *report.flow, report, request.picture.style());
    if (!request.json.empty()) {
      System chosen;
      chosen.info = report.system;
      write_outcome_json(request.json, "escape", {{"system", system_json(chosen, {})}}, operations::named("escape"),
                         report.outcome, [&] {
                           return Json{{"escape", report.escape_seconds}, {"total", watch.seconds()}};
                         });
    }
  }
  const operations::SystemEscape& result = report.result();
  if (printing && (!print_at_once || result.crossings == 0)) {
    print_report(agreement_text(result.agreement));
    print_report(escape_heading(report.system.name, result));
    for (int n = 1; n <= result.crossings; ++n) print_report(escape_rows(result, n));
  }
  if (printing) print_report(escape_summary(report));
  if (request.picture.asked()) draw(request.picture, report);
  if (!request.html.empty()) write_page(request.html, report);
  if (result.stop == EscapeStop::cancelled) throw Cancelled();
  require_agreement(result.agreement);
}

}  // namespace

void run_escape(const std::vector<std::string>& arguments) {
  const std::optional<EscapeRequest> request = parse_escape(arguments);
  if (request) run_with_threads(request->threads, [&] { run(*request); });
}

}  // namespace lober::cli

// `lober overlay C1 C2`: reads the curves, runs the operation, and hands its findings to the reports.

#include "cli/overlay/overlay_command.hpp"

#include <optional>

#include "cli/overlay/overlay_report.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/running.hpp"
#include "cli/program/table_options.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/regions_report.hpp"
#include "cli/report/table.hpp"
#include "cli/view/page_output.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/base/threads.hpp"

namespace lober::cli {
namespace {

struct OverlayRequest {
  std::array<std::string, 2> curves;
  Periods periods;
  std::string lobes, crossings, json, html, rule, format;
  PictureRequest picture;
  std::vector<operations::OptionSetting> settings;
  int threads = 0;
  bool rings = false;
};

// Nothing when the arguments asked for help, which is printed.
std::optional<OverlayRequest> parse_overlay(const std::vector<std::string>& arguments) {
  OverlayRequest request;
  OptionParser parser(
      "Computes the crossings, lobes and areas of two closed curves, which have to be simple unless --rule is given.",
      "lober overlay");
  add_curve_arguments(parser, request.curves, request.periods);
  add_json_option(parser, request.json);
  const Option rings =
      parser.add_flag("--rings", request.rings,
                      "Put the outlines of all pieces into the JSON, as lists of points: for each piece its "
                      "outer ring, then its holes.");
  const Option lobes =
      parser
          .add("--lobes", request.lobes,
               "Write the pieces of C1 \\ C2 and C2 \\ C1 to FILE, in the format of its ending (default: no file).")
          .value("FILE");
  const Option crossings = parser
                               .add("--crossings", request.crossings,
                                    "Write the crossings to FILE as comma-separated columns, or, if it ends in .npy, "
                                    "as a NumPy array with the same columns (default: no file).")
                               .value("FILE");
  const Option picture = add_picture_options(parser, request.picture, "the curves and the lobes", "the lobes");
  add_html_option(parser, request.html);
  add_format_option(parser, request.format).needs(lobes);
  TableOptions options(parser, operations::named("overlay"));
  options["areas_only"].excludes(lobes).excludes(picture).excludes(rings);
  Option rule = add_rule_option(parser, request.rule);
  rule.excludes(crossings).excludes(rings);
  for (const char* const key : {"check_simple", "verify", "smooth", "classes", "discretisation"}) {
    rule.excludes(options[key]);
  }
  add_table_option(parser);
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return std::nullopt;
  if (request.rings && request.json.empty()) throw UsageError("--rings needs --json (see lober overlay --help)");
  request.settings = options.settings();
  if (!request.rule.empty()) request.settings.push_back({"rule", request.rule});
  return request;
}

std::vector<Output> outputs_of(const OverlayRequest& request) {
  std::vector<Output> outputs = request.picture.outputs();
  for (const auto& [option, path] : {std::pair{"--json", request.json},
                                     {"--lobes", request.lobes},
                                     {"--crossings", request.crossings},
                                     {"--html", request.html}}) {
    if (!path.empty()) outputs.push_back({option, path, request.format});
  }
  return outputs;
}

void write_json(const std::string& path, bool rings, CurvesReport& report,
                const std::function<double()>& seconds_so_far) {
  const auto& found = report.outcome.as<CurveOverlay>();
  const OverlayTiming& timing = found.timing;
  Json seconds{
      {"check", timing.check}, {"crossings", timing.crossings}, {"order", timing.order}, {"areas", timing.areas}};
  if (found.consistency) seconds["verify"] = found.verify_seconds;
  if (found.smooth) seconds["smooth"] = found.smooth_seconds;
  write_curves_json(path, "overlay", "overlay", report, {found.areas.c1, found.areas.c2},
                    {found.orientation1, found.orientation2}, seconds, seconds_so_far, [&](detail::OutputFile& file) {
                      if (rings) write_rings(file, found);
                    });
}

void report_timing(const CurvesReport& report) {
  const auto& found = report.outcome.as<CurveOverlay>();
  const OverlayTiming& timing = found.timing;
  report_seconds({{"read", report.read_seconds},
                  {"index", report.index_seconds},
                  {"check", timing.check},
                  {"crossings", timing.crossings},
                  {"order", timing.order},
                  {"areas", timing.areas},
                  {"verify", found.verify_seconds},
                  {"smooth", found.smooth_seconds},
                  {"write", report.write_seconds}});
}

void run(const OverlayRequest& request) {
  const detail::Stopwatch watch;
  const std::vector<Output> outputs = outputs_of(request);
  check_outputs(outputs, request.curves);
  const bool by_rule = !request.rule.empty();
  CurvesReport report;
  {
    Progress progress;
    report =
        run_on_curves(by_rule ? "regions" : "overlay", request.curves, request.settings, request.periods, progress);
    progress.phase("writing", 0.9, 1);
    const detail::Stopwatch write_watch;
    const auto total = [&] { return watch.seconds(); };
    const CurveFileOptions lobes{.format = request.format,
                                 .closed = true,
                                 .notes = notes_of("overlay", report.outcome, notes_on(report.inputs))};
    if (by_rule) {
      if (!request.lobes.empty()) write_lobes(request.lobes, report.outcome.as<CurveRegions>(), lobes);
      if (request.picture.asked()) {
        write_figure(request.picture, regions_figure(report.outcome.as<CurveRegions>(), report.inputs));
      }
      if (!request.html.empty()) write_page(request.html, report);
      report.write_seconds = write_watch.seconds();
      if (!request.json.empty()) write_regions_json(request.json, "overlay", report, total);
    } else {
      const auto& found = report.outcome.as<CurveOverlay>();
      if (!request.lobes.empty()) write_lobes(request.lobes, found, lobes);
      if (!request.crossings.empty()) write_crossings(request.crossings, found);
      if (request.picture.asked()) write_figure(request.picture, overlay_figure(found, report.inputs, request.picture));
      if (!request.html.empty()) write_page(request.html, report);
      report.write_seconds = write_watch.seconds();
      if (!request.json.empty()) write_json(request.json, request.rings, report, total);
    }
  }
  if (!takes_standard_output(outputs)) print_report(by_rule ? regions_table(report) : overlay_table(report));
  by_rule ? report_regions_timing(report) : report_timing(report);
  require_agreement(report.outcome.agreement);
}

}  // namespace

void run_overlay(const std::vector<std::string>& arguments) {
  const std::optional<OverlayRequest> request = parse_overlay(arguments);
  if (!request) return;
  run_with_threads(request->threads, [&] { run(*request); });
}

}  // namespace lober::cli

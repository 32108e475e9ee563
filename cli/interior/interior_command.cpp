// `lober interior C1 C2`: reads the curves, runs the operation, and hands its findings to the reports.

#include "cli/interior/interior_command.hpp"

#include <spdlog/fmt/fmt.h>

#include <optional>

#include "cli/interior/interior_report.hpp"
#include "cli/picture/picture_options.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/running.hpp"
#include "cli/program/table_options.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/regions_report.hpp"
#include "cli/report/table.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/base/threads.hpp"

namespace lober::cli {
namespace {

struct InteriorRequest {
  std::array<std::string, 2> curves;
  Periods periods;
  std::string json, rule;
  PictureRequest picture;
  std::vector<operations::OptionSetting> settings;
  int threads = 0;
};

// Nothing when the arguments asked for help, which is printed.
std::optional<InteriorRequest> parse_interior(const std::vector<std::string>& arguments) {
  InteriorRequest request;
  OptionParser parser(
      "Computes the areas of two closed curves, which have to be simple unless --rule is given, by the interior "
      "function: Q1, Q2, Q3.",
      "lober interior");
  add_curve_arguments(parser, request.curves, request.periods);
  TableOptions options(parser, operations::named("interior"));
  const Option picture =
      add_picture_options(parser, request.picture,
                          "the parts of both curves outside and inside of each other, the paths of Q1, Q2 and Q3,");
  add_json_option(parser, request.json);
  add_table_option(parser);
  add_threads_option(parser, request.threads);
  Option rule = add_rule_option(parser, request.rule).excludes(picture);
  for (const char* const key : {"method", "passes", "points", "check_simple", "verify"}) rule.excludes(options[key]);
  if (!parser.parse(arguments)) return std::nullopt;
  request.settings = options.settings();
  if (!request.rule.empty()) {
    request.settings.push_back({"rule", request.rule});
    request.settings.push_back({"areas_only", true});
  }
  return request;
}

void write_json(const std::string& path, CurvesReport& report, const std::function<double()>& seconds_so_far) {
  const auto& found = report.outcome.as<operations::CurveInterior>();
  const InteriorTiming& timing = found.timing;
  write_curves_json(path, "interior", "interior", report, {found.areas.c1, found.areas.c2},
                    {found.orientation1, found.orientation2},
                    {{"check", timing.check},
                     {"crossings", timing.crossings},
                     {"order", timing.order},
                     {"labels", timing.labels},
                     {"sums", timing.sums},
                     {"verify", found.verify_seconds}},
                    seconds_so_far);
}

void report_timing(const CurvesReport& report) {
  const InteriorTiming& timing = report.outcome.as<operations::CurveInterior>().timing;
  report_seconds({{"read", report.read_seconds},
                  {"index", report.index_seconds},
                  {"check", timing.check},
                  {"crossings", timing.crossings},
                  {"order", timing.order},
                  {"labels", timing.labels},
                  {"sums", timing.sums}});
}

std::string areas_by_rule(const CurvesReport& report) {
  const Areas& areas = report.outcome.as<operations::CurveRegions>().areas;
  return fmt::format("\nQ1 {:.16g}, Q2 {:.16g}, Q3 {:.16g}\n", areas.symmetric_difference, areas.union_,
                     areas.intersection);
}

void run(const InteriorRequest& request) {
  const detail::Stopwatch watch;
  std::vector<Output> outputs = request.picture.outputs();
  if (!request.json.empty()) outputs.push_back({"--json", request.json});
  check_outputs(outputs, request.curves);
  const bool by_rule = !request.rule.empty();
  CurvesReport report;
  {
    Progress progress;
    report =
        run_on_curves(by_rule ? "regions" : "interior", request.curves, request.settings, request.periods, progress);
    progress.phase("writing", 0.9, 1);
    const auto total = [&] { return watch.seconds(); };
    if (request.picture.asked() && !by_rule) {
      write_figure(request.picture, interior_figure(report.outcome.as<operations::CurveInterior>(), report.inputs));
    }
    if (!request.json.empty())
      by_rule ? write_regions_json(request.json, "interior", report, total) : write_json(request.json, report, total);
  }
  if (!takes_standard_output(outputs))
    print_report(by_rule ? regions_table(report) + areas_by_rule(report) : interior_table(report));
  by_rule ? report_regions_timing(report) : report_timing(report);
  require_agreement(report.outcome.agreement);
}

}  // namespace

void run_interior(const std::vector<std::string>& arguments) {
  const std::optional<InteriorRequest> request = parse_interior(arguments);
  if (!request) return;
  run_with_threads(request->threads, [&] { run(*request); });
}

}  // namespace lober::cli

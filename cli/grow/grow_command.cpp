// `lober grow SYSTEM`: grows a branch of a manifold and writes its points.

#include "cli/grow/grow_command.hpp"

#include <optional>

#include "cli/grow/grow_report.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/log.hpp"
#include "cli/program/output_names.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/system_options.hpp"
#include "cli/program/table_options.hpp"
#include "cli/report/curve_file.hpp"
#include "cli/report/outcome_json.hpp"
#include "cli/report/table.hpp"
#include "cli/view/page_output.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/base/cancellation.hpp"
#include "lober/base/threads.hpp"

namespace lober::cli {
namespace {

using operations::SystemManifold;

struct GrowRequest {
  SystemRequest system;
  std::vector<operations::OptionSetting> settings;
  std::string output, json, html, format;
  PictureRequest picture;
  int threads = 0;
};

// Nothing when the arguments asked for help, which is printed.
std::optional<GrowRequest> parse_grow(const std::vector<std::string>& arguments) {
  GrowRequest request;
  bool unstable = false, stable = false;
  std::uint64_t memory = 0;
  OptionParser parser(
      "Grows a branch of the stable or unstable manifold of a saddle of a map, or of a flow's Poincare map.",
      "lober grow");
  add_system_option(parser, request.system.name, true);
  add_parameter_option(parser, request.system.parameters);
  const Option u = parser.add_flag("--unstable", unstable, "Grow the unstable manifold.");
  parser.add_flag("--stable", stable, "Grow the stable manifold.").excludes(u);
  const TableOptions options(parser, operations::named("grow"), {"side", "max_memory"});
  const Option limit = add_memory_option(
      parser, memory, "The memory, in bytes or with a unit, as 4G or 500M, at which growing ends (default: no limit).");
  add_integration_option(parser, request.system.integration);
  add_points_option(parser, request.output, request.format, false);
  add_picture_options(parser, request.picture, "the manifold", "the saddle and the ends of the images");
  add_json_option(parser, request.json, "a report of the growth");
  add_table_option(parser);
  add_html_option(parser, request.html);
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return std::nullopt;
  if (unstable == stable) {
    throw UsageError("the side of the manifold is missing; give --unstable or --stable (see lober grow --help)");
  }
  if (!options["iterates"].given() && !options["length"].given()) {
    throw UsageError("the end of the manifold is missing; give --iterates or --length (see lober grow --help)");
  }
  request.settings = options.settings();
  request.settings.push_back({"side", unstable ? "unstable" : "stable"});
  if (limit.given()) request.settings.push_back({"max_memory", static_cast<std::int64_t>(memory)});
  if (!request.output.empty()) (void)curve_format(request.output, request.format, false);
  return request;
}

void run(const GrowRequest& request) {
  const detail::Stopwatch watch;
  const std::vector<Output> outputs =
      checked_outputs({{"-o", request.output}, {"--json", request.json}, {"--html", request.html}},
                      files_of_system(request.system.name), request.picture.outputs());
  const operations::Operation& operation = operations::named("grow");
  const operations::Options options = checked_options(operation, request.settings);
  const operations::SystemInput input = system_input_of(request.system);
  operations::Outcome outcome;
  {
    Progress progress;
    progress.phase("growing", 0, 0.9);
    operations::Context context;
    context.progress = told_to(progress);
    context.count = [&](double amount, std::string_view unit) { progress.count(amount, unit); };
    context.keeps_what_is_known = true;
    outcome = operation.run(std::array<operations::Input, 1>{input}, options, context);
    const auto& manifold = outcome.as<SystemManifold>();
    std::optional<CancellationScope> shield;  // what was grown is written, even after an interrupt
    if (manifold.stop == GrowthStop::cancelled) {
      shield.emplace(CancellationScope::Shield{});
    } else {
      progress.phase("writing", 0.9, 1);
    }
    const detail::Stopwatch write_watch;
    if (!request.output.empty()) {
      write_curve_file(request.output, manifold.points,
                       {.format = request.format, .notes = notes_of("grow", outcome, {}, system_note(*input.system))});
    }
    if (request.picture.asked()) {
      const operations::OptionValue* const box = options.find("box");
      write_figure(request.picture,
                   grow_figure(*input.system, manifold, box != nullptr ? std::get<Rectangle>(*box) : Rectangle{},
                               request.picture));
    }
    if (!request.html.empty()) write_page(request.html, *input.system, outcome);
    const double write_seconds = write_watch.seconds();
    if (!request.json.empty()) {
      write_outcome_json(request.json, "grow", {{"system", system_json(*input.system, input.integration)}}, operation,
                         outcome, [&] {
                           return Json{{"local_manifold", manifold.local_seconds},
                                       {"growth", manifold.growth_seconds},
                                       {"write", write_seconds},
                                       {"total", watch.seconds()}};
                         });
    }
  }
  const auto& manifold = outcome.as<SystemManifold>();
  if (!takes_standard_output(outputs)) print_report(grow_summary(*input.system, manifold));
  if (manifold.stop == GrowthStop::cancelled) throw Cancelled();
  if (!ends_as_asked(manifold)) log_warning("growing ended " + end_of_growth(manifold));
}

}  // namespace

void run_grow(const std::vector<std::string>& arguments) {
  const std::optional<GrowRequest> request = parse_grow(arguments);
  if (request) run_with_threads(request->threads, [&] { run(*request); });
}

}  // namespace lober::cli

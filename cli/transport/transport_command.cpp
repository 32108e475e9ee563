// `lober transport SYSTEM`, and with --sweep over a parameter: runs the operations, and hands what they found to those
// who show it.

#include "cli/transport/transport_command.hpp"

#include <algorithm>
#include <cstdio>

#include "cli/program/command_line.hpp"
#include "cli/program/log.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/running.hpp"
#include "cli/program/table_options.hpp"
#include "cli/program/terminal.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/outcome_json.hpp"
#include "cli/report/table.hpp"
#include "cli/transport/curves_transport_command.hpp"
#include "cli/transport/sweep_report.hpp"
#include "cli/transport/transport_report.hpp"
#include "cli/view/page_output.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/base/error.hpp"
#include "lober/base/threads.hpp"

namespace lober::cli {
namespace {

struct TransportRequest {
  SystemRequest system;
  std::vector<operations::OptionSetting> settings;
  std::string sweep, json, html, fluxes;
  PictureRequest picture;
  bool find_zero = false, normalised = false;
  int threads = 0;
};

std::vector<Output> outputs_of(const TransportRequest& request) {
  std::vector<Output> outputs = request.picture.outputs();
  if (!request.json.empty()) outputs.push_back({"--json", request.json});
  if (!request.fluxes.empty()) outputs.push_back({"--fluxes", request.fluxes});
  if (!request.html.empty()) outputs.push_back({"--html", request.html});
  check_outputs(outputs, files_of_system(request.system.name));
  return outputs;
}

// The window is that of the picture of the turnstile.
FigureStyle style_of_fluxes(const TransportRequest& request) {
  FigureStyle style = request.picture.style();
  style.window.reset();
  style.inset.reset();
  return style;
}

// Rows as they come, which an interrupt keeps. On a terminal each is printed at once, before what is said about the
// manifolds, which goes on changing until the last row. Elsewhere the table comes in the end, where a disagreement is
// the first line; people at standard error see a line for each row.
class Rows {
 public:
  Rows(std::string system, int iterates, bool print_at_once)
      : system_(std::move(system)), iterates_(iterates), print_at_once_(print_at_once) {}

  void add(const TransportStep& step, const Agreement& agreement) {
    steps_.push_back(step);
    if (print_at_once_ && agreement_.agrees()) print_report(agreement_text(agreement));
    agreement_ = agreement;
    if (!print_at_once_) {
      if (wants_hints()) write_above_status_line([&] { std::fputs(transport_row_line(step).c_str(), stderr); });
      return;
    }
    if (steps_.size() == 1) print_report(system_ + "\n" + transport_rows_head(false));
    print_report(transport_row(step));
  }
  void print_rest(const TransportReport& report) const {
    const operations::SystemTransport& result = report.result();
    if (agreement_.agrees()) print_report(agreement_text(result.agreement));
    print_report(transport_matrix(result.steps) + "\n" + transport_heading(report) + transport_remarks(report));
  }
  void print_interrupted() const {
    if (steps_.empty()) return;
    print_report(print_at_once_ ? transport_interruption(steps_.size(), iterates_)
                                : interrupted_transport_table(steps_, agreement_, iterates_));
  }

 private:
  std::string system_;
  int iterates_;
  bool print_at_once_;
  std::vector<TransportStep> steps_;
  Agreement agreement_;
};

void run_one(const TransportRequest& request) {
  const detail::Stopwatch watch;
  const std::vector<Output> outputs = outputs_of(request);
  const operations::Operation& operation = operations::named("transport");
  const operations::Options options = checked_options(operation, request.settings);
  const operations::SystemInput input = system_input_of(request.system);
  TransportReport report;
  report.system = *input.system;
  const bool prints = !takes_standard_output(outputs);
  // Particles add columns to the rows when all are there.
  const bool print_at_once = prints && is_output_terminal() && options.whole("particles") == 0;
  Rows rows(system_text(report.system), static_cast<int>(options.whole("iterates")), print_at_once);
  {
    Progress progress;
    progress.phase("transport", 0, 0.9);
    operations::Context context;
    context.progress = told_to(progress);
    context.on_element = [&](const operations::Field&, const void* element, const Agreement& agreement) {
      rows.add(*static_cast<const TransportStep*>(element), agreement);
    };
    const detail::Stopwatch transport_watch;
    try {
      report.outcome = operation.run(std::array<operations::Input, 1>{input}, options, context);
    } catch (const Cancelled&) {
      if (prints) rows.print_interrupted();
      throw;
    }
    report.timing.transport = transport_watch.seconds();
    for (const std::string& remark : report.outcome.remarks) log_info(remark);
    progress.phase("writing", 0.9, 1);
    const detail::Stopwatch write_watch;
    if (!request.fluxes.empty())
      write_figure(request.fluxes, fluxes_figure(report, request.normalised), style_of_fluxes(request));
    if (request.picture.asked()) write_figure(request.picture, turnstile_figure(report, request.picture));
    if (!request.html.empty()) write_page(request.html, report);
    report.timing.write = write_watch.seconds();
    if (!request.json.empty()) {
      write_outcome_json(request.json, "transport", {{"system", system_json(report.system, input.integration)}},
                         operation, report.outcome, [&] {
                           return Json{{"transport", report.timing.transport},
                                       {"write", report.timing.write},
                                       {"total", watch.seconds()}};
                         });
    }
  }
  if (print_at_once) {
    rows.print_rest(report);
  } else if (prints) {
    print_report(transport_table(report));
  }
  require_agreement(report.outcome.agreement);
}

// Throws for options that a sweep does not have.
operations::Options sweep_options(const TransportRequest& request, const operations::Operation& operation) {
  std::vector<operations::OptionSetting> settings = request.settings;
  for (const operations::OptionSetting& setting : settings) {
    const bool known = std::any_of(operation.options.begin(), operation.options.end(),
                                   [&](const operations::OptionSpec& spec) { return spec.is_for(setting.key); });
    if (!known) throw UsageError(option_name(setting.key) + " and --sweep cannot be given together");
  }
  settings.push_back({"range", request.sweep});
  settings.push_back({"find_zeros", request.find_zero});
  return checked_options(operation, settings);
}

void run_sweep(const TransportRequest& request) {
  const detail::Stopwatch watch;
  const std::vector<Output> outputs = outputs_of(request);
  const operations::Operation& operation = operations::named("sweep");
  const operations::Options options = sweep_options(request, operation);
  const operations::SystemInput input = system_input_of(request.system);
  SweepReport report;
  report.system = input.system->info;
  const bool prints = !takes_standard_output(outputs);
  // Melnikov's function adds a column to the rows when all are there.
  const bool print_at_once = prints && is_output_terminal() && !options.flag("melnikov");
  {
    Progress progress;
    progress.phase("sweep", 0, 0.95);
    operations::Context context;
    context.progress = told_to(progress);
    if (print_at_once) {
      context.on_part = [&](const void* part) {
        const auto& so_far = *static_cast<const operations::SystemSweep*>(part);
        const std::size_t last = so_far.rows.size() - 1;
        print_report((last == 0 ? sweep_head(report.system, so_far) : "") + sweep_row(so_far, last));
      };
    }
    report.outcome = operation.run(std::array<operations::Input, 1>{input}, options, context);
    log_remarks(report.outcome.remarks);
    const Figure areas = sweep_figure(report);
    if (request.picture.asked()) write_figure(request.picture, areas);
    if (!request.fluxes.empty()) write_figure(request.fluxes, areas, request.picture.style());
    if (!request.json.empty()) {
      Json system = system_json(*input.system, input.integration);
      system["parameters"].erase(report.result().parameter);
      write_outcome_json(request.json, "transport --sweep", {{"system", system}}, operation, report.outcome, [&] {
        return Json{{"total", watch.seconds()}};
      });
    }
  }
  if (prints) print_report(print_at_once ? sweep_summary(report) : sweep_table(report));
  if (!report.outcome.failed.empty()) throw DataError(report.outcome.failed);
}

}  // namespace

void run_transport(const std::vector<std::string>& arguments) {
  if (names_manifolds(arguments)) return run_curves_transport(arguments);
  TransportRequest request;
  const operations::Operation& operation = operations::named("transport");
  const std::string description =
      operation.summary +
      " With --manifolds FILE the manifolds are given as curves (lober transport --manifolds FILE --help).";
  OptionParser parser(description.c_str(), "lober transport");
  add_system_option(parser, request.system.name, true);
  add_parameter_option(parser, request.system.parameters);
  add_integration_option(parser, request.system.integration);
  const TableOptions options(parser, operation);
  const Option sweep_option =
      parser
          .add("--sweep", request.sweep,
               "Compute the areas of the turnstile for the values FIRST to LAST of a parameter, in steps of STEP, "
               "instead of the fluxes.")
          .value("NAME=FIRST:LAST:STEP")
          .excludes(options["iterates"]);
  parser
      .add_flag("--find-zero", request.find_zero,
                "Refine the values of the parameter at which the difference in action of the two pips of the turnstile "
                "changes its sign.")
      .needs(sweep_option);
  add_json_option(parser, request.json);
  add_picture_options(parser, request.picture,
                      "the manifolds, the boundary, the turnstile and its images, or with --sweep the areas over the "
                      "parameter,",
                      "fixed points and lobes", "--picture");
  const Option fluxes = add_further_picture(parser, "--fluxes,--svg", request.fluxes,
                                            "a(n) and T(n) over n, or with --sweep the areas over the parameter,");
  parser
      .add_flag("--normalise", request.normalised,
                "Draw a(n) and T(n) as multiples of a(1), the area that crosses in the first step.")
      .needs(fluxes)
      .excludes(sweep_option);
  add_html_option(parser, request.html).excludes(sweep_option);
  add_table_option(parser);
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return;
  request.settings = options.settings();
  run_with_threads(request.threads, [&] { request.sweep.empty() ? run_one(request) : run_sweep(request); });
}

}  // namespace lober::cli

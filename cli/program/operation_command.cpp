#include "cli/program/operation_command.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <deque>

#include "cli/program/command_line.hpp"
#include "cli/program/log.hpp"
#include "cli/program/output_names.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/system_options.hpp"
#include "cli/program/table_options.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/curve_file.hpp"
#include "cli/report/outcome_json.hpp"
#include "cli/report/outcome_table.hpp"
#include "cli/report/table.hpp"
#include "cli/view/page_output.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/base/error.hpp"
#include "lober/base/threads.hpp"
#include "lober/curve/files.hpp"

namespace lober::cli {
namespace {

using operations::InputKind;

constexpr double reading_share = 0.2;  // a fraction of the whole, where curves are read

// "C1" of "c1".
std::string argument_name(const operations::InputSpec& input) {
  std::string name = input.name;
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  return name;
}

struct OperationRequest {
  SystemRequest system;
  std::deque<std::string> files;  // in the order of the inputs; in place, because they are parsed into
  std::string output, json, html, format;
  Periods periods;
  std::vector<operations::OptionSetting> settings;
  int threads = 0;
};

// The data that the inputs are views of, and their members in the JSON.
struct OperationInputs {
  std::deque<NamedCurve> curves;
  std::vector<operations::Input> inputs;
  std::vector<std::pair<std::string, Json>> members;
  std::string warning;  // empty unless curves may meet once more a period away
};

// A result that is a curve; null if it is none.
const operations::Field* curve_of_result(const operations::Operation& operation) {
  const auto found = std::find_if(operation.result.begin(), operation.result.end(), [](const operations::Field& field) {
    return field.kind == operations::FieldKind::points;
  });
  return found == operation.result.end() ? nullptr : &*found;
}

// Whether a curve is read as closed: as its kind has it, or as an option says.
bool is_closed(InputKind kind, const operations::Options& options) {
  if (kind != InputKind::curve) return kind == InputKind::closed_curve;
  return options.find("closed") != nullptr && options.flag("closed");
}

// Whether the curve that comes out is closed: as the one that it is made of.
bool result_is_closed(const operations::Operation& operation, const operations::Options& options) {
  return !operation.inputs.empty() && is_closed(operation.inputs.front().kind, options);
}

OperationInputs read_inputs(const operations::Operation& operation, const OperationRequest& request,
                            const operations::Options& options, Progress& progress) {
  OperationInputs read;
  const auto files = static_cast<std::size_t>(
      std::count_if(request.files.begin(), request.files.end(), [](const std::string& path) { return !path.empty(); }));
  if (files != 0) progress.phase("reading", 0, reading_share);
  Json names = Json::array(), hashes = Json::array();
  auto file = request.files.begin();
  for (const operations::InputSpec& spec : operation.inputs) {
    if (spec.kind == InputKind::system) {
      const operations::SystemInput system = system_input_of(request.system);
      read.members.emplace_back("system", system_json(*system.system, system.integration));
      read.inputs.emplace_back(system);
      continue;
    }
    const std::string& path = *file++;
    if (path.empty()) continue;
    progress.file(read.curves.size(), files);
    read.curves.push_back(read_curve(path, is_closed(spec.kind, options), {.periods = request.periods}));
    Curve& curve = read.curves.back().curve;
    if (read.curves.size() > 1) {
      move_near(curve.points, read.curves.front().curve.points, request.periods);
      read.warning = period_warning(read.curves.front().curve, curve, request.periods);
    }
    names.push_back(path);
    hashes.push_back(read.curves.back().sha256);
    if (spec.kind == InputKind::points) {
      read.inputs.emplace_back(std::span<const Point>(curve.points));
    } else {
      read.inputs.emplace_back(operations::CurveInput{curve, path});
    }
  }
  if (!names.empty()) {
    read.members.emplace_back("inputs", std::move(names));
    read.members.emplace_back("sha256", std::move(hashes));
  }
  if (request.periods.any()) read.members.emplace_back("periodic", periods_json(request.periods));
  return read;
}

// The system among the inputs in words; empty where there is none.
std::string system_in(const std::vector<operations::Input>& inputs) {
  for (const operations::Input& input : inputs) {
    if (const auto* const system = std::get_if<operations::SystemInput>(&input)) return system_note(*system->system);
  }
  return {};
}

void run(const operations::Operation& operation, const OperationRequest& request) {
  const detail::Stopwatch watch;
  std::vector<std::string> named;
  for (const std::string& file : request.files) {
    if (!file.empty()) named.push_back(file);
  }
  for (const std::string& file : files_of_system(request.system.name)) named.push_back(file);
  const std::vector<Output> outputs =
      checked_outputs({{"-o", request.output}, {"--json", request.json}, {"--html", request.html}}, named);
  if (!request.output.empty()) (void)curve_format(request.output, request.format, false);
  const operations::Options options = checked_options(operation, request.settings);
  OperationInputs read;
  double read_seconds = 0;
  operations::Outcome outcome;
  {
    Progress progress;
    read = read_inputs(operation, request, options, progress);
    read_seconds = watch.seconds();
    progress.phase(command_name(operation), read.curves.empty() ? 0 : reading_share, 1);
    operations::Context context;
    context.progress = told_to(progress);
    try {
      outcome = operation.run(read.inputs, options, context);
    } catch (const NotSimpleError& error) {
      const auto curve = static_cast<std::size_t>(error.curve - 1);
      if (curve >= read.curves.size()) throw;  // a manifold of a system
      const bool may_cross = options.find("check_simple") != nullptr;
      throw DataError(named[curve] + ": " + error.what() + (may_cross ? " (--no-check-simple takes such curves)" : ""));
    }
  }
  if (!read.warning.empty()) outcome.remarks.push_back(read.warning);
  if (!request.output.empty()) {
    write_curve_file(
        request.output, std::get<std::vector<Point>>(curve_of_result(operation)->get(outcome.value.get())),
        {.format = request.format,
         .closed = result_is_closed(operation, options),
         .notes = notes_of(command_name(operation), outcome, notes_on(read.curves), system_in(read.inputs))});
  }
  if (!request.html.empty()) {
    write_page(request.html, command_name(operation), operation, outcome, read.inputs, notes_on(read.curves));
  }
  if (!request.json.empty()) {
    write_outcome_json(request.json, command_name(operation), read.members, operation, outcome, [&] {
      return Json{{"read", read_seconds}, {"total", watch.seconds()}};
    });
  }
  if (!takes_standard_output(outputs)) {
    print_report(agreement_text(outcome.agreement) + outcome_table(operation.result, outcome.value.get()));
  }
  log_remarks(outcome.remarks);
  require_agreement(outcome.agreement);
  if (!outcome.incomplete.empty()) throw DataError(outcome.incomplete);
  if (!outcome.failed.empty()) throw DataError(outcome.failed);
}

}  // namespace

std::string command_name(const operations::Operation& operation) {
  std::string name = operation.name;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

const operations::Operation* operation_called(std::string_view word) {
  const std::span<const operations::Operation> table = operations::all();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const operations::Operation& any) { return command_name(any) == word; });
  return found == table.end() ? nullptr : &*found;
}

std::string call_of(const operations::Operation& operation) {
  std::string call = "lober " + command_name(operation);
  for (const operations::InputSpec& input : operation.inputs)
    call += input.optional ? " [" + argument_name(input) + "]" : " " + argument_name(input);
  return call + " [options]";
}

void run_operation(const operations::Operation& operation, const std::vector<std::string>& arguments) {
  OperationRequest request;
  OptionParser parser(operation.summary.c_str(), ("lober " + command_name(operation)).c_str());
  for (const operations::InputSpec& input : operation.inputs) {
    if (input.kind == InputKind::system) {
      add_system_option(parser, request.system.name, true);
      add_parameter_option(parser, request.system.parameters);
      add_integration_option(parser, request.system.integration);
      continue;
    }
    const std::string help = "A file of points, FILE or FILE#ZONE: " + input.meaning + ".";
    Option argument = parser.add(argument_name(input).c_str(), request.files.emplace_back(), help.c_str());
    if (!input.optional) argument.required();
  }
  const TableOptions options(parser, operation);
  if (!request.files.empty()) add_periodic_option(parser, request.periods);
  if (curve_of_result(operation) != nullptr) add_points_option(parser, request.output, request.format, false);
  add_json_option(parser, request.json);
  if (has_page(operation)) add_html_option(parser, request.html);
  add_table_option(parser);
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return;
  request.settings = options.settings();
  run_with_threads(request.threads, [&] { run(operation, request); });
}

}  // namespace lober::cli

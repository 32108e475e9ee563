// `lober transport --manifolds U S`: the fluxes of two manifolds that were computed elsewhere, as far as they reach.

#include "cli/transport/curves_transport_command.hpp"

#include <algorithm>

#include "cli/program/command_line.hpp"
#include "cli/program/log.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/table_options.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/curve_file.hpp"
#include "cli/report/outcome_json.hpp"
#include "cli/report/table.hpp"
#include "cli/tangle/tangle_report.hpp"
#include "cli/transport/transport_report.hpp"
#include "cli/view/page_output.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/base/error.hpp"
#include "lober/base/threads.hpp"

namespace lober::cli {
namespace {

struct CurvesTransportRequest {
  std::vector<std::string> files;
  std::array<bool, 2> reverse{};
  std::vector<operations::OptionSetting> settings;
  std::string json, html;
  int threads = 0;
};

Json inputs_json(const CurvesTransportReport& report, const std::array<std::string, 2>& specs,
                 const std::array<bool, 2>& reversed) {
  Json inputs = Json::array();
  for (std::size_t k = 0; k < 2; ++k) {
    const NamedCurve& input = report.inputs[k];
    inputs.push_back({{"file", spec_of(input)},
                      {"points", input.curve.points.size()},
                      {"sha256", input.sha256},
                      {"reversed", reversed[k]}});
    add_spec(inputs.back(), input, specs[k]);
  }
  return inputs;
}

void run(const CurvesTransportRequest& request) {
  const detail::Stopwatch watch;
  const std::vector<Output> outputs =
      checked_outputs({{"--json", request.json}, {"--html", request.html}}, request.files);
  const operations::Operation& operation = operations::named("curve_transport");
  const operations::Options options = checked_options(operation, request.settings);
  std::array<std::string, 2> specs{request.files[0] + "#0", request.files[0] + "#1"};
  if (request.files.size() == 2) specs = {request.files[0], request.files[1]};
  CurvesTransportReport report;
  {
    Progress progress;
    progress.phase("reading", 0, 0.3);
    for (std::size_t k = 0; k < 2; ++k) {
      progress.file(k, 2);
      report.inputs[k] = read_manifold(specs[k], request.reverse[k]);
    }
    if (request.files.size() == 1 && report.inputs[0].zones != 2) {
      throw DataError(request.files[0] + ": has " + counted(report.inputs[0].zones, "zone", "zones") +
                      "; alone it has to have two, U and S");
    }
    progress.phase("tangle", 0.3, 1);
    std::vector<operations::Input> inputs;
    for (const NamedCurve& input : report.inputs)
      inputs.emplace_back(operations::CurveInput{input.curve, spec_of(input)});
    operations::Context context;
    context.progress = [&](double fraction, const std::string&) { return progress.advance(fraction); };
    with_names_of(report.inputs[0], report.inputs[1],
                  [&] { report.outcome = operation.run(inputs, options, context); });
    log_remarks(report.outcome.remarks);
    if (!request.html.empty())
      write_page(request.html, "transport", operation, report.outcome, inputs, notes_on(report.inputs));
    if (!request.json.empty()) {
      const Json files = inputs_json(report, specs, request.reverse);
      write_outcome_json(request.json, "transport", {{"inputs", files}}, operation, report.outcome, [&] {
        return Json{{"total", watch.seconds()}};
      });
    }
  }
  if (!takes_standard_output(outputs)) print_report(transport_table(report));
  require_agreement(report.outcome.agreement);
}

}  // namespace

bool names_manifolds(const std::vector<std::string>& arguments) {
  return std::any_of(arguments.begin(), arguments.end(), [](const std::string& argument) {
    return argument == "--manifolds" || argument.starts_with("--manifolds=");
  });
}

void run_curves_transport(const std::vector<std::string>& arguments) {
  CurvesTransportRequest request;
  OptionParser parser(
      "Computes the transport across the boundary of two manifolds that are given as curves: the fluxes a(n) and T(n) "
      "by lobes and by boundaries, for as many n as there are images of the bip on the curves. No map is needed.",
      "lober transport");
  parser
      .add("--manifolds", request.files,
           "The manifolds U and S, ordered outward from their fixed points: two files, or one file of two zones.")
      .required()
      .count(1, 2)
      .value("FILE");
  const TableOptions options(parser, operations::named("curve_transport"), {"bip", "bip_near"},
                             {.before_inputs = " --manifolds"});
  std::vector<double> bip;
  const Option near = parser
                          .add("--bip", bip,
                               "A point near the boundary intersection point, the pip at which the boundary passes "
                               "from U to S (default: the middle pip).")
                          .comma_separated()
                          .count(2)
                          .value("X,Y");
  add_reverse_option(parser, request.reverse);
  add_json_option(parser, request.json);
  add_html_option(parser, request.html);
  add_table_option(parser);
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return;
  request.settings = options.settings();
  if (near.given()) request.settings.push_back({"bip_near", bip});
  run_with_threads(request.threads, [&] { run(request); });
}

}  // namespace lober::cli

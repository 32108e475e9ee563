// `lober transport --manifolds U S`: the fluxes of two manifolds that were computed elsewhere, as far as they reach.

#include "cli/transport/curves_transport_command.hpp"

#include <algorithm>

#include "cli/program/command_line.hpp"
#include "cli/program/progress.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/tangle/tangle_report.hpp"
#include "cli/transport/transport_report.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/error.hpp"
#include "lober/threads.hpp"

namespace lober::cli {
namespace {

struct CurvesTransportRequest {
  std::vector<std::string> files;
  std::vector<double> bip;
  std::uint32_t period = 0;
  int iterates = max_iterates, threads = 0;
  bool iterates_given = false;
  std::array<bool, 2> reverse{};
  std::vector<double> closure;
  bool no_check = false;
  std::string json;
};

void run(const CurvesTransportRequest& request) {
  const detail::Stopwatch watch;
  std::vector<Output> outputs;
  if (!request.json.empty()) outputs.push_back({"--json", request.json});
  check_outputs(outputs, request.files);
  std::array<std::string, 2> specs{request.files[0] + "#0", request.files[0] + "#1"};
  if (request.files.size() == 2) specs = {request.files[0], request.files[1]};
  CurvesTransportReport report;
  Tangle found;
  {
    Progress progress;
    progress.phase("reading", 0, 0.3);
    report.inputs = {read_manifold(specs[0], request.reverse[0]), read_manifold(specs[1], request.reverse[1])};
    if (request.files.size() == 1 && report.inputs[0].zones != 2) {
      throw DataError(request.files[0] + ": has " + counted(report.inputs[0].zones, "zone", "zones") +
                      "; alone it has to have two, U and S");
    }
    progress.phase("tangle", 0.3, 0.8);
    TangleOptions options;
    options.smooth = true;
    options.period = request.period;
    options.check_simple = !request.no_check;
    options.closure = closure_of(request.closure);
    if (!request.bip.empty()) options.bip_near = Point{request.bip[0], request.bip[1]};
    options.progress = [&](double fraction) { return progress.advance(fraction); };
    found = tangle_of(report.inputs[0], report.inputs[1], options);
    require_period_fits(found.images);
    report.tangle = &found;
    if (request.iterates_given) report.iterates = request.iterates;
    progress.phase("transport", 0.8, 1);
    report.result = transport(found, request.iterates);
    if (!request.json.empty()) write_transport_json(request.json, report, [&] { return watch.seconds(); });
  }
  if (!takes_standard_output(outputs)) print(transport_table(report));
  require_agreement(report.result.agreement);
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
  add_period_option(parser, request.period);
  parser
      .add("--bip", request.bip,
           "A point near the boundary intersection point, the pip at which the boundary passes from U to S (default: "
           "the middle pip).")
      .comma_separated()
      .count(2)
      .value("X,Y");
  const Option iterates =
      parser
          .add(
              "--iterates", request.iterates,
              "The number of iterates n up to which the table goes, or as far as the curves reach: n takes n images of "
              "the bip on them (default: as far as the curves reach).")
          .range(1, max_iterates)
          .value("N");
  add_closure_option(parser, request.closure);
  add_reverse_option(parser, request.reverse);
  add_manifold_check_option(parser, request.no_check);
  add_json_option(parser, request.json);
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return;
  request.iterates_given = iterates.given();
  run_with_threads(request.threads, [&] { run(request); });
}

}  // namespace lober::cli

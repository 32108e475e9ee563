// `lober interior C1 C2`: reads the curves, calls the engine, and hands what it found to those who show it.

#include "cli/interior/interior_command.hpp"

#include <spdlog/fmt/fmt.h>

#include <optional>

#include "cli/interior/interior_report.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/log.hpp"
#include "cli/program/progress.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/regions_parts.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/overlay.hpp"
#include "lober/threads.hpp"

namespace lober::cli {
namespace {

struct InteriorRequest {
  std::array<std::string, 2> curves;
  std::string json, svg;
  InteriorOptions options;
  std::optional<FillRule> rule;
  int threads = 0;
  bool verify = false;
  bool verbose = false;
};

// Nothing when the arguments asked for help, which is printed.
std::optional<InteriorRequest> parse_interior(const std::vector<std::string>& arguments) {
  InteriorRequest request;
  bool no_densify = false, no_check = false;
  std::pair<int, int> densify;
  std::string rule;
  OptionParser parser(
      "Computes the areas of two closed curves, which have to be simple unless --rule is given, by the interior "
      "function: Q1, Q2, Q3.",
      "lober interior");
  add_curve_arguments(parser, request.curves);
  const Option insert =
      parser
          .add("--densify", densify,
               "Do not split segments where the curves meet. Instead, in each of P passes, insert N points into every "
               "segment whose ends lie on different sides of the other curve, as -DENS P N of Lober 1.8 does "
               "(default: segments are split).")
          .value("P N")
          .range(0, 1'000'000);
  const Option unsplit = parser.add_flag("--no-densify", no_densify,
                                         "Neither split segments nor insert points, as -DENS 0 of Lober 1.8 does.");
  Option(unsplit).excludes(insert);
  const Option svg = parser
                         .add("--svg", request.svg,
                              "Draw the parts of both curves outside and inside of each other, the paths of Q1, Q2 "
                              "and Q3, as an SVG picture in FILE (default: no file).")
                         .value("FILE");
  add_json_option(parser, request.json);
  add_threads_option(parser, request.threads);
  const Option unchecked = add_simple_check_option(parser, no_check);
  const Option verify = parser.add_flag("--verify", request.verify,
                                        "Compute the areas by the overlay too, and report how far the two results "
                                        "differ.");
  parser.add("--rule", rule, rule_help)
      .value("RULE")
      .one_of({"nonzero", "evenodd", "positive", "negative"})
      .excludes(insert)
      .excludes(unsplit)
      .excludes(svg)
      .excludes(unchecked)
      .excludes(verify);
  add_verbose_option(parser, request.verbose);
  if (!parser.parse(arguments)) return std::nullopt;
  request.options.check_simple = !no_check;
  if (no_densify || insert.given()) request.options.method = InteriorMethod::ends;
  std::tie(request.options.passes, request.options.points) = densify;
  for (const FillRule any : all_fill_rules) {
    if (name(any) == rule) request.rule = any;
  }
  return request;
}

std::array<NamedCurve, 2> read_inputs(const InteriorRequest& request, Progress& progress) {
  progress.phase("reading", 0, 0.25);
  std::array<NamedCurve, 2> inputs;
  for (std::size_t k = 0; k < 2; ++k) {
    inputs[k] = read_curve(request.curves[k], true);
    progress.advance(0.5 * static_cast<double>(k + 1));
  }
  require_same_columns(inputs[0].curve, inputs[1].curve);
  progress.of(static_cast<double>(inputs[0].curve.points.size() + inputs[1].curve.points.size()), "points");
  return inputs;
}

InteriorReport compute(const InteriorRequest& request, Progress& progress) {
  InteriorReport report;
  report.options = request.options;
  const detail::Stopwatch read_watch;
  report.inputs = read_inputs(request, progress);
  report.read_seconds = read_watch.seconds();
  progress.phase("interior", 0.25, 0.95);
  const detail::Stopwatch index_watch;
  const IndexedCurve c1(report.inputs[0].curve), c2(report.inputs[1].curve);
  report.index_seconds = index_watch.seconds();
  InteriorOptions options = request.options;
  options.progress = [&](double fraction) { return progress.advance(fraction); };
  try {
    MeasuredAreas measured = measure_areas(c1, c2, options);
    report.result = std::move(measured.result);
    report.splitting = measured.splitting;
  } catch (const NotSimpleError& error) {
    throw DataError(request.curves[static_cast<std::size_t>(error.curve - 1)] + ": " + error.what() +
                    " (--rule takes such curves)");
  }
  if (request.verify) {
    const detail::Stopwatch verify_watch;
    OverlayOptions areas_only;
    areas_only.pieces = areas_only.check_simple = false;
    const Overlay other = overlay(c1, c2, areas_only);
    report.consistency = distance(report.result.areas, other.areas);
    for (const NamedArea& area : named_areas) {
      const auto member = area.member;
      const double splitting = report.splitting ? (*report.splitting).*member : 0;
      report.agreement.compare({std::string("area of ") + area.label, "interior", "overlay",
                                report.result.areas.*member, other.areas.*member,
                                report.result.rounding.*member + other.rounding.*member + splitting});
    }
    report.verify_seconds = verify_watch.seconds();
  }
  return report;
}

void check_outputs_of(const InteriorRequest& request) {
  std::vector<Output> outputs;
  if (!request.json.empty()) outputs.push_back({"--json", request.json});
  if (!request.svg.empty()) outputs.push_back({"--svg", request.svg});
  check_outputs(outputs, request.curves);
}

void run_by_rule(const InteriorRequest& request) {
  const detail::Stopwatch watch;
  check_outputs_of(request);
  RuledInteriorReport report;
  report.rule = *request.rule;
  {
    Progress progress;
    const detail::Stopwatch read_watch;
    report.inputs = read_inputs(request, progress);
    report.read_seconds = read_watch.seconds();
    progress.phase("regions", 0.25, 0.95);
    RegionOptions options;
    options.progress = [&](double fraction) { return progress.advance(fraction); };
    report.result = regions(ClosedCurve::borrow(report.inputs[0].curve.points),
                            ClosedCurve::borrow(report.inputs[1].curve.points), options);
    progress.phase("writing", 0.95, 1);
    if (!request.json.empty()) write_ruled_interior_json(request.json, report, [&] { return watch.seconds(); });
  }
  if (request.json != "-") print(ruled_interior_table(report));
  const RegionTiming& timing = report.result.timing();
  log_info(fmt::format(
      "seconds: read {:.4f}, index {:.4f}, search {:.4f}, nodes {:.4f}, graph {:.4f}, faces {:.4f}, "
      "total {:.4f}",
      report.read_seconds, timing.index, timing.search, timing.nodes, timing.graph, timing.faces, watch.seconds()));
}

void run(const InteriorRequest& request) {
  const detail::Stopwatch watch;
  check_outputs_of(request);
  InteriorReport report;
  {
    Progress progress;
    report = compute(request, progress);
    progress.phase("writing", 0.95, 1);
    if (!request.svg.empty()) write_interior_picture(request.svg, report);
    if (!request.json.empty()) write_interior_json(request.json, report, [&] { return watch.seconds(); });
  }
  if (request.json != "-" && request.svg != "-") print(interior_table(report));
  const InteriorTiming& timing = report.result.timing;
  log_info(fmt::format(
      "seconds: read {:.4f}, index {:.4f}, check {:.4f}, crossings {:.4f}, order {:.4f}, labels {:.4f}, sums {:.4f}, "
      "total {:.4f}",
      report.read_seconds, report.index_seconds, timing.check, timing.crossings, timing.order, timing.labels,
      timing.sums, watch.seconds()));
  require_agreement(report.agreement);
}

}  // namespace

void run_interior(const std::vector<std::string>& arguments) {
  const std::optional<InteriorRequest> request = parse_interior(arguments);
  if (!request) return;
  if (request->verbose) show_all_messages();
  run_with_threads(request->threads, [&] { request->rule ? run_by_rule(*request) : run(*request); });
}

}  // namespace lober::cli

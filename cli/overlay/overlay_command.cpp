// `lober overlay C1 C2`: reads the curves, calls the engine, and hands what it found to those who show it.

#include "cli/overlay/overlay_command.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/overlay/overlay_report.hpp"
#include "cli/overlay/regions_report.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/log.hpp"
#include "cli/program/progress.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/regions_parts.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/interior.hpp"
#include "lober/threads.hpp"

namespace lober::cli {
namespace {

struct OverlayRequest {
  std::array<std::string, 2> curves;
  std::string lobes, crossings, json, svg;
  OverlayOptions options;
  std::optional<FillRule> rule;
  int threads = 0;
  bool verify = false;
  bool smooth = false;
  bool classes = false;
  bool verbose = false;
  std::vector<double> window;  // of the picture
};

// Nothing when the arguments asked for help, which is printed.
std::optional<OverlayRequest> parse_overlay(const std::vector<std::string>& arguments) {
  OverlayRequest request;
  bool areas_only = false, no_check = false;
  std::string rule;
  OptionParser parser(
      "Computes the crossings, lobes and areas of two closed curves, which have to be simple unless --rule is given.",
      "lober overlay");
  add_curve_arguments(parser, request.curves);
  add_json_option(parser, request.json);
  const Option lobes =
      parser
          .add("--lobes", request.lobes,
               "Write the pieces of C1 \\ C2 and C2 \\ C1 to FILE as Tecplot zones (default: no file).")
          .value("FILE");
  const Option crossings = parser
                               .add("--crossings", request.crossings,
                                    "Write the crossings to FILE as comma-separated columns (default: no file).")
                               .value("FILE");
  const Option svg =
      parser.add("--svg", request.svg, "Draw the curves and the lobes as an SVG picture in FILE (default: no file).")
          .value("FILE");
  add_window_option(parser, request.window, svg);
  parser.add_flag("--areas-only", areas_only, "Compute the total areas but not the pieces, which is faster.")
      .excludes(lobes)
      .excludes(svg);
  add_index_option(parser, request.options.index);
  add_threads_option(parser, request.threads);
  const Option unchecked = add_simple_check_option(parser, no_check);
  const Option verify =
      parser.add_flag("--verify", request.verify,
                      "Compute the areas by the interior method too, and report how far the two results differ.");
  const Option smooth = parser.add_flag(
      "--smooth", request.smooth, "Compute the areas between smooth curves through the points too, with error bars.");
  const Option classes = parser.add_flag("--classes", request.classes,
                                         "Compute rho, A, gamma, sigma, class and S of every crossing, for C1 \\ C2 "
                                         "and C2 \\ C1 (Naik, Lekien & Ross 2017, "
                                         "Tables 1 to 4); --json, --crossings and --svg show them too.");
  parser.add("--rule", rule, rule_help)
      .value("RULE")
      .one_of({"nonzero", "evenodd", "positive", "negative"})
      .excludes(crossings)
      .excludes(svg)
      .excludes(unchecked)
      .excludes(verify)
      .excludes(smooth)
      .excludes(classes);
  add_verbose_option(parser, request.verbose);
  if (!parser.parse(arguments)) return std::nullopt;
  (void)window_of(request.window);
  request.options.pieces = !areas_only;
  request.options.check_simple = !no_check;
  for (const FillRule any : all_fill_rules) {
    if (name(any) == rule) request.rule = any;
  }
  return request;
}

std::vector<Output> outputs_of(const OverlayRequest& request) {
  std::vector<Output> outputs;
  for (const auto& [option, path] : {std::pair{"--json", request.json},
                                     {"--lobes", request.lobes},
                                     {"--crossings", request.crossings},
                                     {"--svg", request.svg}}) {
    if (!path.empty()) outputs.push_back({option, path});
  }
  return outputs;
}

std::array<NamedCurve, 2> read_inputs(const OverlayRequest& request, Progress& progress) {
  progress.phase("reading", 0, 0.25);
  std::array<NamedCurve, 2> inputs;
  for (std::size_t k = 0; k < 2; ++k) {
    inputs[k] = read_curve(request.curves[k], true);
    progress.advance(0.5 * static_cast<double>(k + 1));
  }
  require_same_columns(inputs[0].curve, inputs[1].curve);
  return inputs;
}

// The estimate of the discretisation is right to the leading order only: on coarse curves smooth ones through the
// points tell more. Of 690 pairs, half of them coarse, none exceeded four times the estimate.
void compare_with_smooth(OverlayReport& report) {
  for (const NamedArea& area : named_areas) {
    const auto member = area.member;
    const double polygons = report.result.areas.*member, smooth = report.smooth->areas.*member;
    double& discretisation = report.discretisation.*member;
    report.agreement.compare({std::string("area of ") + area.label, "polygons", "smooth curves", polygons, smooth,
                              report.result.rounding.*member + 4 * discretisation + report.smooth->error.*member});
    discretisation = std::max(discretisation, std::fabs(smooth - polygons));
  }
}

// Half the sum of S is the area, whatever the origin. Crossings are rounded there, which moves the boundary by an ulp
// of the coordinates over two segments at most.
void add_classes(OverlayReport& report) {
  const Overlay& result = report.result;
  report.steps = {sigma_steps(result, Pairing::c1_minus_c2), sigma_steps(result, Pairing::c2_minus_c1)};
  if (result.nodes.crossings() == 0) return;  // then no class has an area
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    double sum = 0, size = 0;
    for (const SigmaStep& step : (*report.steps)[k]) {
      sum += 0.5 * step.s;
      size += std::fabs(step.s);
    }
    const double moved =
        static_cast<double>(result.nodes.crossings()) * result.largest_coordinate * result.longest_segment;
    const double additions = static_cast<double>((*report.steps)[k].size() + 4) * size;
    report.agreement.compare({k == 0 ? "area of C1 \\ C2" : "area of C2 \\ C1", "overlay", "half the sum of S",
                              k == 0 ? result.areas.c1_minus_c2 : result.areas.c2_minus_c1, sum,
                              0x1p-51 * (moved + additions)});
  }
}

OverlayReport compute(const OverlayRequest& request, Progress& progress) {
  OverlayReport report;
  report.options = request.options;
  ReportTiming& timing = report.timing;
  const detail::Stopwatch read_watch;
  report.inputs = read_inputs(request, progress);
  timing.read = read_watch.seconds();

  progress.of(static_cast<double>(report.inputs[0].curve.points.size() + report.inputs[1].curve.points.size()),
              "points");
  progress.phase("overlay", 0.25, 0.8);
  const detail::Stopwatch index_watch;
  const IndexedCurve c1(report.inputs[0].curve), c2(report.inputs[1].curve);
  timing.index = index_watch.seconds();
  OverlayOptions options = request.options;
  options.progress = [&](double fraction) { return progress.advance(fraction); };
  try {
    report.result = overlay(c1, c2, options);
  } catch (const NotSimpleError& error) {
    const auto curve = static_cast<std::size_t>(error.curve - 1);
    const std::string& remark = report.inputs[curve].remark;
    throw DataError(request.curves[curve] + ": " + error.what() + " (--rule takes such curves)" +
                    (remark.empty() ? "" : "; the curve " + remark));
  }
  const OverlayTiming& engine = report.result.timing;
  timing.check = engine.check;
  timing.crossings = engine.crossings;
  timing.order = engine.order;
  timing.areas = engine.areas;

  progress.phase("measuring pieces", 0.8, 0.9);
  const detail::Stopwatch measure_watch;
  report.discretisation = discretisation_error(report.result);
  if (request.options.pieces) {
    for (const Pairing pairing : all_pairings) {
      // Only the JSON shows the pieces of the intersection and of the union.
      const bool lobes = pairing == Pairing::c1_minus_c2 || pairing == Pairing::c2_minus_c1;
      if (!lobes && request.json.empty()) continue;
      const auto number = static_cast<std::size_t>(pairing);
      // The table shows a few centroids, and finds those itself.
      if (!request.json.empty()) report.centroids[number] = centroids(report.result, pairing);
      report.slivers[number] = find_slivers(report.result, pairing);
      progress.advance(0.25 * static_cast<double>(number + 1));
    }
  }
  timing.measures = measure_watch.seconds();
  if (request.verify) {
    progress.phase("verifying", 0.85, 0.9);
    const detail::Stopwatch verify_watch;
    const InteriorAreas other = interior_areas(c1, c2, {.index = request.options.index, .check_simple = false});
    report.consistency = distance(report.result.areas, other.areas);
    for (const NamedArea& area : named_areas) {
      const auto member = area.member;
      report.agreement.compare({std::string("area of ") + area.label, "overlay", "interior",
                                report.result.areas.*member, other.areas.*member,
                                report.result.rounding.*member + other.rounding.*member});
    }
    timing.verify = verify_watch.seconds();
  }
  if (request.classes) add_classes(report);
  if (request.smooth) {
    const detail::Stopwatch smooth_watch;
    report.smooth = smooth_areas(report.result);
    compare_with_smooth(report);
  }
  return report;
}

void run(const OverlayRequest& request) {
  const detail::Stopwatch watch;
  const std::vector<Output> outputs = outputs_of(request);
  check_outputs(outputs, request.curves);
  OverlayReport report;
  {
    Progress progress;
    report = compute(request, progress);
    progress.phase("writing", 0.9, 1);
    const detail::Stopwatch write_watch;
    if (!request.lobes.empty()) write_lobes(request.lobes, report);
    if (!request.crossings.empty()) write_crossings(request.crossings, report);
    if (!request.svg.empty()) write_picture(request.svg, report, window_of(request.window));
    report.timing.write = write_watch.seconds();
    if (!request.json.empty()) write_overlay_json(request.json, report, [&] { return watch.seconds(); });
  }
  if (!takes_standard_output(outputs)) print(overlay_table(report));
  const ReportTiming& timing = report.timing;
  log_info(
      fmt::format("seconds: read {:.4f}, index {:.4f}, check {:.4f}, crossings {:.4f}, order {:.4f}, areas {:.4f}, "
                  "measures {:.4f}, verify {:.4f}, smooth {:.4f}, write {:.4f}, total {:.4f}",
                  timing.read, timing.index, timing.check, timing.crossings, timing.order, timing.areas,
                  timing.measures, timing.verify, timing.smooth, timing.write, watch.seconds()));
  require_agreement(report.agreement);
}

RegionsReport compute_by_rule(const OverlayRequest& request, Progress& progress) {
  RegionsReport report;
  report.rule = *request.rule;
  report.index = request.options.index;
  report.areas_only = !request.options.pieces;
  const detail::Stopwatch read_watch;
  report.inputs = read_inputs(request, progress);
  report.read_seconds = read_watch.seconds();
  progress.of(static_cast<double>(report.inputs[0].curve.points.size() + report.inputs[1].curve.points.size()),
              "points");
  progress.phase("regions", 0.25, 0.8);
  RegionOptions options;
  options.index = report.index;
  options.progress = [&](double fraction) { return progress.advance(fraction); };
  report.result = regions(ClosedCurve::borrow(report.inputs[0].curve.points),
                          ClosedCurve::borrow(report.inputs[1].curve.points), options);
  progress.phase("pieces", 0.8, 0.9);
  const detail::Stopwatch pieces_watch;
  if (!report.areas_only) {
    for (const Pairing pairing : all_pairings) {
      report.pieces[static_cast<std::size_t>(pairing)] = report.result.pieces(report.rule, pairing);
    }
  }
  report.pieces_seconds = pieces_watch.seconds();
  return report;
}

void run_by_rule(const OverlayRequest& request) {
  const detail::Stopwatch watch;
  const std::vector<Output> outputs = outputs_of(request);
  check_outputs(outputs, request.curves);
  RegionsReport report;
  {
    Progress progress;
    report = compute_by_rule(request, progress);
    progress.phase("writing", 0.9, 1);
    const detail::Stopwatch write_watch;
    if (!request.lobes.empty()) write_region_lobes(request.lobes, report);
    report.write_seconds = write_watch.seconds();
    if (!request.json.empty()) write_regions_json(request.json, report, [&] { return watch.seconds(); });
  }
  if (!takes_standard_output(outputs)) print(regions_table(report));
  const RegionTiming& timing = report.result.timing();
  log_info(fmt::format(
      "seconds: read {:.4f}, index {:.4f}, search {:.4f}, nodes {:.4f}, graph {:.4f}, faces {:.4f}, pieces {:.4f}, "
      "write {:.4f}, total {:.4f}",
      report.read_seconds, timing.index, timing.search, timing.nodes, timing.graph, timing.faces, report.pieces_seconds,
      report.write_seconds, watch.seconds()));
}

}  // namespace

void run_overlay(const std::vector<std::string>& arguments) {
  const std::optional<OverlayRequest> request = parse_overlay(arguments);
  if (!request) return;
  if (request->verbose) show_all_messages();
  run_with_threads(request->threads, [&] { request->rule ? run_by_rule(*request) : run(*request); });
}

}  // namespace lober::cli

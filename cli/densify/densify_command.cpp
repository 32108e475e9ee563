// `lober densify CURVE [AGAINST]`: reads the curves, calls the engine step by step, writes the points.

#include "cli/densify/densify_command.hpp"

#include <algorithm>

#include "cli/densify/densify_report.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/output_names.hpp"
#include "cli/program/progress.hpp"
#include "cli/report/point_file.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/threads.hpp"

namespace lober::cli {
namespace {

struct DensifyRequest {
  std::vector<std::string> curves;
  std::string output, against_output, json;
  bool open = false, open_against = false;
  // Infinity and negative numbers: not given.
  bool hobson = false;
  double max_length = Criteria::off, alpha = Criteria::off, distance_angle = Criteria::off, min_length = -1;
  double simplify = -1;
  DensifySteps steps;
  int threads = 0;
};

void add_options(OptionParser& parser, DensifyRequest& request, std::string& interpolation) {
  DensifySteps& steps = request.steps;
  parser
      .add("CURVES", request.curves,
           "CURVE, and AGAINST for --passes and --crossings: FILE, or FILE#ZONE for one zone of it (by number from 0, "
           "or by title).")
      .required()
      .count(1, 2);
  add_points_option(parser, request.output, true);
  parser.add_flag("--open", request.open, "Read CURVE as an open curve: its last vertex is not joined to the first.");
  parser.add_flag("--open-against", request.open_against, "Read AGAINST as an open curve.");
  parser
      .add("--simplify", request.simplify,
           "The maximum distance of a removed vertex from the curve that remains, in units of the coordinates; "
           "vertices are removed before all other steps (default: no vertex is removed).")
      .not_negative()
      .value("LENGTH");
  parser
      .add("--max-length", request.max_length,
           "The maximum length of a segment (tau), in units of the coordinates: longer segments are split, and "
           "--simplify makes none (default: no maximum).")
      .positive()
      .value("LENGTH");
  parser.add_flag("--hobson", request.hobson,
                  "Use the angle criteria of Hobson and of Mancho et al., with limits relative to the size of the "
                  "curve, which is the longer side of its bounding box.");
  parser
      .add("--alpha", request.alpha,
           "The maximum angle between consecutive segments, in radians (default: no maximum; with --hobson 0.3).")
      .positive()
      .value("ANGLE");
  parser
      .add("--distance-angle", request.distance_angle,
           "The maximum product of the length of a segment and the angles at its ends, in units of the coordinates "
           "(default: no maximum; with --hobson 1e-3 of the size).")
      .positive()
      .value("LENGTH");
  parser
      .add("--min-length", request.min_length,
           "The minimum length of a segment (delta), in units of the coordinates: no segment is split into shorter "
           "ones (default: 0; with angle criteria 1e-6 of the size).")
      .not_negative()
      .value("LENGTH");
  const Option passes = parser
                            .add("--passes", steps.passes,
                                 "The number of passes that refine CURVE where it meets AGAINST (default: none).")
                            .range(1, 64)
                            .value("P");
  parser
      .add("--points", steps.points,
           "The number of points that each pass inserts into a segment that meets AGAINST; --passes needs it.")
      .range(1, 1'000'000)
      .needs(passes)
      .value("N");
  const Option crossings =
      parser.add_flag("--crossings", steps.crossings, "Insert a vertex wherever CURVE meets AGAINST.");
  parser
      .add("--against-output", request.against_output,
           "Write AGAINST with the same vertices inserted to FILE, in a format of -o (default: no file).")
      .needs(crossings)
      .value("FILE");
  parser
      .add("--interpolation", interpolation,
           "The interpolation between the vertices: linear, spline or dritschel (default: linear; with angle criteria "
           "dritschel).")
      .one_of({"linear", "spline", "dritschel"})
      .value("KIND");
  parser.add("--max-points", steps.max_points, "The maximum number of points of the result (default: 100000000).")
      .range(std::size_t{1}, std::size_t{2'147'483'647})
      .value("N");
  add_json_option(parser, request.json, "a report of the steps");
  add_threads_option(parser, request.threads);
}

// Checks that the parser cannot make.
void check(const DensifyRequest& request) {
  const DensifySteps& steps = request.steps;
  const bool near = steps.passes > 0 || steps.crossings;
  if (near && request.curves.size() < 2)
    throw UsageError("--passes and --crossings need AGAINST (see lober densify --help)");
  if (!near && request.curves.size() == 2) {
    throw UsageError("AGAINST is given without --passes or --crossings; give one of them (see lober densify --help)");
  }
  if (steps.passes > 0 && steps.points == 0) throw UsageError("--passes needs --points (see lober densify --help)");
  if (!near && request.open_against) throw UsageError("--open-against needs AGAINST (see lober densify --help)");
  if (!near && !steps.criteria && !steps.simplify) {
    throw UsageError(
        "no step is given; give --simplify, --max-length, --hobson, --alpha, --distance-angle, --passes or "
        "--crossings");
  }
  (void)format_of(request.output);
  if (!request.against_output.empty()) (void)format_of(request.against_output);
}

// Nothing when the arguments asked for help, which is printed.
std::optional<DensifyRequest> parse_densify(const std::vector<std::string>& arguments) {
  DensifyRequest request;
  DensifySteps& steps = request.steps;
  steps.max_points = DensifyOptions{}.max_points;
  std::string interpolation;
  OptionParser parser(
      "Inserts points into a curve, or removes them. The steps are taken in the order --simplify, criteria "
      "(--max-length, --hobson, --alpha, --distance-angle), --passes, --crossings.",
      "lober densify");
  add_options(parser, request, interpolation);
  if (!parser.parse(arguments)) return std::nullopt;
  const bool angles = request.hobson || request.alpha < Criteria::off || request.distance_angle < Criteria::off;
  if (angles || request.max_length < Criteria::off) steps.criteria = Criteria{};
  if (request.min_length >= 0 && !steps.criteria)
    throw UsageError("--min-length needs --max-length, --hobson, --alpha or --distance-angle");
  if (request.simplify >= 0) steps.simplify = SimplifyOptions{request.simplify, request.max_length};
  steps.interpolation = angles ? Interpolation::dritschel : Interpolation::linear;
  for (const Interpolation kind : {Interpolation::linear, Interpolation::dritschel, Interpolation::spline}) {
    if (name(kind) == interpolation) steps.interpolation = kind;
  }
  check(request);
  return request;
}

// The criteria with what was not given taken from the size of the curve.
Criteria criteria_for(const DensifyRequest& request, CurveView curve) {
  const Criteria usual = hobson_criteria(curve);
  const bool angles = request.hobson || request.alpha < Criteria::off || request.distance_angle < Criteria::off;
  Criteria criteria{request.max_length, request.alpha, request.distance_angle, std::max(request.min_length, 0.0)};
  if (request.hobson && !(request.alpha < Criteria::off)) criteria.angle = usual.angle;
  if (request.hobson && !(request.distance_angle < Criteria::off)) criteria.distance_angle = usual.distance_angle;
  if (angles && request.min_length < 0) criteria.min_length = usual.min_length;
  return criteria;
}

void compute(const DensifyRequest& request, DensifyReport& report, Progress& progress) {
  DensifySteps& steps = report.steps;
  DensifiedCurve& result = report.result;
  const auto& given = report.inputs[0].curve;
  result.points.assign(given.points.begin(), given.points.end());
  result.closed = given.closed;
  const auto done = [&](const char* step, DensifiedCurve&& curve) {
    result = std::move(curve);
    report.done.push_back({step, result.points.size(), result.rounds});
    progress.advance(0.5);
  };
  progress.of(static_cast<double>(given.points.size()), "points");
  progress.phase("densifying", 0.3, 0.8);
  if (steps.simplify) done("simplify", simplify(result, *steps.simplify));
  if (steps.criteria) {
    steps.criteria = criteria_for(request, result);
    done("criteria", densify(result, *steps.criteria, {steps.interpolation, steps.max_points}));
    report.diagnostic_counts.resize(static_cast<std::size_t>(DiagnosticCause::max_rounds) + 1);
    for (const Diagnostic& diagnostic : result.diagnostics)
      ++report.diagnostic_counts[static_cast<std::size_t>(diagnostic.cause)];
    if (report.inputs.size() == 1) report.diagnostics = std::move(result.diagnostics);
  }
  if (steps.passes > 0) {
    const NearOptions near{steps.passes, steps.points, steps.interpolation, steps.max_points};
    done("passes", densify_near(result, report.inputs[1].curve, near));
  }
  if (steps.crossings) {
    auto [curve, against] = insert_crossings(result, report.inputs[1].curve);
    done("crossings", std::move(curve));
    report.against = std::move(against);
  }
}

void run(const DensifyRequest& request) {
  const detail::Stopwatch watch;
  std::vector<Output> outputs{{"-o", request.output}};
  if (!request.against_output.empty()) outputs.push_back({"--against-output", request.against_output});
  if (!request.json.empty()) outputs.push_back({"--json", request.json});
  check_outputs(outputs, request.curves);
  DensifyReport report;
  report.steps = request.steps;
  {
    Progress progress;
    progress.phase("reading", 0, 0.3);
    const detail::Stopwatch read_watch;
    report.inputs.push_back(read_curve(request.curves[0], !request.open));
    if (request.curves.size() == 2) {
      report.inputs.push_back(read_curve(request.curves[1], !request.open_against));
      require_same_columns(report.inputs[0].curve, report.inputs[1].curve);
    }
    report.timing.read = read_watch.seconds();
    const detail::Stopwatch densify_watch;
    compute(request, report, progress);
    report.timing.densify = densify_watch.seconds();
    progress.phase("writing", 0.8, 1);
    const detail::Stopwatch write_watch;
    write_points(request.output, report.result.points);
    if (!request.against_output.empty()) write_points(request.against_output, report.against->points);
    report.timing.write = write_watch.seconds();
    if (!request.json.empty()) write_densify_json(request.json, report, [&] { return watch.seconds(); });
  }
  if (!takes_standard_output(outputs)) print(densify_summary(report));
}

}  // namespace

void run_densify(const std::vector<std::string>& arguments) {
  const std::optional<DensifyRequest> request = parse_densify(arguments);
  if (request) run_with_threads(request->threads, [&] { run(*request); });
}

}  // namespace lober::cli

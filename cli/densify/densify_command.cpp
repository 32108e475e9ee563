// `lober densify CURVE [AGAINST]`: reads the curves, calls the engine step by step, writes the points.

#include "cli/densify/densify_command.hpp"

#include <algorithm>

#include "cli/densify/densify_report.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/output_names.hpp"
#include "cli/program/progress.hpp"
#include "cli/report/point_file.hpp"
#include "engine/base/stopwatch.hpp"

namespace lober::cli {
namespace {

struct Request {
  std::vector<std::string> curves;
  std::string output, against_output, json;
  bool open = false, open_against = false;
  // Infinity and negative numbers: not given.
  bool hobson = false;
  double tau = Criteria::off, alpha = Criteria::off, distance_angle = Criteria::off, delta = -1, remove = -1;
  DensifySteps steps;
  int threads = 0;
};

void add_options(OptionParser& parser, Request& request, std::string& interpolation) {
  DensifySteps& steps = request.steps;
  parser.add("CURVES", request.curves, "CURVE [AGAINST]: FILE, or FILE#ZONE for one zone (from 0, or by title)")
      .required()
      .count(1, 2);
  parser.add("-o,--output", request.output, "where the points go: .npy, .csv, .txt, .dat or .raw (- for text)")
      .value("FILE");
  parser.add_flag("--open", request.open, "CURVE is open: its last vertex is not joined to the first");
  parser.add_flag("--open-against", request.open_against, "AGAINST is open");
  parser.add("--remove", request.remove, "first remove vertices that lie no farther than this from what remains")
      .not_negative()
      .value("TOL");
  parser.add("--tau", request.tau, "split segments longer than this (and remove none that would leave such)")
      .positive()
      .value("LENGTH");
  parser.add_flag("--hobson", request.hobson,
                  "angle criteria of Hobson and Mancho et al., with values for the curve's size");
  parser.add("--alpha", request.alpha, "largest angle between segments, radians (with --hobson: 0.3)")
      .positive()
      .value("ANGLE");
  parser.add("--distance-angle", request.distance_angle, "largest length times angle (with --hobson: 1e-3 of the size)")
      .positive()
      .value("LENGTH");
  parser.add("--delta", request.delta, "make no segment shorter than this (with angles: 1e-6 of the size)")
      .not_negative()
      .value("LENGTH");
  const Option passes =
      parser.add("--passes", steps.passes, "refine this often where CURVE meets AGAINST").range(1, 64).value("P");
  parser.add("--points", steps.points, "put this many points into such a segment in each pass")
      .range(1, 1'000'000)
      .needs(passes)
      .value("N");
  const Option crossings = parser.add_flag("--crossings", steps.crossings, "a vertex wherever CURVE meets AGAINST");
  parser.add("--against-output", request.against_output, "AGAINST with the same vertices")
      .needs(crossings)
      .value("FILE");
  parser.add("--interpolation", interpolation, "linear (default), spline or dritschel (default with angles)")
      .one_of({"linear", "spline", "dritschel"})
      .value("KIND");
  parser.add("--max-points", steps.most_points, "of the result")
      .range(std::size_t{1}, std::size_t{2'147'483'647})
      .value("M");
  parser.add("--json", request.json, "write what was done as one JSON object (- for standard output)").value("FILE");
  add_threads_option(parser, request.threads);
}

// What the parser cannot see.
void check(const Request& request) {
  const DensifySteps& steps = request.steps;
  const bool near = steps.passes > 0 || steps.crossings;
  if (near && request.curves.size() < 2)
    throw UsageError("--passes and --crossings need AGAINST (see lober densify --help)");
  if (!near && request.curves.size() == 2) {
    throw UsageError("AGAINST is given, but neither --passes nor --crossings (see lober densify --help)");
  }
  if (steps.passes > 0 && steps.points == 0) throw UsageError("--passes needs --points (see lober densify --help)");
  if (!near && request.open_against) throw UsageError("--open-against needs AGAINST (see lober densify --help)");
  if (!near && !steps.criteria && !steps.thin) {
    throw UsageError("nothing to do: give --tau, --hobson, --alpha, --passes, --crossings or --remove");
  }
  if (request.output.empty()) throw UsageError("-o FILE is needed (see lober densify --help)");
  (void)format_of(request.output);
  if (!request.against_output.empty()) (void)format_of(request.against_output);
}

// Nothing when the arguments asked for help, which is printed.
std::optional<Request> parse(const std::vector<std::string>& arguments) {
  Request request;
  DensifySteps& steps = request.steps;
  steps.most_points = DensifyOptions{}.most_points;
  std::string interpolation;
  OptionParser parser(
      "Inserts points into a curve, or removes them. Steps are taken in the order --remove, criteria, --passes, "
      "--crossings.",
      "lober densify");
  add_options(parser, request, interpolation);
  if (!parser.parse(arguments)) return std::nullopt;
  const bool angles = request.hobson || request.alpha < Criteria::off || request.distance_angle < Criteria::off;
  if (angles || request.tau < Criteria::off) steps.criteria = Criteria{};
  if (request.delta >= 0 && !steps.criteria)
    throw UsageError("--delta needs --tau, --hobson, --alpha or --distance-angle");
  if (request.remove >= 0) steps.thin = ThinOptions{request.remove, request.tau};
  steps.interpolation = angles ? Interpolation::dritschel : Interpolation::linear;
  for (const Interpolation kind : {Interpolation::linear, Interpolation::dritschel, Interpolation::spline}) {
    if (name(kind) == interpolation) steps.interpolation = kind;
  }
  check(request);
  return request;
}

// The criteria with what was not given taken from the size of the curve.
Criteria criteria_for(const Request& request, CurveView curve) {
  const Criteria usual = hobson_criteria(curve);
  const bool angles = request.hobson || request.alpha < Criteria::off || request.distance_angle < Criteria::off;
  Criteria criteria{request.tau, request.alpha, request.distance_angle, std::max(request.delta, 0.0)};
  if (request.hobson && !(request.alpha < Criteria::off)) criteria.angle = usual.angle;
  if (request.hobson && !(request.distance_angle < Criteria::off)) criteria.distance_angle = usual.distance_angle;
  if (angles && request.delta < 0) criteria.shortest = usual.shortest;
  return criteria;
}

void compute(const Request& request, DensifyReport& report, Progress& progress) {
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
  if (steps.thin) done("remove", thin(result, *steps.thin));
  if (steps.criteria) {
    steps.criteria = criteria_for(request, result);
    done("criteria", densify(result, *steps.criteria, {steps.interpolation, steps.most_points}));
    report.flaw_counts.resize(static_cast<std::size_t>(FlawCause::not_finite) + 1);
    for (const Flaw& flaw : result.flaws) ++report.flaw_counts[static_cast<std::size_t>(flaw.cause)];
    if (report.inputs.size() == 1) report.flaws = std::move(result.flaws);
  }
  if (steps.passes > 0) {
    const NearOptions near{steps.passes, steps.points, steps.interpolation, steps.most_points};
    done("passes", densify_near(result, report.inputs[1].curve, near));
  }
  if (steps.crossings) {
    auto [curve, against] = insert_crossings(result, report.inputs[1].curve);
    done("crossings", std::move(curve));
    report.against = std::move(against);
  }
}

void run(const Request& request) {
  const Stopwatch watch;
  std::vector<Output> outputs{{"-o", request.output}};
  if (!request.against_output.empty()) outputs.push_back({"--against-output", request.against_output});
  if (!request.json.empty()) outputs.push_back({"--json", request.json});
  check_outputs(outputs, request.curves);
  DensifyReport report;
  report.steps = request.steps;
  {
    Progress progress;
    progress.phase("reading", 0, 0.3);
    const Stopwatch read_watch;
    report.inputs.push_back(read_curve(request.curves[0], !request.open));
    if (request.curves.size() == 2) report.inputs.push_back(read_curve(request.curves[1], !request.open_against));
    report.timing.read = read_watch.seconds();
    const Stopwatch densify_watch;
    compute(request, report, progress);
    report.timing.densify = densify_watch.seconds();
    progress.phase("writing", 0.8, 1);
    const Stopwatch write_watch;
    write_points(request.output, report.result.points);
    if (!request.against_output.empty()) write_points(request.against_output, report.against->points);
    report.timing.write = write_watch.seconds();
    if (!request.json.empty()) write_densify_json(request.json, report, [&] { return watch.seconds(); });
  }
  if (!takes_standard_output(outputs)) print(densify_summary(report));
}

}  // namespace

void run_densify(const std::vector<std::string>& arguments) {
  const std::optional<Request> request = parse(arguments);
  if (request) with_thread_limit(request->threads, [&] { run(*request); });
}

}  // namespace lober::cli

// `lober grow SYSTEM`: makes the system, finds the local manifold, grows it, writes the points.

#include "cli/grow/grow_command.hpp"

#include "cli/grow/grow_report.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/log.hpp"
#include "cli/program/output_names.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/system_options.hpp"
#include "cli/report/point_file.hpp"
#include "cli/report/text.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/cancellation.hpp"
#include "lober/fixed_points.hpp"
#include "lober/threads.hpp"

namespace lober::cli {
namespace {

struct GrowRequest {
  std::string system;
  std::vector<std::string> parameters;
  std::vector<double> from, box;
  bool unstable = false, stable = false;
  std::string branch, output, json;
  int period = 1, threads = 0;
  IntegrationOptions integration;
  GrowthOptions growth;
};

void add_options(OptionParser& parser, GrowRequest& request) {
  GrowthOptions& growth = request.growth;
  add_system_option(parser, request.system, true);
  add_parameter_option(parser, request.parameters);
  parser
      .add("--from", request.from,
           "A point near the saddle, in the coordinates of the map (default: the saddle of the system's tangle, or "
           "else the only saddle in the system's window).")
      .comma_separated()
      .count(2)
      .value("X,Y");
  parser
      .add("--period", request.period,
           "The least period of the saddle, in iterates of the map (default: 1, a fixed point).")
      .range(1, max_iterates)
      .value("P");
  const Option unstable = parser.add_flag("--unstable", request.unstable, "Grow the unstable manifold.");
  parser.add_flag("--stable", request.stable, "Grow the stable manifold.").excludes(unstable);
  parser
      .add("--branch", request.branch,
           "The branch of the manifold: + leaves the saddle to the right, - to the left, or up and down if the tangent "
           "is vertical (default: the branch of the system's tangle, or else +).")
      .one_of({"+", "-", "plus", "minus"})
      .value("+|-");
  add_tolerance_option(parser, growth.tolerance,
                       "The maximum distance between the manifold and its polygon, in units of the coordinates "
                       "(default: 1e-5).");
  parser
      .add("--iterates", growth.iterates,
           "The number of images of the local manifold after which growing ends (default: no limit, and --length has "
           "to be given).")
      .range(0, 100000)
      .value("N");
  parser
      .add("--length", growth.length,
           "The arc length of the manifold at which growing ends, in units of the coordinates (default: no limit, and "
           "--iterates has to be given).")
      .positive()
      .value("LENGTH");
  parser
      .add("--max-length", growth.max_length,
           "The maximum length of a segment, in units of the coordinates (default: 1/50 of the extent of the local "
           "manifold).")
      .positive()
      .value("LENGTH");
  parser
      .add("--box", request.box,
           "Two corners of the box in which the tolerance holds, X0 < X1 and Y0 < Y1; outside it the manifold is "
           "followed coarsely (default: a square around the saddle, 200 extents of the local manifold wide).")
      .comma_separated()
      .count(4)
      .value("X0,Y0,X1,Y1");
  add_max_points_option(parser, growth.max_points,
                        "The maximum number of points, at which growing ends (default: 100000000).");
  add_memory_option(parser, growth.max_memory,
                    "The memory, in bytes or with a unit, as 4G or 500M, at which growing ends (default: no limit).");
  add_integration_option(parser, request.integration);
  add_points_option(parser, request.output, false);
  add_json_option(parser, request.json, "a report of the growth");
  add_threads_option(parser, request.threads);
}

// Checks that the parser cannot make.
void check(GrowRequest& request) {
  if (request.unstable == request.stable) {
    throw UsageError("the side of the manifold is missing; give --unstable or --stable (see lober grow --help)");
  }
  if (request.growth.iterates < 0 && !(request.growth.length < std::numeric_limits<double>::infinity())) {
    throw UsageError("the end of the manifold is missing; give --iterates or --length (see lober grow --help)");
  }
  if (!request.box.empty()) {
    const Point low{request.box[0], request.box[1]}, high{request.box[2], request.box[3]};
    if (!(low.x < high.x && low.y < high.y)) throw UsageError("--box: the corners have to have X0 < X1 and Y0 < Y1");
    request.growth.box = Rectangle::of(low, high);
  }
  if (!request.output.empty()) (void)format_of(request.output);
}

// The fraction of the growth that is done, as far as it can be known: by the length, and by the cost of the iterates so
// far.
class GrowthFraction {
 public:
  explicit GrowthFraction(const GrowthOptions& options) : options_(options) {}

  double operator()(const GrowthProgress& progress) {
    const auto images = static_cast<double>(progress.images);
    if (progress.iterates > iterates_) {
      cost_.add(std::max(images - begin_, 1.0));
      begin_ = images;
      iterates_ = progress.iterates;
    }
    const double by_length = progress.length / options_.length;
    double by_iterates = 0;
    if (options_.iterates > 0 && cost_.count() > 1) {
      by_iterates = images / std::max(begin_ + cost_.sum(options_.iterates - iterates_), images);
    }
    return std::clamp(std::max(by_length, by_iterates), 0.0, 1.0);
  }

 private:
  const GrowthOptions& options_;
  detail::GrowthForecast cost_;  // images of points, iterate by iterate
  double begin_ = 0;             // of the present iterate
  int iterates_ = 0;
};

ManifoldSide manifold_side(const GrowRequest& request) {
  return request.stable ? ManifoldSide::stable : ManifoldSide::unstable;
}

// Whether it is the manifold of the tangle that the system is known for: the user names no other saddle.
bool of_tangle(const GrowRequest& request, const System& system) {
  return request.from.empty() && request.period == 1 && system.connection;
}

// The one that the user named, that of the tangle, or the only one in the system's window.
Point saddle_of(const GrowRequest& request, const System& system) {
  if (request.from.size() == 2) return {request.from[0], request.from[1]};
  if (of_tangle(request, system)) return system.connection->saddle(manifold_side(request));
  std::vector<Point> saddles;
  std::string positions;
  for (const FixedPoint& point : find_fixed_points(*system.map, system.window, {.period = request.period})) {
    if (point.kind != FixedPointKind::saddle && point.kind != FixedPointKind::inverse_saddle) continue;
    if (point.period != request.period) continue;
    saddles.push_back(point.at);
    append_all(positions, positions.empty() ? "" : ", ", point.at.x, ",", point.at.y);
  }
  if (saddles.empty()) {
    throw DataError("system " + system.info.name +
                    ": no saddle was found in its window; give a point near one by --from");
  }
  if (saddles.size() > 1) {
    throw UsageError("system " + system.info.name + " has several saddles; choose one by --from: " + positions);
  }
  return saddles.front();
}

Branch branch_of(const GrowRequest& request, const System& system, const LocalManifold& local) {
  if (request.branch == "-" || request.branch == "minus") return Branch::minus;
  if (!request.branch.empty() || !of_tangle(request, system)) return Branch::plus;
  return branch_towards(local, system.connection->direction(manifold_side(request)));
}

void run(const GrowRequest& request) {
  const detail::Stopwatch watch;
  std::vector<Output> outputs;
  if (!request.output.empty()) outputs.push_back({"-o", request.output});
  if (!request.json.empty()) outputs.push_back({"--json", request.json});
  check_outputs(outputs, files_of_system(request.system));
  GrowReport report;
  report.system = make_system(request.system, parameter_values(request.parameters), request.integration);
  if (!report.system.map) {
    throw UsageError("system " + request.system + " has no planar map, which this command needs");
  }
  report.integration = request.integration;
  report.options = request.growth;
  {
    Progress progress;
    progress.phase("local manifold", 0, 0.1);
    const detail::Stopwatch local_watch;
    LocalManifoldOptions local;
    local.period = request.period;
    report.local = local_manifold(*report.system.map, saddle_of(request, report.system), manifold_side(request), local);
    report.branch = branch_of(request, report.system, report.local);
    report.timing.local = local_watch.seconds();
    progress.phase("growing", 0.1, 0.9);
    const detail::Stopwatch growth_watch;
    GrowthFraction fraction(request.growth);
    report.options.progress = [&](const GrowthProgress& at) {
      progress.count(static_cast<double>(at.points), "points");
      return progress.advance(fraction(at));
    };
    report.manifold = grow(*report.system.map, report.local, report.branch, report.options);
    report.timing.growth = growth_watch.seconds();
    std::optional<CancellationScope> shield;  // what was grown is written, even after an interrupt
    if (report.manifold.stop == GrowthStop::cancelled) {
      shield.emplace(CancellationScope::Shield{});
    } else {
      progress.phase("writing", 0.9, 1);
    }
    const detail::Stopwatch write_watch;
    if (!request.output.empty()) write_points(request.output, report.manifold.points);
    report.timing.write = write_watch.seconds();
    if (!request.json.empty()) write_grow_json(request.json, report, [&] { return watch.seconds(); });
  }
  if (!takes_standard_output(outputs)) print(grow_summary(report));
  if (report.manifold.stop == GrowthStop::cancelled) throw Cancelled();
  if (!ends_as_asked(report)) log_warning("growing ended " + end_of_growth(report));
}

}  // namespace

void run_grow(const std::vector<std::string>& arguments) {
  GrowRequest request;
  OptionParser parser(
      "Grows a branch of the stable or unstable manifold of a saddle of a map, or of a flow's Poincare map.",
      "lober grow");
  add_options(parser, request);
  if (!parser.parse(arguments)) return;
  check(request);
  run_with_threads(request.threads, [&] { run(request); });
}

}  // namespace lober::cli

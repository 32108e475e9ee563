// `lober grow SYSTEM`: makes the system, finds the local manifold, grows it, writes the points.

#include "cli/grow/grow_command.hpp"

#include "cli/grow/grow_report.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/output_names.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/system_options.hpp"
#include "cli/report/point_file.hpp"
#include "cli/report/text.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/cancellation.hpp"
#include "lober/fixed_points.hpp"

namespace lober::cli {
namespace {

struct Request {
  std::string system;
  std::vector<std::string> parameters;
  std::vector<double> fixed_point, box;
  bool unstable = false, stable = false;
  std::string branch, output, json;
  int period = 1, threads = 0;
  IntegrationOptions integration;
  GrowthOptions growth;
};

void add_options(OptionParser& parser, Request& request) {
  GrowthOptions& growth = request.growth;
  parser.add("SYSTEM,--system", request.system, "name of a built-in system, or the path of a shared library")
      .required();
  parser.add("--param", request.parameters, "parameters of the system").value("NAME=VALUE");
  parser
      .add("--fixed-point", request.fixed_point,
           "where the saddle is, roughly (default: that of the system's tangle, or else the only one in its window)")
      .comma_separated()
      .count(2)
      .value("X,Y");
  parser.add("--period", request.period, "least period of the saddle, if it is no fixed point")
      .range(1, 1000)
      .value("P");
  const Option unstable = parser.add_flag("--unstable", request.unstable, "grow the unstable manifold");
  parser.add_flag("--stable", request.stable, "grow the stable manifold").excludes(unstable);
  parser
      .add("--branch", request.branch,
           "the branch to the right (+) or left (-) of the saddle, or up and down (default: that of the system's "
           "tangle, or else the right one)")
      .one_of({"+", "-", "plus", "minus"})
      .value("+|-");
  parser.add("--tol", growth.tolerance, "how far the curve may lie from its polygon")
      .required()
      .positive()
      .value("LENGTH");
  parser.add("--iterates", growth.iterates, "so many images of the local manifold").range(0, 100000).value("N");
  parser.add("--length", growth.length, "up to this arc length").positive().value("LENGTH");
  parser.add("--longest", growth.longest, "no segment longer than this").positive().value("LENGTH");
  parser.add("--box", request.box, "what is outside is followed coarsely")
      .comma_separated()
      .count(4)
      .value("X0,Y0,X1,Y1");
  parser.add("--max-points", growth.most_points, "stop at so many points")
      .range(std::size_t{2}, std::size_t{2'147'483'646})
      .value("N");
  parser.add("--max-memory", growth.most_memory, "stop when about so many bytes are in use").bytes().value("BYTES");
  parser.add("--integration-tolerance", request.integration.tolerance, "of flows (default 1e-12)")
      .positive()
      .value("T");
  parser.add("-o,--output", request.output, "where the points go: .npy, .csv, .txt, .dat or .raw (- for text)")
      .value("FILE");
  parser.add("--json", request.json, "write what was done as one JSON object (- for standard output)").value("FILE");
  add_threads_option(parser, request.threads);
}

// What the parser cannot see.
void check(Request& request) {
  if (request.unstable == request.stable) throw UsageError("give --unstable or --stable (see lober grow --help)");
  if (request.growth.iterates < 0 && !(request.growth.length < std::numeric_limits<double>::infinity())) {
    throw UsageError("give --iterates or --length (see lober grow --help)");
  }
  if (!request.box.empty()) {
    const Point low{request.box[0], request.box[1]}, high{request.box[2], request.box[3]};
    if (!(low.x < high.x && low.y < high.y)) throw UsageError("--box: X0 < X1 and Y0 < Y1 are needed");
    request.growth.box = Rectangle::of(low, high);
  }
  if (!request.output.empty()) (void)format_of(request.output);
}

// How far growth is, as far as anyone can know: by its length, and by what the iterates cost so far.
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
  GrowthForecast cost_;  // images of points, iterate by iterate
  double begin_ = 0;     // of the present iterate
  int iterates_ = 0;
};

ManifoldSide side_of(const Request& request) {
  return request.stable ? ManifoldSide::stable : ManifoldSide::unstable;
}

// Whether it is the manifold of the tangle that the system is known for: the user names no other saddle.
bool of_tangle(const Request& request, const System& system) {
  return request.fixed_point.empty() && request.period == 1 && system.connection;
}

// The one that the user named, that of the tangle, or the only one in the system's window.
Point saddle_of(const Request& request, const System& system) {
  if (request.fixed_point.size() == 2) return {request.fixed_point[0], request.fixed_point[1]};
  if (of_tangle(request, system)) return system.connection->saddle(side_of(request));
  std::vector<Point> saddles;
  std::string places;
  for (const FixedPoint& point : find_fixed_points(*system.map, system.window, {.period = request.period})) {
    if (point.kind != FixedPointKind::saddle && point.kind != FixedPointKind::inverse_saddle) continue;
    if (point.period != request.period) continue;
    saddles.push_back(point.at);
    append_all(places, places.empty() ? "" : ", ", point.at.x, ",", point.at.y);
  }
  if (saddles.empty()) throw DataError(system.info.name + ": no saddle was found; name one by --fixed-point");
  if (saddles.size() > 1) {
    throw UsageError(system.info.name + " has several saddles; choose one by --fixed-point: " + places);
  }
  return saddles.front();
}

Branch branch_of(const Request& request, const System& system, const LocalManifold& local) {
  if (request.branch == "-" || request.branch == "minus") return Branch::minus;
  if (!request.branch.empty() || !of_tangle(request, system)) return Branch::plus;
  return branch_towards(local, system.connection->direction(side_of(request)));
}

void run(const Request& request) {
  const Stopwatch watch;
  std::vector<Output> outputs;
  if (!request.output.empty()) outputs.push_back({"-o", request.output});
  if (!request.json.empty()) outputs.push_back({"--json", request.json});
  check_outputs(outputs, files_of_system(request.system));
  GrowReport report;
  report.system = make_system(request.system, parameter_values(request.parameters), request.integration);
  if (!report.system.map) throw UsageError(request.system + " has no planar map");
  report.integration = request.integration;
  report.options = request.growth;
  {
    Progress progress;
    progress.phase("local manifold", 0, 0.1);
    const Stopwatch local_watch;
    LocalManifoldOptions local;
    local.period = request.period;
    report.local = local_manifold(*report.system.map, saddle_of(request, report.system), side_of(request), local);
    report.branch = branch_of(request, report.system, report.local);
    report.timing.local = local_watch.seconds();
    progress.phase("growing", 0.1, 0.9);
    const Stopwatch growth_watch;
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
    const Stopwatch write_watch;
    if (!request.output.empty()) write_points(request.output, report.manifold.points);
    report.timing.write = write_watch.seconds();
    if (!request.json.empty()) write_grow_json(request.json, report, [&] { return watch.seconds(); });
  }
  if (!takes_standard_output(outputs)) print(grow_summary(report));
  if (report.manifold.stop == GrowthStop::cancelled) throw Cancelled();
}

}  // namespace

void run_grow(const std::vector<std::string>& arguments) {
  Request request;
  OptionParser parser(
      "Grows a branch of the stable or unstable manifold of a saddle of a map, or of a flow's Poincare map.",
      "lober grow");
  add_options(parser, request);
  if (!parser.parse(arguments)) return;
  check(request);
  with_thread_limit(request.threads, [&] { run(request); });
}

}  // namespace lober::cli

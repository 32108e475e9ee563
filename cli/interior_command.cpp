// `lober interior C1 C2`: reads the curves, calls the engine, and hands what it found to those who show it.

#include "cli/interior_command.hpp"

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <optional>

#include "cli/command_line.hpp"
#include "cli/interior_report.hpp"
#include "cli/progress.hpp"
#include "engine/stopwatch.hpp"

namespace lober::cli {
namespace {

struct Request {
  std::array<std::string, 2> curves;
  std::string json;
  InteriorOptions options;
  int threads = 0;
  bool verbose = false;
};

// Nothing when the arguments asked for help, which is printed.
std::optional<Request> parse(const std::vector<std::string>& arguments) {
  Request request;
  bool no_densify = false, no_check = false;
  std::pair<int, int> densify;
  CLI::App app("Areas of two simple closed curves by the interior function: Q1, Q2, Q3.", "lober interior");
  app.add_option("C1", request.curves[0], "the first curve: FILE, or FILE#ZONE for one zone (from 0, or by title)")
      ->required();
  app.add_option("C2", request.curves[1], "the second curve")->required();
  CLI::Option* insert = app.add_option("--densify", densify,
                                       "do not split segments where the curves meet; insert N points where the ends of "
                                       "a segment lie on different sides, P times over (the paper's -DENS P N)")
                            ->type_name("P N")
                            ->check(CLI::Range(0, 1'000'000));
  app.add_flag("--no-densify", no_densify, "do not split segments, nor insert points (the paper's -DENS 0)")
      ->excludes(insert);
  app.add_option("--json", request.json, "write everything as one JSON object (- for standard output)")
      ->type_name("FILE");
  add_threads_option(app, request.threads);
  app.add_flag("--no-check", no_check, "do not check that the curves are simple, when you know that they are");
  app.add_flag("-v,--verbose", request.verbose, "tell on standard error how long each phase took");
  if (!parse_arguments(app, arguments)) return std::nullopt;
  request.options.check_simple = !no_check;
  if (no_densify || insert->count() > 0) request.options.method = InteriorMethod::ends;
  std::tie(request.options.passes, request.options.points) = densify;
  return request;
}

InteriorReport compute(const Request& request, Progress& progress) {
  InteriorReport report;
  report.options = request.options;
  progress.phase("reading", 0, 0.25);
  const Stopwatch read_watch;
  for (std::size_t k = 0; k < 2; ++k) {
    report.inputs[k] = read_curve(request.curves[k], true);
    progress.advance(0.5 * static_cast<double>(k + 1));
  }
  report.read_seconds = read_watch.seconds();

  progress.of(static_cast<double>(report.inputs[0].curve.points.size() + report.inputs[1].curve.points.size()),
              "points");
  progress.phase("interior", 0.25, 0.95);
  const Stopwatch index_watch;
  const IndexedCurve c1(report.inputs[0].curve), c2(report.inputs[1].curve);
  report.index_seconds = index_watch.seconds();
  InteriorOptions options = request.options;
  options.progress = [&](double fraction) { return progress.advance(fraction); };
  try {
    MeasuredAreas measured = measure_areas(c1, c2, options);
    report.result = std::move(measured.result);
    report.splitting = measured.splitting;
  } catch (const NotSimpleError& error) {
    throw DataError(request.curves[static_cast<std::size_t>(error.curve - 1)] + ": " + error.what());
  }
  return report;
}

void run(const Request& request) {
  const Stopwatch watch;
  std::vector<Output> outputs;
  if (!request.json.empty()) outputs.push_back({"--json", request.json});
  check_outputs(outputs, request.curves);
  InteriorReport report;
  {
    Progress progress;
    report = compute(request, progress);
    progress.phase("writing", 0.95, 1);
    if (!request.json.empty()) write_interior_json(request.json, report, [&] { return watch.seconds(); });
  }
  if (request.json != "-") print(interior_table(report));
  const InteriorTiming& timing = report.result.timing;
  spdlog::info(
      "seconds: read {:.4f}, index {:.4f}, check {:.4f}, crossings {:.4f}, order {:.4f}, labels {:.4f}, sums {:.4f}, "
      "total {:.4f}",
      report.read_seconds, report.index_seconds, timing.check, timing.crossings, timing.order, timing.labels,
      timing.sums, watch.seconds());
}

}  // namespace

void run_interior(const std::vector<std::string>& arguments) {
  const std::optional<Request> request = parse(arguments);
  if (!request) return;
  if (request->verbose) spdlog::set_level(spdlog::level::info);
  with_thread_limit(request->threads, [&] { run(*request); });
}

}  // namespace lober::cli

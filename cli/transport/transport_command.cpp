// `lober transport SYSTEM`: makes the system, calls the engine, and hands what it found to those who show it.

#include "cli/transport/transport_command.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "cli/program/command_line.hpp"
#include "cli/program/log.hpp"
#include "cli/program/progress.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/svg.hpp"
#include "cli/transport/curves_transport_command.hpp"
#include "cli/transport/sweep_report.hpp"
#include "cli/transport/transport_report.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/threads.hpp"

namespace lober::cli {
namespace {

struct TransportRequest {
  SystemRequest system;
  TransportOptions options;
  std::string sweep, json, svg, picture;
  std::vector<double> window;  // of the picture
  bool find_zero = false, all_regions = false, melnikov = false;
  int threads = 0;
};

std::vector<Output> outputs_of(const TransportRequest& request) {
  std::vector<Output> outputs;
  for (const auto& [option, path] :
       {std::pair{"--json", request.json}, {"--svg", request.svg}, {"--picture", request.picture}}) {
    if (!path.empty()) outputs.push_back({option, path});
  }
  check_outputs(outputs, files_of_system(request.system.name));
  return outputs;
}

// The other boundaries of the system, when they are asked for or the first region is not bounded without them. Other
// saddles than the system's have none.
std::vector<Connection> further_of(const TransportRequest& request, const System& system) {
  const SystemRequest& given = request.system;
  const bool own = given.from.empty() && given.to.empty() && given.u_direction.empty() && given.s_direction.empty();
  if (!own || !(request.all_regions || system.further_needed)) return {};
  return system.further;
}

// Sums of the lobes of the turnstile, by action where the map has one.
MelnikovReport melnikov_report(const TransportReport& report, Melnikov function) {
  MelnikovReport result;
  const Parameter& perturbation = perturbation_of(report.system);
  result.parameter = perturbation.name;
  result.eps = perturbation.value;
  result.estimate = function.lobe_areas(result.eps);
  result.function = std::move(function);
  const ManifoldTangle& manifolds = report.manifolds();
  std::vector<double> areas = manifolds.areas_by_action;
  if (areas.empty()) {
    const Images& images = manifolds.tangle.images;
    for (std::size_t k = images.turnstile_begin; k < images.turnstile_end; ++k) {
      areas.push_back(manifolds.tangle.lobes[k].area);
    }
  }
  for (const double area : areas) (area > 0 ? result.exact.left : result.exact.right) += std::fabs(area);
  return result;
}

// Rows as they come: on a terminal each is shown at once, above the line of progress, and an interrupt keeps them. The
// table comes in the end, since a disagreement has to be its first line.
class Rows {
 public:
  Rows(const TransportRequest& request, Progress& progress) : request_(request), progress_(progress) {}

  void add(const TransportStep& step, const Agreement& agreement) {
    steps_.push_back(step);
    agreement_ = agreement;
    if (isatty(STDERR_FILENO) == 0) return;
    progress_.above([&] { std::fputs(transport_row_text(step).c_str(), stderr); });
  }
  void print_interrupted(bool to_standard_output) const {
    if (steps_.empty() || !to_standard_output) return;
    print(interrupted_transport_table(steps_, agreement_, request_.options.iterates));
  }

 private:
  const TransportRequest& request_;
  Progress& progress_;
  std::vector<TransportStep> steps_;
  Agreement agreement_;
};

void run_one(const TransportRequest& request) {
  const detail::Stopwatch watch;
  const std::vector<Output> outputs = outputs_of(request);
  TransportReport report;
  report.system = system_of(request.system, parameter_values(request.system.parameters));
  report.integration = request.system.integration;
  report.connection = connection_of(request.system, report.system);
  report.options = request.options;
  {
    Progress progress;
    progress.phase("transport", 0, 0.9);
    TransportOptions options = request.options;
    options.lattice = report.system.lattice;
    options.further = further_of(request, report.system);
    if (!request.system.bip.empty()) options.bip_near = report.connection.bip;
    options.progress = [&](const std::string& line) { return progress.step(line); };
    Rows rows(request, progress);
    options.on_step = [&](const TransportStep& step, const Agreement& agreement) { rows.add(step, agreement); };
    // First, so that a system without one is refused before the work.
    std::optional<Melnikov> function;
    if (request.melnikov) {
      function =
          melnikov_of(request.system, parameter_values(request.system.parameters), report.system, report.connection);
    }
    const detail::Stopwatch transport_watch;
    try {
      report.result = transport(*report.system.map, report.connection, options);
    } catch (const Cancelled&) {
      rows.print_interrupted(!takes_standard_output(outputs));
      throw;
    }
    report.timing.transport = transport_watch.seconds();
    if (function) report.melnikov = melnikov_report(report, std::move(*function));
    for (const std::string& remark : report.result.remarks) log_info(remark);
    progress.phase("writing", 0.9, 1);
    const detail::Stopwatch write_watch;
    if (!request.svg.empty()) write_transport_curve(request.svg, report);
    if (!request.picture.empty()) write_transport_picture(request.picture, report, window_of(request.window));
    report.timing.write = write_watch.seconds();
    if (!request.json.empty()) write_transport_json(request.json, report, [&] { return watch.seconds(); });
  }
  if (!takes_standard_output(outputs)) print(transport_table(report));
  require_agreement(report.result.agreement);
}

// Of every value that has lobes; one that has no connecting orbit there has no estimate.
template <typename Member>
void add_melnikov(const TransportRequest& request, SweepReport& report, const Member& member, Progress& progress) {
  progress.phase("Melnikov's function", 0.9, 0.99);
  const ParameterValues fixed = parameter_values(request.system.parameters);
  const bool of_eps = report.range.name == perturbation_of(report.system).name;
  std::optional<Melnikov> function;
  report.first_order.emplace();
  for (const SweepRow& row : report.result.rows) {
    double area = std::numeric_limits<double>::quiet_NaN();
    if (row.failure.empty()) {
      const System system = member(row.value);
      const double eps = perturbation_of(system).value;
      try {
        if (!function || !of_eps) {
          ParameterValues values = fixed;
          values.emplace_back(report.range.name, row.value);
          function = melnikov_of(request.system, values, system, connection_of(request.system, system));
        }
        const Melnikov::Sides sides = function->lobe_areas(eps);
        area = 0.5 * (sides.left + sides.right);
      } catch (const DataError& error) {
        log_info(report.range.name + " = " + rounded(row.value) + ": " + error.what());
      }
    }
    report.first_order->push_back(area);
    const double done = static_cast<double>(report.first_order->size());
    if (!progress.advance(done / static_cast<double>(report.result.rows.size()))) throw Cancelled();
  }
}

void run_sweep(const TransportRequest& request) {
  const detail::Stopwatch watch;
  const std::vector<Output> outputs = outputs_of(request);
  SweepReport report;
  report.range = sweep_range(request.sweep);
  if (!report.range.reaches) {
    log_warning("--sweep: the step of " + request.sweep +
                " is longer than its range, so there is one value; give NAME=FIRST:LAST:STEP with a shorter step");
  }
  report.tolerance = request.options.tolerance;
  report.find_zeros = request.find_zero;
  report.integration = request.system.integration;
  const ParameterValues fixed = parameter_values(request.system.parameters);
  const auto member = [&](double value) {
    ParameterValues values = fixed;
    values.emplace_back(report.range.name, value);
    return system_of(request.system, values);
  };
  report.system = member(report.range.values.front());  // also so that wrong names are reported at once
  if (report.system.no_connection.empty()) (void)connection_of(request.system, report.system);
  if (request.melnikov) (void)perturbation_of(report.system);
  SweepOptions options;
  options.tangle.tolerance = request.options.tolerance;
  options.tangle.max_points = request.options.max_points;
  options.find_zeros = request.find_zero;
  {
    Progress progress;
    progress.phase("sweep", 0, request.melnikov ? 0.9 : 0.95);
    options.progress = [&](std::size_t done) {
      return progress.advance(static_cast<double>(done) / static_cast<double>(report.range.values.size()));
    };
    report.result = sweep(
        [&](double value) -> FamilyMember {
          const System system = member(value);
          return {system.map, connection_of(request.system, system), system.lattice};
        },
        report.range.values, options);
    if (request.melnikov) add_melnikov(request, report, member, progress);
    if (!request.svg.empty()) write_sweep_curve(request.svg, report);
    if (!request.json.empty()) write_sweep_json(request.json, report, [&] { return watch.seconds(); });
  }
  if (!takes_standard_output(outputs)) print(sweep_table(report));
  if (const std::size_t failures = report.result.failures(); failures > 0) {
    const auto first = std::find_if(report.result.rows.begin(), report.result.rows.end(),
                                    [](const SweepRow& row) { return !row.failure.empty(); });
    throw DataError(std::to_string(failures) + " of " + std::to_string(report.result.rows.size()) +
                    " values failed, the first at " + report.range.name + " = " + rounded(first->value) + ": " +
                    first->failure);
  }
}

}  // namespace

void run_transport(const std::vector<std::string>& arguments) {
  if (names_manifolds(arguments)) return run_curves_transport(arguments);
  TransportRequest request;
  OptionParser parser(
      "Computes the transport across the boundary that a stable and an unstable manifold of a map make: grows them, "
      "finds the turnstile, and computes the fluxes a(n) and T(n) by lobes and by boundaries. With --manifolds FILE "
      "the manifolds are given as curves (lober transport --manifolds FILE --help).",
      "lober transport");
  add_system_options(parser, request.system, true);
  const Option iterates = parser
                              .add("--iterates", request.options.iterates,
                                   "The number of iterates n up to which the table goes (default: 7).")
                              .range(1, max_iterates)
                              .value("N");
  add_tolerance_option(parser, request.options.tolerance, manifold_tolerance_help);
  add_max_points_option(parser, request.options.max_points, manifold_points_help);
  parser
      .add("--budget", request.options.budget,
           "The wall-clock time that growing the manifolds of one boundary may take, in seconds (default: a limit on "
           "the work instead, which gives the same table on every machine).")
      .positive()
      .value("SECONDS");
  parser.add_flag("--all-regions", request.all_regions,
                  "Compute the transport between the regions of all boundaries that the system names (ovp: the lower "
                  "vortex too), with the matrices T_ij(n).");
  parser
      .add("--particles", request.options.particles,
           "The number of particles in each bounded region by which T(n) is counted, as a check (default: 0).")
      .range(std::uint64_t{0}, std::uint64_t{1'000'000'000})
      .value("N");
  parser.add("--seed", request.options.seed, "The seed of the random numbers of the particles (default: 1).")
      .value("S");
  const Option sweep_option =
      parser
          .add("--sweep", request.sweep,
               "Compute the areas of the turnstile for the values FIRST to LAST of a parameter, in steps of STEP, "
               "instead of the fluxes.")
          .value("NAME=FIRST:LAST:STEP")
          .excludes(iterates);
  parser
      .add_flag("--find-zero", request.find_zero,
                "Refine the values of the parameter at which the difference in action of the two pips of the turnstile "
                "changes its sign.")
      .needs(sweep_option);
  parser.add_flag("--melnikov", request.melnikov,
                  "Compute Melnikov's function too, and the areas of lobes to first order in the parameter that is "
                  "the size of the system's perturbation (eps) beside the exact ones; with --sweep for every value.");
  add_json_option(parser, request.json);
  parser
      .add("--svg", request.svg,
           "Draw a(n) and T(n), or with --sweep the areas over the parameter, as an SVG picture in FILE (default: no "
           "file).")
      .value("FILE");
  const Option picture =
      parser
          .add("--picture", request.picture,
               "Draw the manifolds, the boundary, the turnstile and its images as an SVG picture in FILE (default: no "
               "file).")
          .value("FILE")
          .excludes(sweep_option);
  add_window_option(parser, request.window, picture);
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return;
  run_with_threads(request.threads, [&] { request.sweep.empty() ? run_one(request) : run_sweep(request); });
}

}  // namespace lober::cli

// Time against error of methods for ordinary differential equations: the one of lober, others in the same vectors with
// the same driver, and other libraries one point at a time. Prints tables; --plot FILE draws the first of them.
#include <array>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/accuracy/accuracy.hpp"
#include "bench/harness/measure.hpp"
#include "bench/harness/program.hpp"
#include "bench/integrators/contenders.hpp"
#include "bench/integrators/measurement.hpp"
#include "bench/integrators/problems.hpp"
#include "bench/integrators/reference.hpp"
#include "bench/integrators/scipy.hpp"
#include "engine/base/stopwatch.hpp"

namespace lober::bench {
namespace {

constexpr std::size_t points_in_lanes = 4096, plain_points = 512, precise_points = 256, scipy_points = 128;

struct Options {
  std::string plot;
  int repeat = 5;
};

template <typename Field>
std::vector<PreciseState<Field>> precise_ends(const Problem<Field>& problem) {
  constexpr int steps = 1024;
  std::vector<PreciseState<Field>> ends;
  std::vector<std::array<long double, static_cast<std::size_t>(Field::dimension)>> coarse;
  for (std::size_t k = 0; k < precise_points; ++k) {
    ends.push_back(precise_end(problem.field, problem.points[k], problem.span, 2 * steps));
    const PreciseState<Field> other = precise_end(problem.field, problem.points[k], problem.span, steps);
    coarse.emplace_back();
    for (std::size_t i = 0; i < other.size(); ++i) coarse.back()[i] = other[i].v;
  }
  std::cout << "Reference: " << steps << " and " << 2 * steps << " steps differ by " << errors_of(coarse, ends).largest
            << " at most.\n\n";
  return ends;
}

template <typename Field>
WorkPrecision scipy_curve(const Problem<Field>& problem, const std::vector<PreciseState<Field>>& precise) {
  constexpr std::array<double, 4> tolerances{1e-8, 1e-10, 1e-12, 1e-13};
  std::vector<double> coordinates;
  for (std::size_t k = 0; k < scipy_points; ++k) {
    coordinates.insert(coordinates.end(), problem.points[k].begin(), problem.points[k].end());
  }
  WorkPrecision curve{"SciPy DOP853", {}};
  for (const ScipyRun& run : run_scipy(problem.name, problem.span, coordinates, Field::dimension, tolerances)) {
    std::vector<StateOf<Field>> ends(scipy_points);
    for (std::size_t k = 0; k < run.coordinates.size(); ++k)
      ends[k / Field::dimension][k % Field::dimension] = run.coordinates[k];
    const ErrorSizes errors = errors_of(ends, precise);
    curve.points.push_back({run.tolerance, run.nanoseconds, errors.largest, errors.rms});
  }
  return curve;
}

/// All integrators take turns, so that what else the machine does falls on all of them.
template <typename Field>
std::vector<WorkPrecision> compare(const Problem<Field>& problem, int repeat) {
  const std::vector<PreciseState<Field>> precise = precise_ends(problem);
  const std::vector<Contender<Field>> contenders = contenders_of(problem);
  std::vector<WorkPrecision> curves;
  std::vector<std::vector<std::vector<double>>> times;
  for (const Contender<Field>& contender : contenders) {
    curves.push_back({contender.name, {}});
    times.emplace_back(contender.tolerances.size());
  }
  for (int round = 0; round <= repeat; ++round) {  // the first one warms up, and gives the errors
    for (std::size_t c = 0; c < contenders.size(); ++c) {
      const Contender<Field>& contender = contenders[c];
      const std::size_t count = contender.in_lanes ? points_in_lanes : plain_points;
      for (std::size_t k = 0; k < contender.tolerances.size(); ++k) {
        std::vector<StateOf<Field>> ends(problem.points.begin(),
                                         problem.points.begin() + static_cast<std::ptrdiff_t>(count));
        const Stopwatch watch;
        contender.integrate(contender.tolerances[k], ends);
        const double seconds = watch.seconds();
        if (round == 0) {
          const ErrorSizes errors = errors_of(ends, precise);
          curves[c].points.push_back({contender.tolerances[k], 0, errors.largest, errors.rms});
        } else {
          times[c][k].push_back(1e9 * seconds / static_cast<double>(count));
        }
      }
    }
  }
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (std::size_t k = 0; k < times[c].size(); ++k) curves[c].points[k].nanoseconds = median_of(times[c][k]);
  }
  curves.push_back(scipy_curve(problem, precise));
  return curves;
}

AccuracyPanel panel_of(const std::string& title, const std::vector<WorkPrecision>& curves) {
  // A colour for each kind of method, a shape for each of a kind.
  using enum cli::DotShape;
  constexpr std::array<CurveStyle, 12> styles{{{palette::boundary, circle},
                                               {palette::boundary, square},
                                               {palette::ink, circle},
                                               {palette::stable, circle},
                                               {palette::right_of_unstable, square},
                                               {palette::leaving, circle},
                                               {palette::leaving, square},
                                               {palette::leaving, triangle},
                                               {palette::entering, circle},
                                               {palette::entering, square},
                                               {palette::entering, triangle},
                                               {palette::entering, cross}}};
  AccuracyPanel panel{title, {}};
  // SciPy would take half of the picture for itself.
  for (std::size_t c = 0; c < styles.size(); ++c) {
    AccuracyCurve curve{curves[c].method, styles[c], {}};
    for (const Measurement& point : curves[c].points) curve.points.push_back({1, 1e-9 * point.nanoseconds, point.rms});
    panel.curves.push_back(curve);
  }
  return panel;
}

template <typename Field>
AccuracyPanel report(const Problem<Field>& problem, int repeat) {
  std::cout << "### " << problem.description << "\n\n";
  const std::vector<WorkPrecision> curves = compare(problem, repeat);
  print_measurements(std::cout, problem.name, curves);
  print_summary(std::cout, problem.name, curves);
  std::cout.flush();
  return panel_of(problem.description, curves);
}

Options read_options(int count, char** arguments) {
  Options options;
  for (int k = 1; k < count; k += 2) {
    const std::string name = arguments[k];
    if (k + 1 < count && name == "--plot") {
      options.plot = arguments[k + 1];
    } else if (k + 1 < count && name == "--repeat") {
      options.repeat = std::stoi(arguments[k + 1]);
    } else {
      throw std::invalid_argument("usage: bench_integrators [--repeat N] [--plot FILE.svg]");
    }
  }
  if (options.repeat < 1) throw std::invalid_argument("--repeat: at least 1");
  return options;
}

void run(const Options& options) {
  std::cout << "Vectors: " << instruction_set_names()[static_cast<std::size_t>(instruction_set())]
            << ", one thread.\n\n";
  const std::vector<AccuracyPanel> panels{report(vortex_pair_problem(points_in_lanes), options.repeat),
                                          report(duffing_problem(points_in_lanes), options.repeat),
                                          report(capsize_problem(points_in_lanes), options.repeat),
                                          report(three_body_problem(points_in_lanes), options.repeat)};
  if (options.plot.empty()) return;
  std::ofstream file(options.plot);
  write_plot(file, panels, {"run time a point on one thread", "rms error", "each line: tolerances from 1e-8 to 1e-14"});
  if (!file.flush()) throw std::runtime_error("cannot write " + options.plot);
}

}  // namespace
}  // namespace lober::bench

int main(int count, char** arguments) {
  return lober::bench::exit_status("bench_integrators", [&] {
    lober::bench::run(lober::bench::read_options(count, arguments));
    return 0;
  });
}

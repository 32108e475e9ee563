// Run time against error of every method, on scenes with known areas: the figure of Naik, Lekien & Ross (2017) on the
// densifier, done for all of them. Prints a table; --svg FILE draws it.
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "bench/accuracy/accuracy.hpp"
#include "bench/harness/measure.hpp"
#include "bench/harness/program.hpp"
#include "bench/harness/table.hpp"
#include "engine/base/parallel/parallel.hpp"

namespace lober::bench {
using namespace lober::detail;
namespace {

constexpr std::array<std::size_t, 10> sizes{125, 250, 500, 1000, 2000, 4000, 8000, 16000, 32000, 64000};

// Median over at least three runs and a fiftieth of a second.
AccuracyPoint measured(const Scene& scene, const AccuracyMethod& method) {
  const double exact = (*scene.smooth_areas)[0];
  const double area = method.area(scene);
  std::vector<double> seconds;
  for (double total = 0; seconds.size() < 3 || (total < 0.02 && seconds.size() < 200); total += seconds.back()) {
    const Stopwatch watch;
    (void)method.area(scene);
    seconds.push_back(watch.seconds());
  }
  return {scene.first.size(), median_of(seconds), std::fabs(area / exact - 1)};
}

// The slope of log error against log N over the last steps whose errors are above rounding.
std::string observed_order(const std::vector<AccuracyPoint>& points) {
  std::size_t last = points.size();
  while (last > 1 && points[last - 1].error < 3e-15) --last;
  if (last < 4) return "-";
  const AccuracyPoint &from = points[last - 4], &to = points[last - 1];
  return digits3(std::log(from.error / to.error) /
                 std::log(static_cast<double>(to.points) / static_cast<double>(from.points)));
}

AccuracyPanel panel_of(const AccuracyScene& kind) {
  AccuracyPanel panel{std::string(kind.name) + ": " + std::string(kind.description), {}};
  for (const AccuracyMethod& method : accuracy_methods()) {
    panel.curves.push_back({std::string(method.name), method.style, {}});
  }
  for (const std::size_t size : sizes) {
    const Scene scene = kind.make(size);
    for (std::size_t k = 0; k < panel.curves.size(); ++k) {
      panel.curves[k].points.push_back(measured(scene, accuracy_methods()[k]));
    }
  }
  return panel;
}

void print(const AccuracyPanel& panel) {
  std::cout << "### " << panel.title << "\n\n";
  Table table({"method", "error 1000", "us", "error 8000", "us", "error 64000", "us", "order"});
  for (const AccuracyCurve& curve : panel.curves) {
    std::vector<std::string> row{curve.method};
    for (const std::size_t shown : {1000U, 8000U, 64000U}) {
      for (const AccuracyPoint& point : curve.points) {
        if (point.points != shown) continue;
        row.push_back(one_digit(point.error));
        row.push_back(digits3(1e6 * point.seconds));
      }
    }
    row.push_back(observed_order(curve.points));
    table.add(row);
  }
  std::cout << table << std::endl;
}

int run(int count, char** arguments) {
  std::string svg;
  for (int k = 1; k < count; ++k) {
    if (std::string(arguments[k]) == "--svg" && k + 1 < count) {
      svg = arguments[++k];
    } else {
      throw std::invalid_argument("usage: bench_accuracy [--svg FILE]");
    }
  }
  std::vector<AccuracyPanel> panels;
  with_threads(1, [&] {
    for (const AccuracyScene& kind : accuracy_scenes()) {
      panels.push_back(panel_of(kind));
      print(panels.back());
    }
  });
  if (!svg.empty()) {
    std::ofstream file(svg);
    write_plot(file, panels,
               {"run time on one thread", "relative error of the area", "each line: N = 125 to 64000 points a curve"});
    if (!file.flush()) throw std::runtime_error("cannot write " + svg);
  }
  return 0;
}

}  // namespace
}  // namespace lober::bench

int main(int count, char** arguments) {
  return lober::bench::exit_status("bench_accuracy", [&] { return lober::bench::run(count, arguments); });
}

#include <cmath>
#include <iostream>

#include "bench/harness/measure.hpp"
#include "bench/harness/sections.hpp"
#include "bench/harness/table.hpp"

namespace lober::bench {
namespace {

// The slope of the line of least squares.
double slope(const std::vector<double>& x, const std::vector<double>& y) {
  double middle_x = 0, middle_y = 0, above = 0, below = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    middle_x += x[k] / static_cast<double>(x.size());
    middle_y += y[k] / static_cast<double>(x.size());
  }
  for (std::size_t k = 0; k < x.size(); ++k) {
    above += (x[k] - middle_x) * (y[k] - middle_y);
    below += (x[k] - middle_x) * (x[k] - middle_x);
  }
  return above / below;
}

}  // namespace

void growth_section(const Options& options, std::ostream& out) {
  constexpr int repeat = 3;
  out << "### Growth with the number of points\n\nTime in ms on " << options.threads[0]
      << " thread(s), with the proof that both curves are simple; the exponents are slopes of straight lines fitted to "
         "the logarithms: of the time against points, of the floor likewise, and of the time against crossings, where "
         "these grow tenfold.\n\n";
  Table table({"scene", "1e4", "1e5", "1e6", "1e7", "exponent", "floor's", "crossings", "to", "against these"});
  for (const SceneKind* kind : options.scenes) {
    std::vector<std::string> row{std::string(kind->name)};
    std::vector<double> sizes, logs, floor_logs, crossings;
    for (std::size_t points = 10'000; points <= 10'000'000; points *= 10) {
      std::cerr << kind->name << ' ' << points << " ..." << std::endl;
      const Scene scene = kind->make(points);
      const OverlayTimes times =
          time_overlay(scene, options.threads.front(), {.check_simple = true, .index = options.index}, repeat);
      sizes.push_back(std::log10(static_cast<double>(points)));
      logs.push_back(std::log10(times.seconds));
      floor_logs.push_back(std::log10(floor_seconds(scene)));
      crossings.push_back(static_cast<double>(times.crossings));
      row.push_back(milliseconds(times.seconds));
    }
    row.push_back(digits3(slope(sizes, logs)));
    row.push_back(digits3(slope(sizes, floor_logs)));
    row.push_back(std::to_string(static_cast<std::size_t>(crossings.front())));
    row.push_back(std::to_string(static_cast<std::size_t>(crossings.back())));
    const bool grow = crossings.front() > 0 && crossings.back() >= 10 * crossings.front();
    for (double& count : crossings) count = std::log10(count);
    row.push_back(grow ? digits3(slope(crossings, logs)) : "-");
    table.add(row);
  }
  out << table << std::flush;
}

}  // namespace lober::bench

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>

#include "bench/harness/child.hpp"
#include "bench/harness/errors.hpp"
#include "bench/harness/measure.hpp"
#include "bench/harness/sections.hpp"
#include "bench/harness/table.hpp"

namespace lober::bench {
namespace {

struct Measured {
  double floor = 0;
  OverlayTimes all, checked, totals;
  std::vector<OverlayTimes> threaded;  // for options.threads[1...]
  double memory = 0;                   // bytes per point
  std::string smooth_error = "-";
};

Measured measure(const SceneKind& kind, const Options& options) {
  const Scene scene = kind.make(options.points);
  const int base = options.threads.front();
  Measured measured;
  measured.floor = floor_seconds(scene);
  measured.all = time_overlay(scene, base, {.index = options.index}, options.repeat);
  measured.checked = time_overlay(scene, base, {.check_simple = true, .index = options.index}, options.repeat);
  measured.totals = time_overlay(scene, base, {.pieces = false, .index = options.index}, options.repeat);
  for (std::size_t k = 1; k < options.threads.size(); ++k) {
    measured.threaded.push_back(time_overlay(scene, options.threads[k], {.index = options.index}, options.repeat));
  }
  measured.memory = memory_per_point(kind, options.points);
  if (scene.smooth_areas) measured.smooth_error = one_digit(area_error(measured.all.areas, *scene.smooth_areas, scene));
  return measured;
}

std::size_t sum(const std::array<std::size_t, 4>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

std::string contacts(const OverlayTimes& times) {
  std::string text = std::to_string(times.crossings);
  if (times.shared_arcs != 0) text += ", " + std::to_string(times.shared_arcs) + " arcs";
  if (times.touches != 0) text += ", " + std::to_string(times.touches) + " touches";
  return text;
}

}  // namespace

void own_section(const Options& options, std::ostream& out) {
  out << "### " << options.points << " + " << options.points << " points\n\n"
      << "Index, crossings, order along both curves, all areas and pieces, of curves in memory, on "
      << options.threads[0]
      << " thread(s); medians. The floor is a plain area sum over both curves in the same process.\n"
      << "`checked`: curves are also proved to be simple. `totals`: areas without pieces. `memory`: peak "
         "beyond the "
         "curves, bytes per point. Times in ms.\n\n";
  std::vector<std::string> header{"scene",   "crossings", "pieces",  "floor", "time",
                                  "x floor", "checked",   "x floor", "totals"};
  for (std::size_t k = 1; k < options.threads.size(); ++k) {
    header.push_back(std::to_string(options.threads[k]) + " threads");
    header.push_back("speed-up");
  }
  header.push_back("memory");
  Table times(header);
  Table phases({"scene", "kind", "index", "check", "crossings", "order", "areas", "total", "off smooth areas"});
  for (const SceneKind* kind : options.scenes) {
    std::cerr << kind->name << " ..." << std::endl;
    const Measured measured = measure(*kind, options);
    const double seconds = measured.all.seconds;
    std::vector<std::string> row{std::string(kind->name),
                                 contacts(measured.all),
                                 std::to_string(sum(measured.all.pieces)),
                                 milliseconds(measured.floor),
                                 milliseconds(seconds),
                                 digits3(seconds / measured.floor),
                                 milliseconds(measured.checked.seconds),
                                 digits3(measured.checked.seconds / measured.floor),
                                 milliseconds(measured.totals.seconds)};
    for (const OverlayTimes& threaded : measured.threaded) {
      row.push_back(milliseconds(threaded.seconds));
      row.push_back(digits3(seconds / threaded.seconds));
    }
    row.push_back(digits3(measured.memory));
    times.add(row);
    const OverlayTiming& phase = measured.checked.phases;
    phases.add({std::string(kind->name), std::string(name(measured.checked.index)), milliseconds(phase.index),
                milliseconds(phase.check), milliseconds(phase.crossings), milliseconds(phase.order),
                milliseconds(phase.areas), milliseconds(phase.total), measured.smooth_error});
  }
  out << times
      << "Phases of the `checked` job in ms with the kind of index that was used, and how far the areas are "
         "from those of the smooth curves (which the "
      << "polygons only approximate).\n\n"
      << phases << std::flush;
}

void growth_section(const Options& options, std::ostream& out) {
  out << "### Growth with the number of points\n\nTime in ms on " << options.threads[0]
      << " thread(s); the exponent is the slope of a straight line fitted to the logarithms.\n\n";
  Table table({"scene", "1e4", "1e5", "1e6", "1e7", "exponent", "floor's"});
  for (const char* name : {"lens", "wavy16"}) {
    std::vector<std::string> row{name};
    std::vector<double> logs, floor_logs;
    for (std::size_t points = 10'000; points <= 10'000'000; points *= 10) {
      std::cerr << name << ' ' << points << " ..." << std::endl;
      const Scene scene = find_scene(name)->make(points);
      const double seconds =
          time_overlay(scene, options.threads.front(), {.index = options.index}, options.repeat).seconds;
      logs.push_back(std::log10(seconds));
      floor_logs.push_back(std::log10(floor_seconds(scene)));
      row.push_back(milliseconds(seconds));
    }
    // Least squares through abscissae 4, 5, 6, 7.
    const auto slope = [](const std::vector<double>& y) {
      return (-1.5 * y[0] - 0.5 * y[1] + 0.5 * y[2] + 1.5 * y[3]) / 5;
    };
    row.push_back(digits3(slope(logs)));
    row.push_back(digits3(slope(floor_logs)));
    table.add(row);
  }
  out << table << std::flush;
}

}  // namespace lober::bench

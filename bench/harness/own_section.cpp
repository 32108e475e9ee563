#include <algorithm>
#include <iostream>
#include <numeric>

#include "bench/harness/child.hpp"
#include "bench/harness/errors.hpp"
#include "bench/harness/measure.hpp"
#include "bench/harness/sections.hpp"
#include "bench/harness/table.hpp"
#include "kernels/cpu.hpp"

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

// ", avx2 only", where LOBER_ISA keeps the engine from what the processor can.
std::string limit() {
  if (instruction_set() == processor_instruction_set()) return {};
  return ", " + std::string(instruction_set_names()[static_cast<std::size_t>(instruction_set())]) + " only";
}

}  // namespace

void own_section(const Options& options, std::ostream& out) {
  out << "### " << options.points << " + " << options.points << " points" << limit() << "\n\n"
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

}  // namespace lober::bench

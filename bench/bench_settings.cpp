// The settings of the densifier compared on pairs of curves, as in figure 8 of Naik, Lekien & Ross (2017): error,
// points inserted and run time. Prints a table; --svg FILE draws it.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/harness/measure.hpp"
#include "bench/harness/program.hpp"
#include "bench/harness/table.hpp"
#include "cli/picture/panels.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "lober/curve/files.hpp"
#include "lober/overlay/interior.hpp"

namespace lober::bench {
using namespace lober::detail;
namespace {

using cli::Figure;
using cli::Layer;

struct Setting {
  const char* name;
  int passes, points;  ///< none: segments are split where the curves meet
};
constexpr std::array<Setting, 11> settings{{{"-DENS 0", 0, 0},
                                            {"-DENS 1 10", 1, 10},
                                            {"-DENS 3 10", 3, 10},
                                            {"-DENS 5 100", 5, 100},
                                            {"default, split", -1, -1},
                                            {"-DENS 1 4095", 1, 4095},
                                            {"-DENS 2 63", 2, 63},
                                            {"-DENS 3 15", 3, 15},
                                            {"-DENS 4 7", 4, 7},
                                            {"-DENS 6 3", 6, 3},
                                            {"-DENS 12 1", 12, 1}}};
constexpr std::size_t split = 4;          // among them
constexpr double smallest_error = 1e-16;  // an error of 0 is drawn here
constexpr double column = 85;             // of a journal, in mm

struct Pair {
  const char* name;
  const char* colour;
  bool hollow;
};
constexpr std::array<Pair, 4> pairs{{{"vortex pair, lobes", palette::stable, false},
                                     {"three bodies, lobes", palette::unstable, false},
                                     {"vortex pair, boundaries", palette::stable, true},
                                     {"three bodies, boundaries", palette::unstable, true}}};

struct Row {
  double area = 0, seconds = 0;  ///< mean of both differences; median
  std::uint64_t inserted = 0;
};
using Rows = std::array<std::array<Row, settings.size()>, pairs.size()>;

Row measured(const ClosedCurve& c1, const ClosedCurve& c2, const Setting& setting) {
  InteriorOptions options;
  if (setting.passes >= 0) {
    options.method = InteriorMethod::ends;
    options.passes = setting.passes;
    options.points = setting.points;
  }
  std::vector<double> seconds;
  Row row;
  for (double total = 0; seconds.size() < 5 || (total < 0.1 && seconds.size() < 200); total += seconds.back()) {
    const Stopwatch watch;
    const InteriorAreas found = interior_areas(c1, c2, options);
    seconds.push_back(watch.seconds());
    row.area = 0.5 * (found.areas.c1_minus_c2 + found.areas.c2_minus_c1);
    row.inserted = found.statistics.points_inserted;
  }
  row.seconds = median_of(seconds);
  return row;
}

// One dot a setting and pair; settings from above, values along x.
template <typename Value>
Figure panel(const Rows& rows, const std::string& x, const std::string& unit, const Value& value) {
  Figure figure{.what = x};
  figure.plane = false;
  figure.x = {.name = x, .unit = unit, .exponents = true};
  figure.y = {.name = ""};
  for (std::size_t s = settings.size(); s-- > 0;) figure.y.categories.emplace_back(settings[s].name);
  Rectangle box;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    Layer dots = cli::dot_layer(pairs[p].name, pairs[p].name, {}, 1.5);
    dots.colour = pairs[p].colour;
    dots.hollow = pairs[p].hollow;
    for (std::size_t s = 0; s < settings.size(); ++s) {
      const double shown = value(rows[p], s);
      if (!(shown > 0)) continue;
      // Pairs beside each other, so that equal values are seen.
      const double row = static_cast<double>(settings.size() - 1 - s) + 0.17 * (1.5 - static_cast<double>(p));
      dots.points.push_back({std::log10(shown), row});
      box.add(dots.points.back());
    }
    figure.layers.push_back(std::move(dots));
  }
  figure.window = {std::floor(box.min_x - 0.2), -0.6, std::ceil(box.max_x + 0.2), settings.size() - 0.4};
  return figure;
}

void draw(std::ostream& stream, const Rows& rows) {
  using PairRows = std::array<Row, settings.size()>;
  std::vector<Figure> figures;
  figures.push_back(panel(rows, "difference of the area from splitting", "", [](const PairRows& of, std::size_t s) {
    return std::max(smallest_error, std::fabs(of[s].area - of[split].area));
  }));
  figures.push_back(panel(rows, "points inserted", "",
                          [](const PairRows& of, std::size_t s) { return static_cast<double>(of[s].inserted); }));
  figures.push_back(
      panel(rows, "run time on one thread", "s", [](const PairRows& of, std::size_t s) { return of[s].seconds; }));
  figures.back().notes.emplace_back("no difference: drawn at 10^{\u221216}; no points: not drawn");
  stream << cli::panels_svg("The settings of the densifier", figures, 1, {.width = column, .height = 52});
}

void print(const Rows& rows) {
  std::vector<std::string> header{"setting"};
  for (const Pair& pair : pairs) {
    header.emplace_back(pair.name);
    header.emplace_back("inserted");
    header.emplace_back("us");
  }
  Table table(header);
  for (std::size_t s = 0; s < settings.size(); ++s) {
    std::vector<std::string> cells{settings[s].name};
    for (const auto& of : rows) {
      cells.push_back(one_digit(std::fabs(of[s].area - of[split].area)));
      cells.push_back(std::to_string(of[s].inserted));
      cells.push_back(digits3(1e6 * of[s].seconds));
    }
    table.add(cells);
  }
  std::cout << table << std::endl;
}

int run(int count, char** arguments) {
  constexpr int curves = 2 * static_cast<int>(pairs.size());
  const bool draws = count == curves + 3 && std::string(arguments[curves + 1]) == "--svg";
  if (count != curves + 1 && !draws) {
    throw std::invalid_argument(
        "usage: bench_settings C1 C2 of four pairs, as FILE#ZONE: lobes of the vortex pair and of three bodies, "
        "boundaries of both [--svg FILE]");
  }
  Rows rows;
  with_threads(1, [&] {
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      const NamedCurve first = read_curve(arguments[2 * p + 1], true), second = read_curve(arguments[2 * p + 2], true);
      for (std::size_t s = 0; s < settings.size(); ++s) {
        rows[p][s] =
            measured(ClosedCurve::borrow(first.curve.points), ClosedCurve::borrow(second.curve.points), settings[s]);
      }
    }
  });
  print(rows);
  if (!draws) return 0;
  std::ofstream file(arguments[curves + 2]);
  draw(file, rows);
  if (!file.flush()) throw std::runtime_error("cannot write " + std::string(arguments[curves + 2]));
  return 0;
}

}  // namespace
}  // namespace lober::bench

int main(int count, char** arguments) {
  return lober::bench::exit_status("bench_settings", [&] { return lober::bench::run(count, arguments); });
}

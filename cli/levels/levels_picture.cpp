// The picture of level curves.

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/levels/levels_report.hpp"
#include "cli/report/cells.hpp"
#include "cli/report/svg.hpp"
#include "cli/report/text.hpp"
#include "lober/curve/files.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_level_points = 60'000;  // points of the curves of a level
constexpr std::array<const char*, 7> band_colours{"#5d86b0", "#7f9fc2", "#a0b8d3", "#bfcfe1",
                                                  "#d9e1eb", "#e9e6df", "#e3d9c9"};
constexpr const char* forbidden_colour = "#c9c6be";
constexpr const char* line_colour = "#44505e";
constexpr const char* saddle_colour = "#b3261e";

// The cells whose mean value lies in a band.
template <typename InBand>
std::string band_path(const View& view, const LevelGrid& grid, const InBand& in_band) {
  const auto has = [&](std::size_t column, std::size_t row) {
    const double mean = 0.25 * (grid.value(column, row) + grid.value(column + 1, row) + grid.value(column, row + 1) +
                                grid.value(column + 1, row + 1));
    return in_band(mean);
  };
  return cells_path(view, grid.columns(), grid.rows(), has,
                    [&](std::size_t column, std::size_t row) { return grid.node(column, row); });
}

void add_cells(std::string& svg, const char* colour, const std::string& path) {
  append_all(svg, "<path fill=\"", colour, "\" d=\"", path, "\"/>\n");
}

std::string curves_path(const View& view, const operations::SystemLevel& level) {
  return path_of(view, max_level_points, [&](PathWriter& writer) {
    for (const LevelCurve& curve : level.curves) {
      std::vector<Point> line = curve.points;
      if (curve.closed) line.push_back(line.front());
      writer.add_line(line);
    }
  });
}

}  // namespace

void write_levels_picture(const std::string& path, const LevelsReport& report) {
  const std::vector<operations::SystemLevel>& levels = report.result().levels;
  const LevelGrid& grid = *report.result().grid;
  const View view(grid.window());
  struct Entry {
    std::string swatch, text;
  };
  std::vector<Entry> entries;
  // The energy of a return map is not that of the picture.
  System named;
  named.info = report.system.info;
  std::erase_if(named.info.parameters, [](const Parameter& parameter) { return parameter.name == "energy"; });
  entries.push_back({"", system_text(named)});
  std::string drawn;
  if (report.energy) {
    const double energy = *report.energy;
    // Without a value, as at a mass, the potential has no lower bound: motion is possible there.
    add_cells(drawn, forbidden_colour, band_path(view, grid, [&](double value) { return value > energy; }));
    entries.push_back({opaque_swatch(forbidden_colour), "potential above " + rounded(energy) + ": no motion"});
  } else if (report.shaded) {
    for (std::size_t k = 0; k <= levels.size(); ++k) {
      const double low = k == 0 ? -HUGE_VAL : levels[k - 1].value;
      const double high = k == levels.size() ? HUGE_VAL : levels[k].value;
      const char* colour = band_colours[k * (band_colours.size() - 1) / levels.size()];
      add_cells(drawn, colour, band_path(view, grid, [&](double value) { return value >= low && value < high; }));
      const std::string text = k == 0               ? "below " + rounded(high)
                               : k == levels.size() ? rounded(low) + " and above"
                                                    : rounded(low) + " to " + rounded(high);
      entries.push_back({opaque_swatch(colour), std::string(report.quantity()) + " " + text});
    }
  }
  // Lines through saddles on top of the others.
  bool others = false;
  for (const bool through : {false, true}) {
    for (const operations::SystemLevel& level : levels) {
      if (level.saddle.has_value() != through) continue;
      const bool zero_velocity = report.energy && level.value == *report.energy;
      add_stroked(drawn, through && !zero_velocity ? saddle_colour : line_colour, through || zero_velocity ? 2.2 : 1,
                  curves_path(view, level));
      if (zero_velocity) {
        entries.push_back({line_swatch(line_colour, 2.2), "zero-velocity curve"});
      } else if (through) {
        entries.push_back({line_swatch(saddle_colour, 2.2),
                           "through a saddle, " + std::string(report.quantity()) + " = " + rounded(level.value)});
      } else {
        others = true;
      }
    }
  }
  if (others) {
    entries.push_back({line_swatch(line_colour, 1),
                       report.system.flow->dimension() == 2 ? "streamlines, levels of H" : "levels of the potential"});
  }
  drawn += "<g fill=\"#222222\">\n";
  bool dots = false;
  for (const Equilibrium& saddle : report.result().saddles) {
    const Rectangle& window = grid.window();
    if (saddle.at.x < window.min_x || saddle.at.x > window.max_x || saddle.at.y < window.min_y ||
        saddle.at.y > window.max_y) {
      continue;
    }
    add_dot(drawn, view(saddle.at), 4);
    dots = true;
  }
  drawn += "</g>\n";
  if (dots) entries.push_back({"<circle cx=\"13\" r=\"4\" fill=\"#222222\"/>", "saddles"});
  std::string svg;
  begin_picture(svg, view, "Level curves of " + report.system.info.name, static_cast<int>((entries.size() + 1) / 2));
  svg += drawn;
  begin_legend(svg);
  for (std::size_t k = 0; k < entries.size(); ++k) {
    add_legend_entry(svg, view, static_cast<int>(k % 2), static_cast<int>(k / 2), entries[k].swatch, entries[k].text);
  }
  end_picture(svg);
  write_file(path, svg);
}

}  // namespace lober::cli

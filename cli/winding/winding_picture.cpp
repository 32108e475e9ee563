// The picture of a field of winding numbers: the cells of each number in one colour, and the curve.

#include <algorithm>
#include <cstdlib>

#include "cli/report/svg.hpp"
#include "cli/winding/winding_report.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_curve_points = 200'000;
constexpr std::size_t max_entries = 12;

// Blue for counter-clockwise and red for clockwise turns, the darker the more of them.
constexpr std::array<const char*, 4> positive{"#a9c6e4", "#6397cb", "#2f6aa8", "#173e6b"};
constexpr std::array<const char*, 4> negative{"#efbfa8", "#dd8a63", "#bd5526", "#7d3210"};

const char* colour_of(int winding) {
  const auto& colours = winding > 0 ? positive : negative;
  return colours[std::min(colours.size(), static_cast<std::size_t>(std::abs(winding))) - 1];
}

// A rectangle for each run of cells of this number in a row.
std::string cells_path(const View& view, const WindingReport& report, int winding) {
  const WindingGrid& grid = *report.grid;
  const auto corner = [&](std::size_t column, std::size_t row) {
    const auto along = [](double low, double high, std::size_t k, std::size_t cells) {
      const double fraction = static_cast<double>(k) / static_cast<double>(cells);
      return low * (1 - fraction) + high * fraction;
    };
    return view({along(grid.window.min_x, grid.window.max_x, column, grid.columns),
                 along(grid.window.min_y, grid.window.max_y, row, grid.rows)});
  };
  const auto has = [&](std::size_t column, std::size_t row) {
    const Winding& cell = report.windings[row * grid.columns + column];
    return !cell.on && cell.number == winding;
  };
  std::string path;
  for (std::size_t row = 0; row < grid.rows; ++row) {
    for (std::size_t column = 0; column < grid.columns; ++column) {
      if (!has(column, row)) continue;
      const std::size_t first = column;
      while (column < grid.columns && has(column, row)) ++column;
      const Pixel low = corner(first, row), high = corner(column, row + 1);
      const int x0 = subpixel(low.x), y0 = subpixel(low.y), x1 = subpixel(high.x), y1 = subpixel(high.y);
      path += "M" + std::to_string(x0) + " " + std::to_string(y0) + "H" + std::to_string(x1) + "V" +
              std::to_string(y1) + "H" + std::to_string(x0) + "z";
    }
  }
  return path;
}

}  // namespace

void write_winding_picture(const std::string& path, const WindingReport& report) {
  const View view(report.grid->window);
  std::vector<WindingCount> entries;
  for (const WindingCount& count : report.counts) {
    if (count.winding != 0) entries.push_back(count);
  }
  // All numbers are drawn; the legend has the commonest.
  std::vector<WindingCount> listed = entries;
  if (listed.size() > max_entries) {
    std::nth_element(listed.begin(), listed.begin() + max_entries, listed.end(),
                     [](const WindingCount& a, const WindingCount& b) {
                       return a.points != b.points ? a.points > b.points : a.winding < b.winding;
                     });
    listed.resize(max_entries);
    std::sort(listed.begin(), listed.end(),
              [](const WindingCount& a, const WindingCount& b) { return a.winding < b.winding; });
  }
  std::string svg;
  begin_picture(svg, view, "Winding numbers of a curve", static_cast<int>(1 + (listed.size() + 1) / 2));
  for (const WindingCount& entry : entries) {
    svg += std::string("<path fill=\"") + colour_of(entry.winding) + "\" d=\"" +
           cells_path(view, report, entry.winding) + "\"/>\n";
  }
  add_stroked(svg, "#222222", 1.2, path_of(view, max_curve_points, [&](PathWriter& writer) {
                std::vector<Point> closed = report.input.curve.points;
                closed.push_back(closed.front());
                writer.add_line(closed);
              }));
  begin_legend(svg);
  add_legend_entry(svg, view, 0, 0, line_swatch("#222222", 1.2),
                   "the curve, signed area " + rounded(report.signed_area));
  for (std::size_t k = 0; k < listed.size(); ++k) {
    std::string swatch =
        std::string("<rect y=\"-8\" width=\"26\" height=\"16\" fill=\"") + colour_of(listed[k].winding) + "\"/>";
    add_legend_entry(svg, view, static_cast<int>(k % 2), static_cast<int>(1 + k / 2), swatch,
                     "winding number " + std::to_string(listed[k].winding) + ": " + std::to_string(listed[k].points) +
                         (listed[k].points == 1 ? " point" : " points"));
  }
  end_picture(svg);
  write_file(path, svg);
}

}  // namespace lober::cli

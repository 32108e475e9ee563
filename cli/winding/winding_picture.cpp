// The picture of a field of winding numbers: the cells of each number in one colour, and the curve.

#include <algorithm>
#include <array>
#include <cstdlib>

#include "cli/report/cells.hpp"
#include "cli/report/svg.hpp"
#include "cli/report/text.hpp"
#include "cli/winding/winding_report.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_legend_entries = 12;

// Blue for counter-clockwise and red for clockwise turns, the darker the more of them.
constexpr std::array<const char*, 4> counter_clockwise_colours{"#a9c6e4", "#6397cb", "#2f6aa8", "#173e6b"};
constexpr std::array<const char*, 4> clockwise_colours{"#efbfa8", "#dd8a63", "#bd5526", "#7d3210"};

const char* winding_colour(int winding) {
  const auto& colours = winding > 0 ? counter_clockwise_colours : clockwise_colours;
  return colours[std::min(colours.size(), static_cast<std::size_t>(std::abs(winding))) - 1];
}

// The cells of this number.
std::string winding_path(const View& view, const WindingReport& report, int winding) {
  const WindingGrid& grid = *report.grid;
  const auto corner = [&](std::size_t column, std::size_t row) {
    return view(cell_corner(grid.window, grid.columns, grid.rows, column, row));
  };
  const auto has = [&](std::size_t column, std::size_t row) {
    const Winding& cell = report.found().windings[row * grid.columns + column];
    return !cell.on && cell.number == winding;
  };
  std::string path;
  for_runs_of_cells(grid.columns, grid.rows, has, [&](std::size_t row, std::size_t first, std::size_t end) {
    const Pixel low = corner(first, row), high = corner(end, row + 1);
    append_all(path, "M", subpixel(low.x), " ", subpixel(low.y), "H", subpixel(high.x), "V", subpixel(high.y), "H",
               subpixel(low.x), "z");
  });
  return path;
}

}  // namespace

void write_winding_picture(const std::string& path, const WindingReport& report) {
  const View view(report.grid->window);
  std::vector<operations::CurveWinding::Count> entries;
  for (const operations::CurveWinding::Count& count : report.found().counts) {
    if (count.winding != 0) entries.push_back(count);
  }
  // All numbers are drawn; the legend has the commonest.
  std::vector<operations::CurveWinding::Count> listed = entries;
  if (listed.size() > max_legend_entries) {
    std::nth_element(listed.begin(), listed.begin() + max_legend_entries, listed.end(),
                     [](const operations::CurveWinding::Count& a, const operations::CurveWinding::Count& b) {
                       return a.points != b.points ? a.points > b.points : a.winding < b.winding;
                     });
    listed.resize(max_legend_entries);
    std::sort(listed.begin(), listed.end(),
              [](const operations::CurveWinding::Count& a, const operations::CurveWinding::Count& b) {
                return a.winding < b.winding;
              });
  }
  std::string svg;
  begin_picture(svg, view, "Winding numbers of a curve", static_cast<int>(1 + (listed.size() + 1) / 2));
  for (const operations::CurveWinding::Count& entry : entries) {
    svg += std::string("<path fill=\"") + winding_colour(entry.winding) + "\" d=\"" +
           winding_path(view, report, entry.winding) + "\"/>\n";
  }
  add_stroked(svg, "#222222", 1.2, path_of(view, max_path_points, [&](PathWriter& writer) {
                std::vector<Point> closed = report.input.curve.points;
                closed.push_back(closed.front());
                writer.add_line(closed);
              }));
  begin_legend(svg);
  add_legend_entry(svg, view, 0, 0, line_swatch("#222222", 1.2),
                   "the curve, signed area " + rounded(report.signed_area));
  for (std::size_t k = 0; k < listed.size(); ++k) {
    add_legend_entry(svg, view, static_cast<int>(k % 2), static_cast<int>(1 + k / 2),
                     opaque_swatch(winding_colour(listed[k].winding)),
                     "winding number " + std::to_string(listed[k].winding) + ": " + std::to_string(listed[k].points) +
                         (listed[k].points == 1 ? " point" : " points"));
  }
  end_picture(svg);
  write_file(path, svg);
}

}  // namespace lober::cli

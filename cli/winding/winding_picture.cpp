// The picture of a field of winding numbers: the cells of each number in one colour, and the curve.

#include <algorithm>
#include <array>
#include <cstdlib>

#include "cli/picture/cells.hpp"
#include "cli/picture/system_figure.hpp"
#include "cli/report/report.hpp"
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
Layer winding_layer(const WindingReport& report, const operations::CurveWinding::Count& count, bool listed) {
  const WindingGrid& grid = *report.grid;
  const std::string name = "winding number " + std::to_string(count.winding);
  Layer layer = box_layer(name, listed ? name + ": " + counted(count.points, "point", "points") : "",
                          winding_colour(count.winding));
  layer.boxes = cell_boxes(
      grid.columns, grid.rows,
      [&](std::size_t column, std::size_t row) {
        const Winding& cell = report.found().windings[row * grid.columns + column];
        return !cell.on && cell.number == count.winding;
      },
      [&](std::size_t column, std::size_t row) {
        return cell_corner(grid.window, grid.columns, grid.rows, column, row);
      });
  return layer;
}

}  // namespace

Figure winding_figure(const WindingReport& report) {
  using Count = operations::CurveWinding::Count;
  std::vector<Count> entries;
  for (const Count& count : report.found().counts) {
    if (count.winding != 0) entries.push_back(count);
  }
  // All numbers are drawn; the legend has the commonest.
  std::vector<Count> listed = entries;
  if (listed.size() > max_legend_entries) {
    std::nth_element(listed.begin(), listed.begin() + max_legend_entries, listed.end(),
                     [](const Count& a, const Count& b) {
                       return a.points != b.points ? a.points > b.points : a.winding < b.winding;
                     });
    listed.resize(max_legend_entries);
  }
  Figure figure{.what = "Winding numbers of a curve", .title = short_name(spec_of(report.input))};
  name_axes(figure, report.input);
  figure.window = report.grid->window;
  for (const Count& entry : entries) {
    const bool in_legend =
        std::any_of(listed.begin(), listed.end(), [&](const Count& one) { return one.winding == entry.winding; });
    figure.layers.push_back(winding_layer(report, entry, in_legend));
  }
  figure.layers.push_back(
      line_layer("curve", "the curve, signed area " + rounded(report.signed_area), palette::ink, 0.5));
  figure.layers.back().lines.push_back(polyline(std::span<const Point>(report.input.curve.points), true));
  return figure;
}

}  // namespace lober::cli

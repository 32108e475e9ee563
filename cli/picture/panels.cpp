#include "cli/picture/panels.hpp"

#include <algorithm>

#include "cli/picture/legend.hpp"
#include "cli/picture/rich_text.hpp"
#include "cli/report/text.hpp"

namespace lober::cli {

std::string panels_svg(const std::string& what, std::span<const Figure> figures, std::size_t columns,
                       const FigureStyle& style) {
  FigureStyle of_one = style;
  of_one.width = style.width / static_cast<double>(columns);
  of_one.legend = false;
  DrawnFigure all;
  double row_height = 0;
  for (std::size_t k = 0; k < figures.size(); ++k) {
    if (k % columns == 0) {
      all.height += row_height;
      row_height = 0;
    }
    const DrawnFigure drawn = draw_figure(figures[k], of_one, "plot" + std::to_string(k));
    const double left = static_cast<double>(k % columns) * drawn.width;
    append_all(all.elements, "<g transform=\"translate(", hundredth(left), " ", hundredth(all.height), ")\">\n",
               drawn.elements, "</g>\n");
    all.width = std::max(all.width, left + drawn.width);
    row_height = std::max(row_height, drawn.height);
  }
  all.height += row_height;
  if (style.legend) {
    constexpr double legend_border = 3;
    Figure together;
    for (const Figure& figure : figures) {
      together.layers.insert(together.layers.end(), figure.layers.begin(), figure.layers.end());
      together.notes.insert(together.notes.end(), figure.notes.begin(), figure.notes.end());
    }
    const Legend legend(together, all.width - 2 * legend_border, nullptr);
    legend.draw(all.elements, legend_border, all.height);
    all.height += legend.height() + legend_border;
  }
  return svg_document(what, all);
}

}  // namespace lober::cli

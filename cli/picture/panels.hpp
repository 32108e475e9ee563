// Several figures in one picture, with one legend.
#pragma once

#include <span>
#include <string>

#include "cli/picture/figure.hpp"
#include "cli/picture/figure_svg.hpp"

namespace lober::cli {

/// The figures row by row, `columns` in each, in a picture of the style's width; its height is that of each figure. The
/// legend below all has the texts of all figures, each once. `what`: the picture, in words.
[[nodiscard]] std::string panels_svg(const std::string& what, std::span<const Figure> figures, std::size_t columns,
                                     const FigureStyle& style);

}  // namespace lober::cli

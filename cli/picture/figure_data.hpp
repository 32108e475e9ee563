// The points of a figure as data, for those who draw it in another way.
#pragma once

#include <string>

#include "cli/picture/figure.hpp"

namespace lober::cli {

/// Comma-separated columns layer, item, name, x, y, error: a line a point, items counted from 0 in their layer; a box
/// has its two corners. Lines are whole, as they were before they were cut to the window.
[[nodiscard]] std::string figure_csv(const Figure& figure);
/// The same as one JSON object, with title, axes, window, colours and labels.
[[nodiscard]] std::string figure_json(const Figure& figure);

}  // namespace lober::cli

// The layers and labels of a figure in one view of the plane: the plot, and an inset in it.
#pragma once

#include <string>

#include "cli/picture/figure.hpp"
#include "cli/picture/view.hpp"

namespace lober::cli {

/// Appends the layers, cut to the view's frame. `name` is that of the frame in the picture.
void add_layers(std::string& svg, const Figure& figure, const View& view, const char* name);

/// Appends the labels, clear of lines, dots and `taken`, if there is one. `scale`: of their size.
void add_labels(std::string& svg, const Figure& figure, const View& view, const Frame* taken, double scale);

}  // namespace lober::cli

// The frame of a plot with its ticks, their texts and the names of the axes.
#pragma once

#include <string>

#include "cli/picture/figure.hpp"
#include "cli/picture/ticks.hpp"
#include "cli/picture/view.hpp"

namespace lober::cli {

/// "lon \u2212 7 (10^{\u22126} degrees)": the name with what its ticks leave out.
[[nodiscard]] std::string axis_text(const Axis& axis, const Ticks& ticks);

/// Ticks along the width of a plot, as many as their texts leave room for; along its height.
[[nodiscard]] Ticks ticks_across(const Rectangle& window, double width, double font_size, const Axis& axis);
[[nodiscard]] Ticks ticks_up(const Rectangle& window, double height, double font_size, const Axis& axis);

/// The widest of the texts.
[[nodiscard]] double widest(const Ticks& ticks, double font_size);

/// Appends frame and ticks, with their texts beside them.
void add_axes(std::string& svg, const View& view, const Ticks& across, const Ticks& up, double font_size);

}  // namespace lober::cli

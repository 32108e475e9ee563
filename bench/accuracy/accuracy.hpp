// Run time against error: what each method makes of a pair of curves whose true area is known.
#pragma once

#include <cstddef>
#include <functional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/scenes/scenes.hpp"
#include "cli/picture/figure.hpp"

namespace lober::bench {

/// A pair of closed curves with N points each, on smooth curves of which [C1 \ C2] is known.
struct AccuracyScene {
  std::string_view name;
  std::string_view description;
  Scene (*make)(std::size_t points);
};
[[nodiscard]] std::span<const AccuracyScene> accuracy_scenes();

/// A resonance region of the Henon map (x, y) -> (x^2 - y, x), bounded by pieces of the manifolds of its saddle (2, 2)
/// that meet on the diagonal, and its image: each vertex is an exact image of a point next to the saddle, so that only
/// the chords are wrong. [C1 \ C2] is the area of a turnstile lobe.
[[nodiscard]] Scene make_henon_lobe(std::size_t points);

/// How the line of a method is drawn.
struct CurveStyle {
  const char* colour = palette::ink;
  cli::DotShape shape = cli::DotShape::circle;
};

/// One way to [C1 \ C2].
struct AccuracyMethod {
  std::string_view name;
  CurveStyle style;
  std::function<double(const Scene& scene)> area;
};
[[nodiscard]] std::span<const AccuracyMethod> accuracy_methods();

/// One measurement.
struct AccuracyPoint {
  std::size_t points;
  double seconds;  ///< median
  double error;    ///< relative
};
struct AccuracyCurve {
  std::string method;
  CurveStyle style;
  std::vector<AccuracyPoint> points;
};
struct AccuracyPanel {
  std::string title;
  std::vector<AccuracyCurve> curves;
};

/// Names of both axes, and a line below the legend.
struct PlotTexts {
  std::string x, y, note;
};

/// Log-log plots side by side as SVG, run time to the right, error upwards, one line a method.
void write_plot(std::ostream& stream, const std::vector<AccuracyPanel>& panels, const PlotTexts& texts);

}  // namespace lober::bench

#include "cli/picture/fixed_point_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>

#include "cli/picture/system_figure.hpp"
#include "cli/report/report.hpp"

namespace lober::cli {
namespace {

constexpr double direction_share = 1.0 / 30;  // length of the lines at saddles, part of the box

struct Symbol {
  FixedPointKind kind;
  const char *one, *many, *remark;
  DotShape shape;
  bool hollow;
};
// Elliptic points are round and saddles have corners; those that do not exchange or reverse anything are filled.
constexpr std::array<Symbol, 7> symbols{{
    {FixedPointKind::saddle, "saddle", "saddles", ", \u03bb > 0", DotShape::square, false},
    {FixedPointKind::inverse_saddle, "saddle", "saddles", ", \u03bb < 0", DotShape::triangle, false},
    {FixedPointKind::reversing_saddle, "saddle", "saddles", ", \u03bb of both signs", DotShape::square, true},
    {FixedPointKind::centre, "elliptic point", "elliptic points", "", DotShape::circle, true},
    {FixedPointKind::parabolic, "parabolic point", "parabolic points", "", DotShape::cross, false},
    {FixedPointKind::attracting, "attracting point", "attracting points", "", DotShape::circle, false},
    {FixedPointKind::repelling, "repelling point", "repelling points", "", DotShape::triangle, true},
}};

// One for each period, from the least on; black alone where there is one period.
constexpr std::array<const char*, 5> colours_of_periods{palette::ink, palette::common, palette::entering, palette::flux,
                                                        palette::leaving};

bool is_saddle(const FixedPoint& point) {
  return point.kind == FixedPointKind::saddle || point.kind == FixedPointKind::inverse_saddle ||
         point.kind == FixedPointKind::reversing_saddle;
}

// Lines through the saddles, along the direction of the multiplier of this number.
Layer direction_layer(std::span<const FixedPoint> points, const Rectangle& box, std::size_t multiplier) {
  const bool repels = multiplier == 0;
  Layer layer =
      line_layer(repels ? "repelling directions" : "attracting directions",
                 repels ? "direction of U" : "direction of S", repels ? palette::unstable : palette::stable, 1.1);
  for (const FixedPoint& point : points) {
    if (!is_saddle(point)) continue;
    const Point along = point.directions[multiplier];
    const double extent = std::max(std::fabs(along.x) / box.width(), std::fabs(along.y) / box.height());
    if (!(extent > 0) || !std::isfinite(extent)) continue;
    const double t = direction_share / extent;
    layer.lines.push_back(polyline(std::vector<Point>{{point.at.x - t * along.x, point.at.y - t * along.y},
                                                      {point.at.x + t * along.x, point.at.y + t * along.y}},
                                   false));
  }
  return layer;
}

Layer points_layer(std::span<const FixedPoint> points, const Symbol& symbol, int period, bool say_period,
                   const char* colour) {
  std::vector<Point> at;
  for (const FixedPoint& point : points) {
    if (point.kind == symbol.kind && point.period == period) at.push_back(point.at);
  }
  std::string text = counted(at.size(), symbol.one, symbol.many);
  if (say_period) text += " of period " + std::to_string(period);
  Layer layer = dot_layer(std::string(name(symbol.kind)) + ", period " + std::to_string(period), text + symbol.remark,
                          std::move(at), symbol.shape == DotShape::triangle ? 2.2 : 1.9);
  layer.shape = symbol.shape;
  layer.hollow = symbol.hollow;
  layer.colour = colour;
  return layer;
}

// Three digits, and an exponent only where it is shorter.
std::string residue_text(double value) {
  std::array<char, 32> buffer{};
  const bool is_large = std::fabs(value) >= 1000 && std::fabs(value) < 1e6;
  std::snprintf(buffer.data(), buffer.size(), is_large ? "%.0f" : "%.3g", value);
  std::string text = buffer.data();
  if (text.starts_with('-')) text.replace(0, 1, "\u2212");
  return text;
}

}  // namespace

void add_fixed_points(Figure& figure, std::span<const FixedPoint> points, const Rectangle& box, bool labels) {
  for (const std::size_t multiplier : {std::size_t{1}, std::size_t{0}}) {
    Layer layer = direction_layer(points, box, multiplier);
    const char* const manifold = multiplier == 0 ? "U" : "S";
    const bool is_drawn = std::any_of(figure.layers.begin(), figure.layers.end(),
                                      [&](const Layer& other) { return other.name == manifold; });
    if (is_drawn) layer.legend.clear();
    if (!layer.lines.empty()) figure.layers.push_back(std::move(layer));
  }
  std::set<int> periods;
  for (const FixedPoint& point : points) periods.insert(point.period);
  const bool say_period = periods.size() > 1 || (!periods.empty() && *periods.begin() != 1);
  std::size_t nth = 0;
  for (const int period : periods) {
    const char* const colour = colours_of_periods[nth++ % colours_of_periods.size()];
    for (const Symbol& symbol : symbols) {
      Layer layer = points_layer(points, symbol, period, say_period, colour);
      if (!layer.points.empty()) figure.layers.push_back(std::move(layer));
    }
  }
  if (!labels || points.empty()) return;
  for (const FixedPoint& point : points) {
    std::string number = residue_text(residue(point));
    figure.labels.push_back({.text = std::move(number), .at = point.at, .radius = 2.2, .size = 6.5});
  }
  figure.notes.emplace_back("numbers: residues");
}

}  // namespace lober::cli

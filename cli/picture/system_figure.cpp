#include "cli/picture/system_figure.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "cli/report/text.hpp"
#include "engine/operations/section_edge.hpp"
#include "lober/curve/drawing.hpp"

namespace lober::cli {

std::string system_title(const SystemInfo& system) {
  std::string text = system.name.substr(system.name.rfind('/') + 1);
  const char* separator = ": ";
  for (const Parameter& parameter : system.parameters) {
    append_all(text, separator, parameter.name, " = ", rounded(parameter.value));
    separator = ", ";
  }
  return text;
}

void name_axes(Figure& figure, const System& system) {
  if (!system.section || !system.flow) return;
  // Positions, then velocities or momenta.
  constexpr std::array<const char*, 3> of_three{"x", "y", "z"};
  constexpr std::array<const char*, 4> of_four{"x", "y", "v_{x}", "v_{y}"};
  const auto name = [&](int coordinate) -> std::string {
    const auto k = static_cast<std::size_t>(coordinate);
    if (system.flow->dimension() == 4 && k < 4) return of_four[k];
    return k < 3 ? of_three[k] : "x_{" + std::to_string(k) + "}";
  };
  figure.x.name = name(system.section->chart_x);
  figure.y.name = name(system.section->chart_y);
  const auto conjugate = [&](const ConjugatePair& pair) {
    return pair.q == system.section->chart_x && pair.p == system.section->chart_y;
  };
  const auto pairs = system.flow->conjugate_pairs();
  if (std::any_of(pairs.begin(), pairs.end(), conjugate)) figure.plane = false;
}

Rectangle add_section_edge(Figure& figure, const Flow& flow, const Section& section, double energy,
                           const Rectangle& box) {
  Layer layer = line_layer("edge of the section", "edge: no points of this energy beyond", palette::ink, 0.5);
  Rectangle closed;
  for (LevelCurve& curve : detail::section_edge(flow, section, energy, box)) {
    if (curve.closed) closed = include(closed, curve.points);
    layer.lines.push_back(polyline(std::move(curve.points), curve.closed));
  }
  if (!layer.lines.empty()) figure.layers.push_back(std::move(layer));
  return closed;
}

void add_section_edge(Figure& figure, const System& system) {
  if (!system.section || !system.flow) return;
  for (const Parameter& parameter : system.info.parameters) {
    if (parameter.name == "energy") {
      add_section_edge(figure, *system.flow, *system.section, parameter.value, figure.window);
    }
  }
}

void name_axes(Figure& figure, const std::string& remark) {
  constexpr std::string_view begin = "columns named ", middle = " and ", end = ",";
  const std::size_t at = remark.find(begin);
  if (at == std::string::npos) return;
  const std::size_t first = at + begin.size(), between = remark.find(middle, first);
  if (between == std::string::npos) return;
  const std::size_t second = between + middle.size();
  figure.x.name = remark.substr(first, between - first);
  figure.y.name = remark.substr(second, remark.find(end, second) - second);
  if (remark.find("square degrees") != std::string::npos) figure.x.unit = figure.y.unit = "degrees";
}

std::vector<Point> orbit_positions(const Flow& flow, const PeriodicOrbit& orbit) {
  constexpr std::size_t count = 256;
  const auto pairs = flow.conjugate_pairs();
  std::vector<Point> points;
  for (const FlowState& state : states_along(flow, orbit, count, {.tolerance = 1e-14})) {
    points.push_back({state[static_cast<std::size_t>(pairs[0].q)], state[static_cast<std::size_t>(pairs[1].q)]});
  }
  return points;
}

std::string short_name(const std::string& spec) {
  const std::size_t end = spec.find('#'), slash = spec.rfind('/', end);
  return slash == std::string::npos ? spec : spec.substr(slash + 1);
}

Rectangle with_margin(const Rectangle& box) {
  return box.empty() ? box : widened(box, 1.0 / 30);
}

std::string rounded(double value) {
  std::array<char, 32> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 6).ptr;
  return {buffer.data(), end};
}

Polyline polyline(std::span<const Point> points, bool closed, std::string name) {
  return {.borrowed = points, .closed = closed, .name = std::move(name)};
}

Polyline polyline(std::vector<Point> points, bool closed, std::string name) {
  return {.own = std::move(points), .closed = closed, .name = std::move(name)};
}

}  // namespace lober::cli

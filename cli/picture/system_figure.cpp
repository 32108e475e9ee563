#include "cli/picture/system_figure.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "cli/report/text.hpp"
#include "engine/base/text.hpp"
#include "engine/operations/section_edge.hpp"
#include "lober/curve/drawing.hpp"

namespace lober::cli {

namespace {

// With six digits, or with all where ten letters hold them: energies are chosen close to that of a saddle.
std::string parameter_text(double value) {
  constexpr std::size_t max_letters = 10;
  std::string all = detail::format_number(value);
  return all.size() <= max_letters ? all : rounded(value);
}

}  // namespace

std::string system_title(const SystemInfo& system) {
  std::string text = system.name.substr(system.name.rfind('/') + 1);
  const char* separator = ": ";
  for (const Parameter& parameter : system.parameters) {
    append_all(text, separator, parameter.name, " = ", parameter_text(parameter.value));
    separator = ", ";
  }
  return text;
}

namespace {

// "easting (km)" and "easting [km]" are a name with its unit.
Axis axis_of(const std::string& cell) {
  for (const auto& [open, close] : {std::pair{'(', ')'}, {'[', ']'}}) {
    const std::size_t at = cell.find(open);
    if (at == std::string::npos || at == 0 || cell.back() != close) continue;
    const std::size_t end = cell.find_last_not_of(' ', at - 1);
    if (end == std::string::npos) continue;
    return {cell.substr(0, end + 1), cell.substr(at + 1, cell.size() - at - 2)};
  }
  return {cell};
}

// Where what begins with a parenthesis ends: its own closing one, or the comma at this level.
std::size_t end_of_part(std::string_view text, std::size_t begin) {
  int depth = 0;
  for (std::size_t k = begin; k < text.size(); ++k) {
    if (depth == 0 && (text[k] == ',' || text[k] == ')')) return k;
    if (text[k] == '(' || text[k] == '[') ++depth;
    if (text[k] == ')' || text[k] == ']') --depth;
  }
  return std::string_view::npos;
}

// Whether a part of a summary can be the name of a coordinate: one that does not begin with a digit and is not a
// sentence.
bool is_name(std::string_view text) {
  constexpr std::size_t max_name = 40, max_blanks = 3;
  return !text.empty() && text.size() <= max_name && (text[0] < '0' || text[0] > '9') &&
         static_cast<std::size_t>(std::count(text.begin(), text.end(), ' ')) <= max_blanks;
}

// The coordinates that the summary of a system names last: "period map in (x, x')", "plane (x, p)", "map in (angle
// [rad], momentum [kg m/s])".
void name_axes_by_summary(Figure& figure, std::string_view summary) {
  for (const std::string_view before : {" in (", "plane (", "angles ("}) {
    const std::size_t at = summary.rfind(before);
    if (at == std::string_view::npos) continue;
    const std::size_t begin = at + before.size(), comma = end_of_part(summary, begin);
    if (comma == std::string_view::npos || summary[comma] != ',') continue;
    const std::size_t second = summary.find_first_not_of(' ', comma + 1);
    if (second == std::string_view::npos) continue;
    const std::size_t end = end_of_part(summary, second);
    if (end == std::string_view::npos || summary[end] != ')') continue;
    const std::string_view x = summary.substr(begin, comma - begin), y = summary.substr(second, end - second);
    if (!is_name(x) || !is_name(y)) continue;
    figure.x = axis_of(std::string(x));
    figure.y = axis_of(std::string(y));
    if (figure.x.unit != figure.y.unit) figure.plane = false;
    return;
  }
}

}  // namespace

void name_axes(Figure& figure, const System& system) {
  if (!system.section || !system.flow) return name_axes_by_summary(figure, system.info.summary);
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
  if (!system.info.library.empty()) name_axes_by_summary(figure, system.info.summary);
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

namespace {

// The cells of a header: what is in quotes, or else what commas, semicolons, tabs or blanks part.
std::vector<std::string> header_cells(std::string_view header) {
  std::vector<std::string> cells;
  for (std::size_t quote = header.find('"'); quote != std::string_view::npos;) {
    const std::size_t end = header.find('"', quote + 1);
    if (end == std::string_view::npos) break;
    cells.emplace_back(header.substr(quote + 1, end - quote - 1));
    quote = header.find('"', end + 1);
  }
  if (cells.size() >= 2) return cells;
  cells.clear();
  char separator = ' ';
  for (const char candidate : {'\t', ';', ','}) {
    if (header.find(candidate) != std::string_view::npos) separator = candidate;
  }
  for (std::size_t begin = 0; begin <= header.size();) {
    const std::size_t end = std::min(header.find(separator, begin), header.size());
    std::string_view cell = header.substr(begin, end - begin);
    while (!cell.empty() && std::string_view(" #\"\r").find(cell.front()) != std::string_view::npos)
      cell.remove_prefix(1);
    while (!cell.empty() && std::string_view(" \"\r").find(cell.back()) != std::string_view::npos)
      cell.remove_suffix(1);
    if (!cell.empty()) cells.emplace_back(cell);
    begin = end + 1;
  }
  return cells;
}

}  // namespace

void name_axes(Figure& figure, const NamedCurve& input) {
  const std::vector<std::string> cells = header_cells(input.header);
  if (cells.size() >= 2) {
    figure.x = axis_of(cells[0]);
    figure.y = axis_of(cells[1]);
  }
  if (input.remark.find("square degrees") == std::string::npos) return;
  for (Axis* const axis : {&figure.x, &figure.y}) {
    if (axis->unit.empty()) axis->unit = "degrees";
  }
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

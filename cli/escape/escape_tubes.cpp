// The tubes of an escape in three dimensions, and trajectories among them: as legacy VTK, and as a picture.

#include <algorithm>
#include <cmath>

#include "cli/escape/tube_surfaces.hpp"
#include "cli/picture/system_figure.hpp"
#include "cli/report/text.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/files.hpp"

namespace lober::cli {

std::vector<Surface> surfaces_of(const Flow& flow, const EscapeReport& report, std::size_t around,
                                 std::size_t rings_a_period) {
  std::vector<Surface> list;
  for (const Bottleneck& bottleneck : report.result().bottlenecks) {
    for (const bool entry : {true, false}) {
      if (entry ? !report.tubes.unstable : !report.tubes.stable) continue;
      const auto& curves = entry ? bottleneck.entry : bottleneck.exit;
      if (curves.empty() || !curves.front().complete) continue;
      Section section = report.result().section;
      section.direction = curves.front().direction;
      if (section.direction == 0) continue;
      TubeSurfaceOptions options;
      options.around = around;
      options.rings_a_period = rings_a_period;
      options.integration = EscapeOptions{}.integration;
      list.push_back({tube_surface(flow, section, report.result().energy, curves.front().image.points, bottleneck.orbit,
                                   entry, options),
                      entry});
    }
  }
  if (list.empty()) throw DataError("--tubes: no tube meets the section as a closed curve, all in one direction");
  return list;
}

Position3 position_of(const FlowState& state, const Section& section) {
  const auto at = [&](int coordinate) { return state[static_cast<std::size_t>(coordinate)]; };
  return {at(section.coordinate), at(section.chart_x), at(section.chart_y)};
}

std::vector<FlowState> trajectory_from(const EscapeReport& report, Point start) {
  constexpr std::size_t steps_a_return = 400, max_steps = 4000;
  const Flow& flow = *report.flow;
  Section section = report.result().section;
  if (section.direction == 0) section.direction = 1;
  const IntegrationOptions& integration = EscapeOptions{}.integration;
  std::vector<FlowState> states{flow.on_section(section, report.result().energy, start)};
  if (!std::isfinite(states[0][static_cast<std::size_t>(section.solved)])) {
    throw DataError("--trajectory " + rounded(start.x) + "," + rounded(start.y) +
                    ": the section has no point of energy " + rounded(report.result().energy) +
                    " there; give one inside its edge, which --picture shows");
  }
  // Beyond the bottlenecks, by a tenth of the way from the section to the farthest point of their orbits.
  const auto across = static_cast<std::size_t>(section.coordinate);
  double low = section.value, high = section.value, period = 0;
  for (const Bottleneck& bottleneck : report.result().bottlenecks) {
    for (const FlowState& state : states_along(flow, bottleneck.orbit, 64, integration)) {
      low = std::min(low, state[across]);
      high = std::max(high, state[across]);
    }
    period = std::max(period, bottleneck.orbit.period);
  }
  low -= 0.1 * (section.value - low);
  high += 0.1 * (high - section.value);
  FlowState end = states[0];
  double time = 0;
  section.direction = 0;  // back is back, in either direction
  flow.to_section({&end, 1}, {&time, 1}, section, 1, integration);
  const bool returns = std::isfinite(end[across]) && std::isfinite(time);
  const double step = returns ? time / steps_a_return : period / 60;
  for (std::size_t k = 1; k < (returns ? steps_a_return : max_steps); ++k) {
    FlowState next = states.back();
    flow.integrate({&next, 1}, 0, step, integration);
    if (!(next[across] >= low && next[across] <= high)) return states;
    states.push_back(next);
  }
  if (returns) states.push_back(end);
  return states;
}

namespace {

// Quads with the coordinate that is left as a scalar, and the number of the tube.
std::string vtk(const Flow& flow, const EscapeReport& report) {
  const std::vector<Surface> surfaces = surfaces_of(flow, report, 96, 48);
  const Section& section = report.result().section;
  std::size_t points = 0, quads = 0;
  for (const Surface& surface : surfaces) {
    points += surface.tube.states.size();
    quads += surface.tube.around * (surface.tube.rings() - 1);
  }
  std::string text = "# vtk DataFile Version 3.0\n";
  append_all(text, "tubes of ", report.system.name, ", energy ", report.result().energy,
             "\nASCII\nDATASET POLYDATA\nPOINTS ", points, " double\n");
  for (const Surface& surface : surfaces) {
    for (const FlowState& state : surface.tube.states) {
      const Position3 p = position_of(state, section);
      append_all(text, p.x, " ", p.y, " ", p.z, "\n");
    }
  }
  append_all(text, "POLYGONS ", quads, " ", 5 * quads, "\n");
  std::size_t first = 0;
  for (const Surface& surface : surfaces) {
    const std::size_t around = surface.tube.around;
    for (std::size_t ring = 0; ring + 1 < surface.tube.rings(); ++ring) {
      for (std::size_t k = 0; k < around; ++k) {
        const std::size_t here = first + ring * around, next = (k + 1) % around;
        append_all(text, "4 ", here + k, " ", here + next, " ", here + around + next, " ", here + around + k, "\n");
      }
    }
    first += surface.tube.states.size();
  }
  append_all(text, "POINT_DATA ", points, "\nSCALARS velocity_across_section double 1\nLOOKUP_TABLE default\n");
  for (const Surface& surface : surfaces) {
    for (const FlowState& state : surface.tube.states) {
      append_all(text, state[static_cast<std::size_t>(section.solved)], "\n");
    }
  }
  text += "SCALARS tube int 1\nLOOKUP_TABLE default\n";
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    for (std::size_t point = 0; point < surfaces[k].tube.states.size(); ++point) append_all(text, k, "\n");
  }
  return text;
}

}  // namespace

bool is_vtk(const std::string& path) {
  if (path.ends_with(".vtk")) return true;
  if (path.ends_with(".svg") || path.ends_with(".pdf") || path.ends_with(".png")) return false;
  throw UsageError("--tubes " + path +
                   ": tubes are written as .vtk, or drawn as .svg, .pdf or .png; use one of these endings");
}

void write_escape_tubes(const std::string& path, const Flow& flow, const EscapeReport& report,
                        const FigureStyle& style) {
  if (is_vtk(path)) return write_file(path, vtk(flow, report));
  FigureStyle whole = style;  // a window is that of the section
  whole.window.reset();
  whole.inset.reset();
  write_figure(path, tubes_figure(flow, report), whole);
}

}  // namespace lober::cli

// The tubes of an escape in three dimensions: as legacy VTK, and as a picture.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "cli/escape/escape_report.hpp"
#include "cli/picture/system_figure.hpp"
#include "cli/report/text.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/drawing.hpp"
#include "lober/curve/files.hpp"
#include "lober/dynamics/tube_surface.hpp"

namespace lober::cli {
namespace {

struct Surface {
  TubeSurface tube;
  bool entry;
};

std::vector<Surface> surfaces_of(const Flow& flow, const EscapeReport& report, std::size_t around,
                                 std::size_t rings_a_period) {
  std::vector<Surface> list;
  for (const Bottleneck& bottleneck : report.result().bottlenecks) {
    for (const bool entry : {true, false}) {
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

struct Position3 {
  double x, y, z;
};

// The coordinate across the section, and both of its chart.
Position3 position_of(const FlowState& state, const Section& section) {
  const auto at = [&](int coordinate) { return state[static_cast<std::size_t>(coordinate)]; };
  return {at(section.coordinate), at(section.chart_x), at(section.chart_y)};
}

// Seen from ahead, from the right and from above: sines and cosines of 28 and 24 degrees.
class Projection {
 public:
  Projection(const std::vector<Surface>& surfaces, const Section& section) {
    for (const Surface& surface : surfaces) {
      for (const FlowState& state : surface.tube.states) {
        const Position3 p = position_of(state, section);
        const std::array<double, 3> c{p.x, p.y, p.z};
        for (std::size_t k = 0; k < 3; ++k) {
          low_[k] = std::min(low_[k], c[k]);
          high_[k] = std::max(high_[k], c[k]);
        }
      }
    }
  }
  struct Seen {
    Point at;
    double depth;  // larger is nearer
  };
  [[nodiscard]] Seen operator()(const Position3& p) const {
    const auto unit = [&](double value, std::size_t k) {
      return high_[k] > low_[k] ? (2 * value - low_[k] - high_[k]) / (high_[k] - low_[k]) : 0;
    };
    const double x = 1.6 * unit(p.x, 0), y = unit(p.y, 1), z = unit(p.z, 2);
    constexpr double sin_turn = 0.46947, cos_turn = 0.88295, sin_tilt = 0.40674, cos_tilt = 0.91355;
    const double right = cos_turn * x + sin_turn * y, away = cos_turn * y - sin_turn * x;
    return {{right, cos_tilt * z + sin_tilt * away}, sin_tilt * z - cos_tilt * away};
  }
  [[nodiscard]] Position3 corner(int x, int y, int z) const {
    const auto pick = [&](int which, std::size_t k) { return which == 0 ? low_[k] : high_[k]; };
    return {pick(x, 0), pick(y, 1), pick(z, 2)};
  }

 private:
  std::array<double, 3> low_{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high_{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
};

struct Facet {
  std::array<Point, 4> corners;
  double depth;
  const char* colour;
};

// Darker the more a facet is turned towards the eye.
const char* shade(bool entry, double facing) {
  constexpr std::array<const char*, 6> of_entry{"#f7d3b8", "#f2b98f", "#eb9c62", "#e27e34", "#d55e00", "#a94b00"},
      of_exit{"#c4dcec", "#9bc5e0", "#6eaad0", "#3d8ec1", "#0072b2", "#005a8d"};
  const auto level = static_cast<std::size_t>(std::min(5.0, std::floor(6 * facing)));
  return entry ? of_entry[level] : of_exit[level];
}

void add_facets(std::vector<Facet>& facets, const Surface& surface, const Projection& project, const Section& section) {
  const std::size_t around = surface.tube.around;
  for (std::size_t ring = 0; ring + 1 < surface.tube.rings(); ++ring) {
    for (std::size_t k = 0; k < around; ++k) {
      const std::size_t next = (k + 1) % around;
      std::array<Point, 4> corners;
      std::array<Projection::Seen, 4> seen;
      double depth = 0;
      const std::array<std::size_t, 4> index{ring * around + k, ring * around + next, (ring + 1) * around + next,
                                             (ring + 1) * around + k};
      for (std::size_t j = 0; j < 4; ++j) {
        seen[j] = project(position_of(surface.tube.states[index[j]], section));
        corners[j] = seen[j].at;
        depth += 0.25 * seen[j].depth;
      }
      // The normal, from both diagonals.
      const auto between = [](const Projection::Seen& a, const Projection::Seen& b) {
        return Position3{b.at.x - a.at.x, b.at.y - a.at.y, b.depth - a.depth};
      };
      const Position3 a = between(seen[0], seen[2]), b = between(seen[1], seen[3]);
      const double x = a.y * b.z - a.z * b.y, y = a.z * b.x - a.x * b.z, z = a.x * b.y - a.y * b.x;
      const double size = std::hypot(x, y, z);
      facets.push_back({corners, depth, shade(surface.entry, size > 0 ? std::fabs(z) / size : 0)});
    }
  }
}

// The axes from a corner of the box, with the names of the coordinates.
void add_axes_of_box(Figure& figure, const Projection& project, const std::array<std::string, 3>& names) {
  Layer axes = line_layer("axes", "", "#777777", 0.5);
  axes.arrow_at_end = true;
  const Point origin = project(project.corner(0, 0, 0)).at;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point end = project(project.corner(k == 0, k == 1, k == 2)).at;
    axes.lines.push_back(polyline(std::vector<Point>{origin, end}, false, names[k]));
    figure.labels.push_back({.text = names[k], .at = end, .radius = 2, .size = 8});
  }
  figure.layers.push_back(std::move(axes));
}

// Names of the coordinates of systems that have bottlenecks: positions, then momenta or velocities.
std::array<std::string, 3> names_of(const Section& section) {
  constexpr std::array<const char*, 4> names{"x", "y", "v_{x}", "v_{y}"};
  const auto name = [&](int coordinate) -> std::string {
    return coordinate < 4 ? names[static_cast<std::size_t>(coordinate)] : std::to_string(coordinate);
  };
  return {name(section.coordinate), name(section.chart_x), name(section.chart_y)};
}

Figure tubes_figure(const Flow& flow, const EscapeReport& report) {
  const std::vector<Surface> surfaces = surfaces_of(flow, report, 32, 18);
  const Section& section = report.result().section;
  const Projection project(surfaces, section);
  std::vector<Facet> facets;
  for (const Surface& surface : surfaces) add_facets(facets, surface, project, section);
  Rectangle window;
  for (int corner = 0; corner < 8; ++corner) {
    window.add(project(project.corner(corner & 1, (corner >> 1) & 1, corner >> 2)).at);
  }
  for (const Facet& facet : facets) window = include(window, facet.corners);
  // The plane of the section, as far as the box reaches.
  Facet plane{{}, 0, palette::flux};
  for (std::size_t k = 0; k < 4; ++k) {
    Position3 corner = project.corner(0, k == 1 || k == 2, k >= 2);
    corner.x = section.value;
    const auto seen = project(corner);
    plane.corners[k] = seen.at;
    plane.depth += 0.25 * seen.depth;
  }
  facets.push_back(plane);
  std::stable_sort(facets.begin(), facets.end(), [](const Facet& a, const Facet& b) { return a.depth < b.depth; });
  Figure figure{.what = "Tubes of " + report.system.name, .title = system_title(report.system)};
  figure.axes = false;
  figure.window = widened(window, 0.06);
  const std::array<std::string, 3> names = names_of(section);
  add_axes_of_box(figure, project, names);
  // One layer from the farthest to the nearest.
  Layer all = fill_layer("facets", "", palette::ink);
  all.opacity = 0.9;
  for (const Facet& facet : facets) {
    all.lines.push_back(polyline(std::vector<Point>(facet.corners.begin(), facet.corners.end()), true));
    all.lines.back().colour = facet.colour;
  }
  const auto sample = [&](const char* name, const char* colour, const std::string& text) {
    Layer layer = fill_layer(name, text, colour);
    layer.opacity = 0.9;
    figure.layers.push_back(std::move(layer));
  };
  sample("unstable", shade(true, 0.5), "unstable tubes: what enters");
  sample("stable", shade(false, 0.5), "stable tubes: what leaves");
  sample("section", palette::flux, "section " + names[0] + " = " + rounded(section.value));
  figure.layers.push_back(std::move(all));
  return figure;
}

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

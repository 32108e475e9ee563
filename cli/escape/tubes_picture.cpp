// The picture of tubes.

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/escape/tube_surfaces.hpp"
#include "cli/picture/system_figure.hpp"
#include "lober/curve/drawing.hpp"

namespace lober::cli {
namespace {

// Seen from ahead, from the right and from above: sines and cosines of 28 and 24 degrees.
class Projection {
 public:
  Projection(const std::vector<Surface>& surfaces, const std::vector<std::vector<FlowState>>& trajectories,
             const Section& section) {
    for (const Surface& surface : surfaces) add(surface.tube.states, section);
    for (const std::vector<FlowState>& states : trajectories) add(states, section);
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
  [[nodiscard]] double floor() const { return low_[2]; }

 private:
  void add(std::span<const FlowState> states, const Section& section) {
    for (const FlowState& state : states) {
      const Position3 p = position_of(state, section);
      const std::array<double, 3> c{p.x, p.y, p.z};
      for (std::size_t k = 0; k < 3; ++k) {
        low_[k] = std::min(low_[k], c[k]);
        high_[k] = std::max(high_[k], c[k]);
      }
    }
  }

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

// Colours of trajectories that leave by a bottleneck, and of those that come back to the section.
constexpr const char *leaving_colour = palette::leaving, *staying_colour = palette::ink;

bool comes_back(std::span<const FlowState> states, const Section& section) {
  return states.back()[static_cast<std::size_t>(section.coordinate)] == section.value;
}

// The trajectory as it is seen in the plane of both positions, on the floor of the box.
void add_shadow(Figure& figure, std::span<const FlowState> states, const Projection& project, const Section& section) {
  std::vector<Point> line;
  for (const FlowState& state : states) {
    Position3 at = position_of(state, section);
    at.z = project.floor();
    line.push_back(project(at).at);
  }
  Layer layer =
      line_layer("trajectory, on the floor", "", comes_back(states, section) ? staying_colour : leaving_colour, 0.5);
  layer.dashed = true;
  layer.lines.push_back(polyline(std::move(line), false));
  figure.layers.push_back(std::move(layer));
}

void add_trajectory(Figure& figure, std::span<const FlowState> states, std::size_t number, const Projection& project,
                    const Section& section) {
  const bool back = comes_back(states, section);
  std::vector<Point> line;
  for (const FlowState& state : states) line.push_back(project(position_of(state, section)).at);
  const std::string name = "trajectory " + std::to_string(number + 1);
  figure.layers.push_back(dot_layer(name + ", start", "", {line.front()}, 1.6));
  figure.layers.back().colour = back ? staying_colour : leaving_colour;
  Layer layer = line_layer(name, back ? "trajectory that comes back" : "trajectory that leaves",
                           back ? staying_colour : leaving_colour, 1);
  layer.arrow_at_end = true;
  layer.lines.push_back(polyline(std::move(line), false));
  figure.layers.push_back(std::move(layer));
}

// Names of the coordinates of systems that have bottlenecks: positions, then momenta or velocities.
std::array<std::string, 3> names_of(const Section& section) {
  constexpr std::array<const char*, 4> names{"x", "y", "v_{x}", "v_{y}"};
  const auto name = [&](int coordinate) -> std::string {
    return coordinate < 4 ? names[static_cast<std::size_t>(coordinate)] : std::to_string(coordinate);
  };
  return {name(section.coordinate), name(section.chart_x), name(section.chart_y)};
}

}  // namespace

Figure tubes_figure(const Flow& flow, const EscapeReport& report) {
  const std::vector<Surface> surfaces = surfaces_of(flow, report, 32, 18);
  const Section& section = report.result().section;
  std::vector<std::vector<FlowState>> trajectories;
  for (const Point& start : report.tubes.trajectories) trajectories.push_back(trajectory_from(report, start));
  const Projection project(surfaces, trajectories, section);
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
  for (const std::vector<FlowState>& states : trajectories) add_shadow(figure, states, project, section);
  // One layer from the farthest to the nearest.
  Layer all = fill_layer("facets", "", palette::ink);
  all.opacity = trajectories.empty() ? 0.9 : 0.35;  // trajectories run inside
  for (const Facet& facet : facets) {
    all.lines.push_back(polyline(std::vector<Point>(facet.corners.begin(), facet.corners.end()), true));
    all.lines.back().colour = facet.colour;
  }
  const auto sample = [&](const char* name, const char* colour, const std::string& text) {
    Layer layer = fill_layer(name, text, colour);
    layer.opacity = 0.9;
    figure.layers.push_back(std::move(layer));
  };
  if (report.tubes.unstable) sample("unstable", shade(true, 0.5), "unstable tubes: what enters");
  if (report.tubes.stable) sample("stable", shade(false, 0.5), "stable tubes: what leaves");
  sample("section", palette::flux, "section " + names[0] + " = " + rounded(section.value));
  figure.layers.push_back(std::move(all));
  for (std::size_t k = 0; k < trajectories.size(); ++k) {
    add_trajectory(figure, trajectories[k], k, project, section);
  }
  return figure;
}

}  // namespace lober::cli

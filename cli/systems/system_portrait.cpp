#include "cli/systems/system_portrait.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "cli/picture/cells.hpp"
#include "cli/picture/fixed_point_layers.hpp"
#include "cli/picture/system_figure.hpp"
#include "cli/report/report.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/drawing.hpp"
#include "lober/dynamics/orbits.hpp"
#include "lober/operations.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_orbits = 160, orbits_at_once = 16, orbit_length = 160;
constexpr double orbits_work = 3e7, manifold_work = 2e6;  // evaluations
constexpr const char* orbit_colour = "#9fb0c0";

// The cells of a grid on the window in which orbits have points.
class Cells {
 public:
  explicit Cells(const Rectangle& box) : box_(box), has_(columns * rows) {}

  void add(Point point) {
    const double x = (point.x - box_.min_x) / box_.width(), y = (point.y - box_.min_y) / box_.height();
    if (!(x >= 0 && x < 1 && y >= 0 && y < 1)) return;
    const auto column = static_cast<std::size_t>(x * static_cast<double>(columns));
    has_[static_cast<std::size_t>(y * static_cast<double>(rows)) * columns + column] = true;
  }
  [[nodiscard]] std::vector<Rectangle> boxes() const {
    return cell_boxes(
        columns, rows, [&](std::size_t column, std::size_t row) { return has_[row * columns + column]; },
        [&](std::size_t column, std::size_t row) { return cell_corner(box_, columns, rows, column, row); });
  }

 private:
  static constexpr std::size_t columns = 360, rows = 360;
  Rectangle box_;
  std::vector<bool> has_;
};

// Orbits that begin all over the window, as many as the work allows.
Layer orbits_layer(const System& system, const Rectangle& box) {
  Layer layer = box_layer("orbits", "", orbit_colour);
  const Buffer<Point> starts = spread_points(box, max_orbits);
  const std::uint64_t work_before = system.map->work();
  std::size_t orbits = 0;
  const OrbitOptions how{.iterates = orbit_length,
                         .lattice = system.lattice,
                         .origin = {box.min_x, box.min_y},
                         .second_lattice = system.second_lattice};
  Cells cells(box);
  while (orbits < max_orbits && static_cast<double>(system.map->work() - work_before) < orbits_work) {
    const std::span<const Point> some(&starts[orbits], std::min(orbits_at_once, max_orbits - orbits));
    follow_orbits(*system.map, some, how, [&](std::size_t, std::span<const Point> points) {
      for (const Point& point : points) {
        cells.add(point);
        // The window may be wider than the cell of the plane into which points are folded.
        cells.add({point.x + system.lattice.x, point.y + system.lattice.y});
      }
      return true;
    });
    orbits += some.size();
  }
  layer.boxes = cells.boxes();
  layer.legend = counted(orbits, "orbit", "orbits");
  return layer;
}

// The manifold of a connection as far as two sides of the window are long, or until it leaves the window by far; empty
// where it cannot be grown.
std::vector<Point> manifold_of(const System& system, const Connection& connection, ManifoldSide side,
                               const Rectangle& box) {
  const double extent = std::max(box.width(), box.height());
  const Rectangle room = widened(box, 0.25);
  const operations::Operation& operation = operations::named("grow");
  const std::vector<operations::OptionSetting> settings{
      {"side", side == ManifoldSide::unstable ? "unstable" : "stable"},
      {"from", connection.saddle(side)},
      {"branch", operations::to_string(operations::OptionValue(connection.direction(side)))},
      {"length", 2 * extent},
      {"tolerance", extent / 2000},
      {"box", room},
      {"max_work", manifold_work}};
  const operations::Options options(operation.options, settings);
  const operations::SystemInput input{std::make_shared<System>(system), {}};
  operations::Context context;
  context.keeps_what_is_known = true;
  try {
    const operations::Outcome outcome = operation.run(std::array<operations::Input, 1>{input}, options, context);
    const auto& manifold = outcome.as<operations::SystemManifold>();
    const auto end =
        std::find_if(manifold.points.begin(), manifold.points.end(), [&](Point p) { return !room.contains(p); });
    return {manifold.points.begin(), end};
  } catch (const DataError&) {
    return {};  // a portrait shows those that there are
  }
}

void add_manifolds(Figure& figure, const System& system, const Rectangle& box) {
  std::vector<Connection> connections = system.further;
  if (system.connection) connections.insert(connections.begin(), *system.connection);
  for (const ManifoldSide side : {ManifoldSide::stable, ManifoldSide::unstable}) {
    const bool unstable = side == ManifoldSide::unstable;
    Layer layer = line_layer(unstable ? "U" : "S", unstable ? "U, unstable manifolds" : "S, stable manifolds",
                             unstable ? palette::unstable : palette::stable, 0.6);
    for (const Connection& connection : connections) {
      std::vector<Point> points = manifold_of(system, connection, side, box);
      if (points.size() > 1) layer.lines.push_back(polyline(std::move(points), false, layer.name));
    }
    if (!layer.lines.empty()) figure.layers.push_back(std::move(layer));
  }
}

// The energy of a planar flow without a planar map.
void add_levels(Figure& figure, const System& system) {
  const operations::Operation& operation = operations::named("levels");
  const operations::SystemInput input{std::make_shared<System>(system), {}};
  const operations::Outcome outcome =
      operation.run(std::array<operations::Input, 1>{input}, {operation.options, {}}, {});
  const auto& found = outcome.as<operations::SystemLevels>();
  Layer layer = line_layer("levels", "levels of the energy", orbit_colour, 0.4);
  for (const operations::SystemLevel& level : found.levels) {
    for (const LevelCurve& curve : level.curves) {
      layer.lines.push_back(polyline(curve.points, curve.closed, "energy = " + rounded(level.value)));
    }
  }
  figure.layers.push_back(std::move(layer));
  figure.window = found.grid->window();
}

}  // namespace

Figure system_portrait(const System& system, std::span<const FixedPoint> points, bool labels) {
  Figure figure{.what = "Phase portrait", .title = system_title(system.info)};
  name_axes(figure, system);
  if (!system.map) {
    if (!system.flow) throw UsageError("--picture: system " + system.info.name + " has neither a map nor a flow");
    add_levels(figure, system);
    return figure;
  }
  Rectangle box = system.picture;
  if (system.connection && !box.empty()) box = include(box, std::array{system.connection->from, system.connection->to});
  if (!(box.width() > 0 && box.height() > 0)) {
    for (const FixedPoint& point : points) box.add(point.at);
    box = box.empty() ? Rectangle{-1, -1, 1, 1} : widened(box, 0.5);
  }
  figure.plane = !system.section.has_value();
  figure.guides = false;
  figure.window = with_margin(box);
  figure.layers.push_back(orbits_layer(system, box));
  add_manifolds(figure, system, box);
  add_fixed_points(figure, points, box, labels);
  if (!system.no_connection.empty()) figure.notes.push_back("no manifolds: " + system.no_connection);
  return figure;
}

}  // namespace lober::cli

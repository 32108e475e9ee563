// `levels`: level curves of the energy of a flow. Its value is a SystemLevels.
#include "lober/dynamics/levels.hpp"

#include <algorithm>
#include <cmath>

#include "engine/operations/option_list.hpp"
#include "engine/operations/outcome_of.hpp"
#include "engine/operations/picture_size.hpp"
#include "engine/operations/schema.hpp"
#include "engine/operations/system_of.hpp"
#include "engine/operations/table.hpp"
#include "lober/base/error.hpp"

namespace lober::operations {

std::size_t SystemLevel::closed() const {
  return static_cast<std::size_t>(
      std::count_if(curves.begin(), curves.end(), [](const LevelCurve& curve) { return curve.closed; }));
}

std::size_t SystemLevel::points() const {
  std::size_t count = 0;
  for (const LevelCurve& curve : curves) count += curve.points.size();
  return count;
}

}  // namespace lober::operations

namespace lober::detail::table {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

struct LevelsHow {
  std::optional<std::vector<double>> at{};
  std::size_t number = 24;
  std::optional<double> energy{};
  double time = 0;
  std::optional<Rectangle> box{};
  std::optional<Point> grid{};
};

const OptionList<LevelsHow>& levels_options() {
  static const OptionList<LevelsHow> options = [] {
    OptionList<LevelsHow> list;
    list.option("at", &LevelsHow::at, "values of the levels, with commas between",
                {.otherwise = "the given number of levels", .value = "E1,E2,..."})
        .option("number", &LevelsHow::number,
                "number of levels, at values that divide the cells of the grid evenly; those through saddles come on "
                "top",
                {.min = 1, .max = 1000, .value = "N"})
        .option("energy", &LevelsHow::energy,
                "energy of Hill's region: where the potential exceeds it no motion is possible (flows of two degrees "
                "of freedom)",
                {.otherwise = "the other levels", .value = "E"})
        .option("time", &LevelsHow::time, "time of a forced flow", {.value = "T"})
        .option("box", &LevelsHow::box, "corners of the box of the grid, x0 < x1 and y0 < y1",
                {.otherwise = "the system's window and saddles for a planar flow, a square about the origin with the "
                              "saddles else"})
        .option("grid", &LevelsHow::grid,
                "pair of numbers of cells, across and up; details smaller than a cell are missed",
                {.otherwise = "480, and as many up as make them square", .value = "NX,NY"});
    return list;
  }();
  return options;
}

// ---------------------------------------------------------------------------------------------------------- result

std::vector<Point> outline_of(const SystemLevel& level) {
  std::vector<Point> line;
  for (const LevelCurve& curve : level.curves) {
    line.insert(line.end(), curve.points.begin(), curve.points.end());
    if (curve.closed) line.push_back(curve.points.front());
    line.push_back({not_a_number, not_a_number});
  }
  return line;
}

std::vector<Field> levels_fields() {
  Schema<Equilibrium> saddle;
  saddle.field("at", "length", "position of the saddle", &Equilibrium::at)
      .field("energy", "energy", "its energy", &Equilibrium::energy);
  Schema<SystemLevel> level;
  level.field("energy", "energy", "value of the level", &SystemLevel::value)
      .field("saddle", "length", "saddle that the level goes through",
             [](const SystemLevel& l) {
               return l.saddle.value_or(Point{not_a_number, not_a_number});
             })
      .or_null()
      .field("curves", "", "number of curves", [](const SystemLevel& l) { return l.curves.size(); })
      .field("closed", "", "number of closed curves", &SystemLevel::closed)
      .field("points", "", "number of points of all curves", &SystemLevel::points)
      .field("outline", "length", "the curves, closed ones with their first point again, each with a NaN behind it",
             outline_of);
  Schema<SystemLevels> made;
  made.list("saddles", "saddles of the flow at that time, near the ends of its connections or in its bottlenecks",
            saddle, [](const SystemLevels& l) -> const std::vector<Equilibrium>& { return l.saddles; })
      .list("levels", "levels by value, ascending", level,
            [](const SystemLevels& l) -> const std::vector<SystemLevel>& { return l.levels; });
  return made.fields();
}

// ------------------------------------------------------------------------------------------------------------- run

// Near the ends of the system's connections, or near those that bound its well.
std::vector<Equilibrium> equilibria_of(const System& system, double time) {
  std::vector<FlowState> guesses;
  if (system.flow->dimension() == 4) {
    guesses = system.saddles;
  } else {
    std::vector<Connection> connections = system.further;
    if (system.connection) connections.insert(connections.begin(), *system.connection);
    for (const Connection& connection : connections) {
      guesses.push_back({connection.from.x, connection.from.y});
      guesses.push_back({connection.to.x, connection.to.y});
    }
  }
  std::vector<Equilibrium> saddles;
  for (const FlowState& guess : guesses) {
    try {
      const Equilibrium found = equilibrium_near(*system.flow, guess, time);
      const auto same = [&](const Equilibrium& other) {
        return std::hypot(found.at.x - other.at.x, found.at.y - other.at.y) < 1e-6;
      };
      if (found.saddle && std::none_of(saddles.begin(), saddles.end(), same)) saddles.push_back(found);
    } catch (const DataError&) {
      continue;  // none there at this moment
    }
  }
  return saddles;
}

Rectangle box_about(const System& system, const std::vector<Equilibrium>& saddles) {
  if (system.flow->dimension() == 2) {
    // With all saddles, which the window may leave out, and some room about them.
    Rectangle box = system.picture;
    const double room_x = 0.1 * box.width(), room_y = 0.1 * box.height();
    for (const Equilibrium& saddle : saddles) {
      Rectangle with_it = box;
      with_it.add(saddle.at);
      if (with_it == box) continue;
      box.add({saddle.at.x - room_x, saddle.at.y - room_y});
      box.add({saddle.at.x + room_x, saddle.at.y + room_y});
    }
    return box;
  }
  // The well about the origin that the saddles bound.
  double reach = 0.5;
  for (const Equilibrium& saddle : saddles) {
    reach = std::max({reach, std::fabs(saddle.at.x), std::fabs(saddle.at.y)});
  }
  return Rectangle::of({-1.5 * reach, -1.5 * reach}, {1.5 * reach, 1.5 * reach});
}

// Numbers of cells across and up.
Point cells_of(const LevelsHow& how, const Rectangle& box) {
  const PictureSize size = picture_size(box);
  const Point cells = how.grid.value_or(Point{480, std::max(1.0, std::round(480 * size.height / size.width))});
  for (const double count : {cells.x, cells.y}) {
    if (!(count >= 1 && count <= 30'000 && count == std::floor(count)))
      throw UsageError("option \"grid\": both numbers have to be whole, from 1 to 30000");
  }
  return cells;
}

// Values that divide the nodes of the grid evenly.
std::vector<double> spread_levels(const LevelGrid& grid, std::size_t number) {
  std::vector<double> values;
  for (std::size_t row = 0; row <= grid.rows(); ++row) {
    for (std::size_t column = 0; column <= grid.columns(); ++column) {
      if (std::isfinite(grid.value(column, row))) values.push_back(grid.value(column, row));
    }
  }
  if (values.empty()) throw DataError("the energy has no value anywhere in the box");
  std::sort(values.begin(), values.end());
  std::vector<double> levels;
  for (std::size_t k = 0; k < number; ++k) levels.push_back(values[(2 * k + 1) * (values.size() - 1) / (2 * number)]);
  return levels;
}

// Also through the saddles, unless the levels are given or Hill's region is asked for.
std::vector<SystemLevel> chosen_levels(const LevelsHow& how, const LevelGrid& grid,
                                       const std::vector<Equilibrium>& saddles) {
  std::vector<double> values = how.energy ? std::vector{*how.energy} : how.at.value_or(std::vector<double>{});
  if (values.empty()) {
    values = spread_levels(grid, how.number);
    for (const Equilibrium& saddle : saddles) values.push_back(saddle.energy);
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  std::vector<SystemLevel> levels;
  for (const double value : values) {
    const auto near = [&](double other) { return std::fabs(value - other) <= 1e-12 * (1 + std::fabs(value)); };
    // Saddles of one symmetry differ by rounding.
    if (!levels.empty() && near(levels.back().value)) continue;
    SystemLevel level{value, {}, {}};
    for (const Equilibrium& saddle : saddles) {
      if (near(saddle.energy)) level.saddle = saddle.at;
    }
    levels.push_back(std::move(level));
  }
  return levels;
}

Outcome run_levels(std::span<const Input> inputs, const Options& options, const Context& context) {
  const System& system = *system_input_of(inputs).system;
  const LevelsHow how = levels_options().how(options);
  if (!system.flow) throw UsageError(system.info.name + " is a map; level curves of energy are those of a flow");
  if (how.at && how.energy) throw UsageError("option \"at\" and option \"energy\" cannot be given together");
  if (how.energy && system.flow->dimension() == 2) {
    throw UsageError("option \"energy\": Hill's region belongs to flows of two degrees of freedom; use option \"at\"");
  }
  if (!std::isfinite(how.time) || !std::isfinite(how.energy.value_or(0)))
    throw UsageError("option \"time\" and option \"energy\" have to be finite");
  SystemLevels found;
  found.saddles = equilibria_of(system, how.time);
  const Rectangle box = how.box.value_or(box_about(system, found.saddles));
  const Point cells = cells_of(how, box);
  PlaneFunction energy = [flow = system.flow, of = energy_of(*system.flow, how.time)](Point at) { return of(at); };
  found.grid = std::make_shared<const LevelGrid>(std::move(energy), box, static_cast<std::size_t>(cells.x),
                                                 static_cast<std::size_t>(cells.y));
  found.levels = chosen_levels(how, *found.grid, found.saddles);
  for (std::size_t k = 0; k < found.levels.size(); ++k) {
    found.levels[k].curves = found.grid->curves(found.levels[k].value);
    const double done = static_cast<double>(k + 1) / static_cast<double>(found.levels.size());
    if (!context.progress(done, "levels")) throw Cancelled();
  }
  Outcome outcome = outcome_of(std::move(found), options);
  outcome.chosen.push_back({"box", box});
  outcome.chosen.push_back({"grid", cells});
  return outcome;
}

}  // namespace

Operation levels_operation() {
  Operation operation;
  operation.name = "levels";
  operation.title = "level curves of the energy of a flow: streamlines, potential, Hill's region";
  operation.summary =
      "Computes level curves of the energy of a flow: streamlines of a planar flow with those through its saddles, "
      "curves of equal potential and Hill's region of a flow of two degrees of freedom.";
  operation.compares = false;
  operation.inputs = {{"system", InputKind::system, "a Hamiltonian flow"}};
  operation.options = levels_options().specs();
  operation.result = levels_fields();
  operation.examples = {{{"ovp eps=0"}, {}, "streamlines of the vortex pair, with its separatrix"},
                        {{"capsize"}, {{"energy", 0.25}}, "the region in which the ship can move"}};
  operation.run = run_levels;
  return operation;
}

}  // namespace lober::detail::table

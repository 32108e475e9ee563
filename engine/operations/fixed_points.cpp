// `fixed_points`: fixed and periodic points of a system's map in a box. Its value is a SystemFixedPoints.
#include "lober/dynamics/fixed_points.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/operations/option_list.hpp"
#include "engine/operations/outcome_of.hpp"
#include "engine/operations/schema.hpp"
#include "engine/operations/system_of.hpp"
#include "engine/operations/table.hpp"
#include "lober/base/error.hpp"

namespace lober::detail::table {
namespace {

struct FixedPointsHow : FixedPointOptions {
  std::optional<Rectangle> box{};
  int max_grid = 384;
  std::optional<double> seconds{};
};

const OptionList<FixedPointsHow>& fixed_points_options() {
  static const OptionList<FixedPointsHow> options = [] {
    OptionList<FixedPointsHow> list;
    list.option("box", &FixedPointsHow::box,
                "corners of the box that is searched, x0 < x1 and y0 < y1, in the coordinates of the map",
                {.otherwise = "the system's window"})
        .option("period", &FixedPointsHow::period,
                "period, in iterates of the map; points whose least period divides it are found too",
                {.min = 1, .max = 1000, .value = "P"});
    add_turns_option(list)
        .option("grid", &FixedPointsHow::grid,
                "number of points a side of the grid of the first scan; each further one has twice as many",
                {.min = 2, .max = 4096, .value = "N"})
        .option("max_grid", &FixedPointsHow::max_grid, "number of points a side of the grid of the last scan",
                {.min = 2, .max = 16384, .value = "N"})
        .option("budget", &FixedPointsHow::seconds,
                "wall-clock time that the search may take, in seconds; points found by then are in the result",
                {.min = 0.01,
                 .max = 1e9,
                 .otherwise = "a limit on the work instead, of some seconds on one core, which gives the same points "
                              "on every machine",
                 .value = "SECONDS"});
    return list;
  }();
  return options;
}

// ---------------------------------------------------------------------------------------------------------- result

// A point, and its index for the period that was asked for.
struct IndexedPoint {
  const FixedPoint* point;
  int index;
};

std::vector<IndexedPoint> indexed_points(const SystemFixedPoints& found) {
  std::vector<IndexedPoint> list;
  for (const FixedPoint& point : found.points) list.push_back({&point, index_of(point, found.period)});
  return list;
}

Matrix matrix_of(double xx, double xy, double yx, double yy) {
  return {2, 2, {{xx, 0}, {xy, 0}, {yx, 0}, {yy, 0}}};
}

Schema<IndexedPoint> point_schema() {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto turns = [](const FixedPoint& p) { return p.multipliers[0].imag() != 0; };
  Schema<IndexedPoint> made;
  made.field("x", "length", "coordinate of the point", [](const IndexedPoint& p) { return p.point->at.x; })
      .field("y", "length", "coordinate of the point", [](const IndexedPoint& p) { return p.point->at.y; })
      .field("period", "", "least n after which the point is where it was, or has turned as often as was asked for",
             [](const IndexedPoint& p) { return p.point->period; })
      .field("type", "",
             "kind by the multipliers: saddle, inverse saddle, centre, parabolic, attracting, repelling or that of a "
             "saddle "
             "with reversed orientation",
             [](const IndexedPoint& p) { return std::string(name(p.point->kind)); })
      .field("residue", "", "Greene's residue, (2 - trace of the derivative) / 4",
             [](const IndexedPoint& p) { return residue(*p.point); })
      .field("index", "", "sign of det(1 - derivative of the map iterated by the period asked for)",
             &IndexedPoint::index)
      .field("multipliers", "", "eigenvalues of the derivative, real and imaginary parts; that of larger modulus first",
             [](const IndexedPoint& p) {
               const auto& [first, second] = p.point->multipliers;
               return matrix_of(first.real(), first.imag(), second.real(), second.imag());
             })
      .field("derivative", "", "derivative of the map iterated by the period of the point, row by row",
             [](const IndexedPoint& p) {
               const Matrix2& d = p.point->derivative;
               return matrix_of(d.xx, d.xy, d.yx, d.yy);
             })
      .field("residual", "length", "distance by which the point is not mapped to itself",
             [](const IndexedPoint& p) { return p.point->residual; })
      .field("rotation", "",
             "rotation of nearby points about it, in turns a period; not known where multipliers are real",
             [turns](const IndexedPoint& p) {
               return turns(*p.point) ? std::arg(p.point->multipliers[0]) / (2 * std::numbers::pi) : none;
             })
      .field("directions", "", "unit eigenvectors of the multipliers; not known where these are complex",
             [turns](const IndexedPoint& p) {
               const auto& [first, second] = p.point->directions;
               return turns(*p.point) ? matrix_of(none, none, none, none)
                                      : matrix_of(first.x, first.y, second.x, second.y);
             })
      .or_null();
  return made;
}

std::vector<Field> fixed_points_fields() {
  Schema<SystemFixedPoints> search;
  search
      .field("settled", "", "whether the last scan found what the one before had found, and no index contradicts it",
             &SystemFixedPoints::settled)
      .field("isolated", "", "false where fixed points fill a curve or an area: the points are then some of them",
             &SystemFixedPoints::isolated)
      .field("out_of_work", "", "whether the search ended because no more work was allowed",
             &SystemFixedPoints::out_of_work)
      .field("grid", "", "number of points a side of the last scan", &SystemFixedPoints::grid)
      .field("index_sum", "", "sum of the indices of the points inside the box", &SystemFixedPoints::index_sum)
      .field("index_of_box", "",
             "sum of the indices of all points inside, by the edge of the box alone; not known where a point lies next "
             "to it, or some point has no image",
             &SystemFixedPoints::index_of_box)
      .or_null();
  Schema<SystemFixedPoints> made;
  made.object("search", "how complete the points are", search, [](const SystemFixedPoints& f) { return &f; })
      .list("points", "points in order of period, x, y", point_schema(), indexed_points);
  return made.fields();
}

// ------------------------------------------------------------------------------------------------------------- run

constexpr const char* not_isolated_remark =
    "the fixed points are not isolated: they fill a curve or an area, and those in the result are some of them";

Outcome run_fixed_points(std::span<const Input> inputs, const Options& options, const Context& context) {
  const System& system = *system_of(inputs).system;
  FixedPointsHow how = fixed_points_options().how(options);
  const Point shift = shift_by(how.turns, system);
  how.lattice = system.lattice;
  if (how.max_grid < how.grid) {
    throw UsageError("option \"max_grid\" has to be at least option \"grid\", which is " + std::to_string(how.grid));
  }
  if (how.seconds) how.budget = *how.seconds;
  const Rectangle box = how.box.value_or(system.window);
  SystemFixedPoints found{search_fixed_points(*system.map, box, how, how.max_grid, context.progress)};
  found.box = box;
  found.period = how.period;
  found.turns = how.turns;
  const bool isolated = found.isolated;
  Outcome outcome = outcome_of(std::move(found), options);
  if (!isolated) outcome.remarks.emplace_back(not_isolated_remark);
  outcome.chosen.push_back({"box", box});
  outcome.chosen.push_back({"shift", shift});
  return outcome;
}

}  // namespace

Operation fixed_points_operation() {
  Operation operation;
  operation.name = "fixed_points";
  operation.title = "fixed and periodic points of a system's map, with multipliers, residues and types";
  operation.summary =
      "Finds the fixed and periodic points of a map, or of a flow's Poincare map, in a box, with their multipliers, "
      "residues and types.";
  operation.revision = 3;  // half way on and back for maps too, whole orbits, degenerate points by what is round them
  operation.compares = false;
  operation.inputs = {{"system", InputKind::system, "the system whose points they are"}};
  operation.options = fixed_points_options().specs();
  operation.result = fixed_points_fields();
  operation.examples = {{{"standard K=1.2"}, {{"period", std::int64_t{2}}}, "points of period 1 and 2"},
                        {{"henon"}, {}, "the fixed points of the Henon map"}};
  operation.run = run_fixed_points;
  return operation;
}

}  // namespace lober::detail::table

#include "engine/operations/escape_fields.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "engine/operations/escape_choice.hpp"
#include "engine/operations/schema.hpp"
#include "lober/transport/escape.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

std::vector<double> numbers_of(const FlowState& state) {
  return {state.begin(), state.begin() + 4};
}

template <typename States>
Matrix rows_of_states(const States& states, std::size_t rows) {
  Matrix matrix{rows, 4, {}};
  for (std::size_t k = 0; k < rows; ++k) {
    for (std::size_t j = 0; j < 4; ++j) matrix.entries.push_back({states[k][j], 0});
  }
  return matrix;
}

Schema<SaddlePoint> saddle_schema_of(bool with_rates) {
  Schema<SaddlePoint> made;
  made.field("at", "", "state of the saddle", [](const SaddlePoint& s) { return numbers_of(s.at); })
      .field("energy", "energy", "its energy", &SaddlePoint::energy);
  if (!with_rates) return made;
  return made.field("rate", "1 / time", "real eigenvalues are +- rate", &SaddlePoint::rate)
      .field("frequency", "1 / time", "imaginary eigenvalues are +- i frequency", &SaddlePoint::frequency);
}

Schema<PeriodicOrbit> orbit_schema() {
  using Orbit = PeriodicOrbit;
  Schema<Orbit> made;
  made.field("state", "", "a point of the orbit", [](const Orbit& o) { return numbers_of(o.state); })
      .field("turning", "", "states where the orbit turns", [](const Orbit& o) { return rows_of_states(o.turning, 2); })
      .field("brake", "", "whether the orbit is at rest there", &Orbit::brake)
      .field("period", "time", "period of the orbit", &Orbit::period)
      .field("action", "action", "integral of p dq over the orbit",
             [](const Orbit& o) {
               return Measured{o.action, o.action_error};
             })
      .field("multipliers", "", "Floquet multipliers",
             [](const Orbit& o) {
               return std::vector<double>{o.multiplier, 1, 1, 1 / o.multiplier};
             })
      .field("monodromy", "", "derivative of the flow over one period",
             [](const Orbit& o) { return rows_of_states(o.monodromy, 4); })
      .field("trace_defect", "", "trace of the monodromy matrix less the sum of the multipliers", &Orbit::trace_defect)
      .field("residual", "", "distance by which the orbit does not close", &Orbit::residual)
      .field("continuation_steps", "", "number of steps in energy from the saddle to the orbit",
             &Orbit::continuation_steps);
  return made;
}

Schema<TubeCurve> tube_curve_schema() {
  Schema<TubeCurve> made;
  made.field("points", "", "number of points", [](const TubeCurve& c) { return c.image.points.size(); })
      .field("direction", "", "direction in which its trajectories cross; 0 when not all cross alike",
             &TubeCurve::direction)
      .field("cut", "", "whether part of the curve has left", &TubeCurve::cut)
      .field("cut_off", "area", "area that may be lost by closing a cut curve", &TubeCurve::cut_off)
      .field("area", "area", "area that the curve encloses; not known for a cut curve",
             [](const TubeCurve& c) { return c.cut ? std::numeric_limits<double>::quiet_NaN() : c.area; })
      .field("area_error", "area", "its error bar", &TubeCurve::area_error)
      .field("outline", "", "points of the curve in the section's chart",
             [](const TubeCurve& c) { return std::vector<Point>(c.image.points.begin(), c.image.points.end()); });
  return made;
}

// A bottleneck with the name that it has beside the others.
struct Named {
  const Bottleneck* bottleneck;
  std::string name;
};

std::vector<Named> named_bottlenecks(const SystemEscape& escape) {
  const std::vector<std::string> names = bottleneck_names(escape);
  std::vector<Named> list;
  for (std::size_t k = 0; k < names.size(); ++k) list.push_back({&escape.bottlenecks[k], names[k]});
  return list;
}

Schema<Named> bottleneck_schema() {
  Schema<Named> made;
  made.field("name", "", "left, right, or a number from 1", &Named::name)
      .object("saddle", "the saddle of rank 1", saddle_schema_of(true),
              [](const Named& n) { return &n.bottleneck->orbit.saddle; })
      .object("orbit", "periodic orbit in the bottleneck", orbit_schema(),
              [](const Named& n) { return &n.bottleneck->orbit; })
      .field("area", "area", "area of the entrance and the exit, by action",
             [](const Named& n) {
               return Measured{n.bottleneck->area, n.bottleneck->area_error};
             })
      .field("multiplier", "", "multiplier of the orbit, found from the local manifold of its tube",
             [](const Named& n) { return n.bottleneck->multiplier; })
      .field("area_defect", "", "largest |area of a curve / area - 1|",
             [](const Named& n) { return n.bottleneck->area_defect; })
      .list("entry_curves", "E, f(E), f^2(E), ...", tube_curve_schema(),
            [](const Named& n) -> const std::vector<TubeCurve>& { return n.bottleneck->entry; })
      .list("exit_curves", "X, f^-1(X), ...", tube_curve_schema(),
            [](const Named& n) -> const std::vector<TubeCurve>& { return n.bottleneck->exit; });
  return made;
}

Schema<Section> bound_schema() {
  Schema<Section> made;
  made.field("coordinate", "", "number of the coordinate", &Section::bound_coordinate)
      .field("value", "", "value of the coordinate at the bound", &Section::bound)
      .field("side", "", "-1: below; 1: above", &Section::bound_side);
  return made;
}

Schema<Section> section_schema() {
  Schema<Section> made;
  made.field("coordinate", "", "number of the coordinate that is fixed", &Section::coordinate)
      .field("value", "", "value of the coordinate on the section", &Section::value)
      .field("direction", "", "sign of the velocity of crossings that count; 0: both", &Section::direction)
      .field("chart", "", "numbers of the coordinates of the chart",
             [](const Section& s) {
               return std::vector<std::int64_t>{s.chart_x, s.chart_y};
             })
      .object("bound", "the part of the section that counts, where not all of it does", bound_schema(),
              [](const Section& s) { return s.bound_side == 0 ? nullptr : &s; });
  return made;
}

struct TableRow {
  const EscapeFraction* row;
  const MonteCarloFraction* counted;
  std::string entrance, exit;
};

std::vector<TableRow> table_rows(const SystemEscape& escape) {
  const std::vector<std::string> names = bottleneck_names(escape);
  std::vector<TableRow> rows;
  for (std::size_t k = 0; k < escape.table.size(); ++k) {
    const EscapeFraction& row = escape.table[k];
    rows.push_back({&row, escape.counted ? &escape.counted->table[k] : nullptr, names[row.entry], names[row.exit]});
  }
  return rows;
}

Schema<MonteCarloFraction> counted_schema() {
  Schema<MonteCarloFraction> made;
  made.field("count", "", "number of trajectories", &MonteCarloFraction::count)
      .field("fraction", "", "fraction of all trajectories", &MonteCarloFraction::fraction)
      .field("standard_error", "", "standard error of the fraction", &MonteCarloFraction::standard_error);
  return made;
}

Schema<TableRow> table_schema() {
  using Split = std::vector<std::int64_t>;
  Schema<TableRow> made;
  made.field("entrance", "", "bottleneck by which trajectories enter", &TableRow::entrance)
      .field("exit", "", "bottleneck by which trajectories leave", &TableRow::exit)
      .field("crossings", "", "n, the number of crossings of the section in its direction",
             [](const TableRow& r) { return r.row->crossings; })
      .field("iterates", "", "m, the number of iterates of the map to the next crossing",
             [](const TableRow& r) { return r.row->iterates; })
      .field(
          "fraction", "", "fraction of the trajectories entering that leave so",
          [](const TableRow& r) {
            return Measured{r.row->fraction, r.row->error};
          },
          "error")
      .field("cut", "", "whether part of a curve had left", [](const TableRow& r) { return r.row->cut; })
      .field("split", "", "images of the entrance, pre-images of the exit",
             [](const TableRow& r) {
               return Split{r.row->forward, r.row->backward};
             })
      .field(
          "other", "", "the fraction from another split",
          [](const TableRow& r) {
            return Measured{r.row->other, r.row->other_error};
          },
          "other_error")
      .field("other_split", "", "the other split",
             [](const TableRow& r) {
               return Split{r.row->other_forward, r.row->other_backward};
             })
      .object("counted", "count by trajectories, where they were followed", counted_schema(),
              [](const TableRow& r) { return r.counted; });
  return made;
}

std::string reason_of(EscapeStop stop) {
  switch (stop) {
    case EscapeStop::done:
      return "done";
    case EscapeStop::points:
      return "points";
    case EscapeStop::work:
      return "work";
    case EscapeStop::budget:
      return "budget";
    case EscapeStop::lost:
      return "lost";
    case EscapeStop::cancelled:
      break;
  }
  return "interrupted";
}

Schema<SystemEscape> stop_schema() {
  const auto only = [](EscapeStop stop, double Escape::*member) {
    return [stop, member](const SystemEscape& e) { return e.stop == stop ? std::optional(e.*member) : std::nullopt; };
  };
  Schema<SystemEscape> made;
  made.field("reason", "", "points, work, budget, lost or interrupted",
             [](const SystemEscape& e) { return reason_of(e.stop); })
      .field("points_ahead", "", "points that the next image was expected to need",
             only(EscapeStop::points, &Escape::points_ahead))
      .field("work_spent", "", "work of all images so far", only(EscapeStop::work, &Escape::work_spent))
      .field("work_ahead", "", "work of the next images, as expected; 0: they were broken off",
             only(EscapeStop::work, &Escape::work_ahead))
      .field("seconds_spent", "time", "seconds of all images so far", only(EscapeStop::budget, &Escape::seconds_spent))
      .field("seconds_ahead", "time", "seconds of the next images, as expected; not known where they were broken off",
             [](const SystemEscape& e) {
               const bool known = e.stop == EscapeStop::budget;
               return known ? std::optional(e.seconds_ahead == 0 ? std::numeric_limits<double>::quiet_NaN()
                                                                 : e.seconds_ahead)
                            : std::nullopt;
             });
  return made;
}

struct Remaining {
  Survival step;
  std::string entrance;
};

std::vector<Remaining> remaining(const SystemEscape& escape) {
  const std::vector<std::string> names = bottleneck_names(escape);
  std::vector<Remaining> list;
  for (std::size_t entry = 0; entry < names.size(); ++entry) {
    for (const Survival& step : survival(escape, entry)) list.push_back({step, names[entry]});
  }
  return list;
}

Schema<Remaining> survival_schema() {
  Schema<Remaining> made;
  made.field("entrance", "", "bottleneck by which trajectories entered", &Remaining::entrance)
      .field("crossings", "", "n", [](const Remaining& r) { return r.step.crossings; })
      .field("left", "", "fractions that have left by each exit up to n",
             [](const Remaining& r) { return r.step.left; })
      .field(
          "remains", "", "fraction that has not left",
          [](const Remaining& r) {
            return Measured{r.step.remains, r.step.error};
          },
          "error");
  return made;
}

}  // namespace

std::vector<Field> escape_fields() {
  const auto itself = [](const SystemEscape& e) { return &e; };
  Schema<SystemEscape> consistency, counted;
  consistency.field("largest_split_difference", "", "largest difference between two splits of one fraction",
                    [](const SystemEscape& e) { return e.largest_split_difference; });
  counted.field("trajectories", "", "from each entrance", [](const SystemEscape& e) { return e.counted->trajectories; })
      .field("seed", "", "seed of the random numbers", [](const SystemEscape& e) { return e.seed; })
      .field("lost", "", "number of trajectories neither inside an exit nor followed to the next crossing",
             [](const SystemEscape& e) { return e.counted->lost; })
      .field("largest_deviation", "", "largest deviation of counted fractions from the table, in standard errors",
             [](const SystemEscape& e) { return e.counted->largest_deviation; });
  Schema<SystemEscape> made;
  made.field("energy", "energy", "the total energy", [](const SystemEscape& e) { return e.energy; })
      .object("section", "the section whose crossings are counted", section_schema(),
              [](const SystemEscape& e) { return &e.section; })
      .list("bottlenecks", "bottlenecks in order of the coordinate across the section", bottleneck_schema(),
            named_bottlenecks)
      .list("also_open", "saddles below the energy that are not bottlenecks here", saddle_schema_of(false),
            [](const SystemEscape& e) -> const std::vector<SaddlePoint>& { return e.also_open; })
      .field("crossings", "", "n up to which the table goes", [](const SystemEscape& e) { return e.crossings; })
      .object("stop", "why the table does not go as far as was asked for", stop_schema(),
              [](const SystemEscape& e) { return e.stop == EscapeStop::done ? nullptr : &e; })
      .list("table", "fractions by entrance, exit and crossing", table_schema(), table_rows)
      .list("survival", "fractions that have left and that have not, after crossing n", survival_schema(), remaining)
      .object("consistency", "consistency of the table", consistency, itself)
      .object("monte_carlo", "results of the check by trajectories", counted,
              [](const SystemEscape& e) { return e.counted ? &e : nullptr; });
  return made.fields();
}

}  // namespace lober::detail::table

// `escape`: the fraction that leaves a potential well through its bottlenecks, and when. Its value is a SystemEscape.
#include "lober/transport/escape.hpp"

#include <algorithm>
#include <cmath>

#include "engine/operations/describe.hpp"
#include "engine/operations/escape_choice.hpp"
#include "engine/operations/system_of.hpp"
#include "engine/operations/table.hpp"
#include "lober/base/error.hpp"

namespace lober::detail::table {
namespace {

struct EscapeHow : EscapeOptions {
  std::optional<double> total_energy{}, seconds{};
  std::optional<std::string> saddle{}, section{}, direction{}, bound{};
  std::uint64_t trajectories = 2000, seed = MonteCarloOptions{}.seed;
};

const OptionList<EscapeHow>& escape_options() {
  static const OptionList<EscapeHow> options = [] {
    OptionList<EscapeHow> list;
    list.option("energy", &EscapeHow::total_energy, "total energy, above that of the saddles",
                {.otherwise = "the parameter energy of the system", .value = "E"})
        .option("crossings", &EscapeHow::crossings,
                "number of crossings of the section up to which the table goes; with 0 only the orbits, the tubes and "
                "their first crossings are computed",
                {.min = 0, .max = 1000, .value = "N"})
        .option("saddle", &EscapeHow::saddle,
                "saddles of the potential, with semicolons between: the number of each among those of the system, from "
                "1, or a position near it, or four coordinates",
                {.otherwise = "all saddles of the system", .value = "K|X,Y[,PX,PY]"})
        .option("section", &EscapeHow::section,
                "section, x=VALUE or y=VALUE, where x and y are the coordinates of position",
                {.otherwise = "the section of the system", .value = "COORDINATE=VALUE"})
        .option("direction", &EscapeHow::direction,
                "sign of the velocity of the crossings that count: +, - or, with no crossings, both",
                {.otherwise = "that of the system's section, or + with a section of one's own; with no crossings both, "
                              "unless the section has a bound",
                 .value = "SIGN",
                 .choices = {"+", "-", "both"}})
        .option("bound", &EscapeHow::bound,
                "part of the section whose crossings count, for example x<-1 or y>0, with no crossings only",
                {.otherwise = "that of the system, or the whole section with a section of one's own",
                 .value = "COORDINATE<VALUE"})
        .option("tolerance", &EscapeHow::tolerance,
                "maximum distance between a curve and its polygon, relative to the square root of the area of the "
                "smallest entrance",
                {.min = 1e-12, .max = 1e-2, .value = "E"})
        .option("max_points", &EscapeHow::max_points,
                "maximum number of points of a curve; the table ends before an image that is expected to need more",
                {.min = 100, .max = 1 << 30, .value = "N"})
        .option("max_work", &EscapeHow::max_work,
                "work that the table may take, in evaluations of the vector field, where no time is given",
                {.min = 0, .above_min = true, .value = "N"})
        .option("budget", &EscapeHow::seconds,
                "wall-clock time that the table may take, in seconds; it ends before images that are expected to end "
                "later, and those that do not end as expected are broken off",
                {.min = 0,
                 .above_min = true,
                 .otherwise = "a limit on the work instead, which gives the same table on every machine",
                 .value = "SECONDS"})
        .option("monte_carlo", &EscapeHow::trajectories,
                "number of trajectories to follow from each entrance, as a check of the table; 0: none",
                {.min = 0, .max = 1e12, .value = "N"})
        .option("seed", &EscapeHow::seed, "seed of the random numbers of these trajectories", {.value = "S"});
    return list;
  }();
  return options;
}

// ---------------------------------------------------------------------------------------------------------- result

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

// ------------------------------------------------------------------------------------------------------------- run

std::vector<std::string> parts_of(const std::optional<std::string>& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; text && begin <= text->size();) {
    const std::size_t end = std::min(text->find(';', begin), text->size());
    parts.push_back(text->substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

// The table, or the orbits and tubes alone.
SystemEscape escape_of(const SystemInput& input, const EscapeHow& how) {
  const EscapeChoice choice{how.total_energy, parts_of(how.saddle), how.section, how.direction,
                            how.bound,        how.crossings};
  const System system = system_with_energy(input, choice);
  const std::vector<FlowState> saddles = saddles_of(choice, system);
  const double energy = energy_of(choice, system);
  const Section section = section_of(choice, system);
  if (how.crossings > 0) {
    const double share = how.trajectories > 0 ? 0.5 : 1;  // share of the table in all work
    const EscapeOptions& of_table = how;
    EscapeOptions options = of_table;
    options.progress = [&](double fraction, const std::string& what) { return how.progress(share * fraction, what); };
    SystemEscape found{escape(*system.flow, section, energy, saddles, options)};
    if (how.trajectories == 0 || found.crossings == 0 || found.stop == EscapeStop::cancelled) return found;
    MonteCarloOptions check;
    check.trajectories = how.trajectories;
    check.seed = found.seed = how.seed;
    check.progress = [&](double fraction) { return how.progress(share + (1 - share) * fraction, "trajectories"); };
    found.counted = monte_carlo(*system.flow, found, check);
    compare(found, *found.counted, found.agreement);
    return found;
  }
  SystemEscape found;
  found.energy = energy;
  found.section = section;
  found.bottlenecks = bottlenecks(*system.flow, section, energy, saddles, how);
  compare_areas(found.bottlenecks, found.agreement);
  return found;
}

Outcome run_escape(std::span<const Input> inputs, const Options& options, const Context& context) {
  const SystemInput& input = system_input_of(inputs);
  EscapeHow how = escape_options().how(options);
  if (how.seconds) how.budget = *how.seconds;
  how.progress = context.progress;
  if (context.on_part) {
    how.rows_known = [&](const Escape& so_far, int) { context.on_part(&so_far); };
  }
  SystemEscape found = escape_of(input, how);
  if (found.stop == EscapeStop::cancelled && !context.keeps_what_is_known) throw Cancelled();
  return outcome_of(std::move(found), options);
}

}  // namespace

Operation escape_operation() {
  Operation operation;
  operation.name = "escape";
  operation.title = "escape from a potential well by its bottlenecks, crossing by crossing";
  operation.summary =
      "Computes the escape from a potential well: the periodic orbits of its bottlenecks, their tubes on a section, "
      "and "
      "the fraction of the trajectories entering by one bottleneck that leave by another after n crossings.";
  operation.inputs = {{"system", InputKind::system, "a Hamiltonian flow of two degrees of freedom"}};
  operation.options = escape_options().specs();
  operation.result = escape_fields();
  operation.examples = {{{"capsize"}, {{"energy", 0.25307}}, "how soon ships capsize"}};
  operation.run = run_escape;
  return operation;
}

}  // namespace lober::detail::table

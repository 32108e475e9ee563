// `escape`: the fraction that leaves a potential well through its bottlenecks, and when. Its value is a SystemEscape.
#include "lober/transport/escape.hpp"

#include <algorithm>

#include "engine/operations/escape_choice.hpp"
#include "engine/operations/escape_fields.hpp"
#include "engine/operations/option_list.hpp"
#include "engine/operations/outcome_of.hpp"
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
  operation.revision = 8;  // sums of hidden areas in another order
  operation.title = "escape from a potential well by its bottlenecks, crossing by crossing";
  operation.summary =
      "Computes the escape from a potential well: the periodic orbits of its bottlenecks, their tubes on a section, "
      "and "
      "the fraction of the trajectories entering by one bottleneck that leave by another after n crossings.";
  operation.inputs = {{"system", InputKind::system, "a Hamiltonian flow of two degrees of freedom"}};
  operation.options = escape_options().specs();
  operation.result = escape_fields();
  operation.examples = {
      {{"capsize"}, {{"energy", 0.25307}}, "how soon ships capsize"},
      {{"capsize"}, {{"energy", 0.28}, {"crossings", std::int64_t{2}}}, "with more energy, two crossings"}};
  operation.run = run_escape;
  return operation;
}

}  // namespace lober::detail::table

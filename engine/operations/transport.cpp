// `transport`: what leaves a region of a system, iterate by iterate, from its equations alone. Its value is a
// Transport.
#include "lober/transport/transport.hpp"

#include <algorithm>
#include <cmath>

#include "engine/operations/connection_choice.hpp"
#include "engine/operations/growth_options.hpp"
#include "engine/operations/melnikov.hpp"
#include "engine/operations/option_list.hpp"
#include "engine/operations/outcome_of.hpp"
#include "engine/operations/schema.hpp"
#include "engine/operations/system_of.hpp"
#include "engine/operations/table.hpp"
#include "engine/operations/tangle_fields.hpp"
#include "engine/operations/transport_fields.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

struct How : TransportOptions {
  std::optional<double> tolerance_given{}, seconds{};
  bool all_regions = false, melnikov = false;
};

const OptionList<How>& transport_options() {
  static const OptionList<How> options = [] {
    OptionList<How> list;
    list.option("iterates", &How::iterates, "number of iterates n up to which the table goes",
                {.min = 1, .max = 1000, .value = "N"});
    add_growth_options(list)
        .option(
            "max_work", &How::max_work,
            "work that growing the manifolds of one boundary may take, in evaluations of the vector field, where no "
            "time is given",
            {.min = 0, .above_min = true, .value = "N"})
        .option("budget", &How::seconds, "wall-clock time that all of it may take, in seconds",
                {.min = 0,
                 .above_min = true,
                 .otherwise = "a limit on the work instead, which gives the same table on every machine",
                 .value = "SECONDS"})
        .option(
            "all_regions", &How::all_regions,
            "whether to compute the transport between the regions of all boundaries that the system names (ovp: the "
            "lower vortex too), with the matrices T_ij(n)")
        .option("particles", &How::particles,
                "number of particles in each bounded region by which T(n) is counted, as a check",
                {.min = 0, .max = 1e9, .value = "N"})
        .option(
            "melnikov", &How::melnikov,
            "whether to compute Melnikov's function too, and the areas of lobes to first order in the parameter that "
            "is the size of the system's perturbation (eps) beside the exact ones")
        .option("seed", &How::seed, "seed of the random numbers of the particles", {.value = "S"});
    return list;
  }();
  return options;
}

// ---------------------------------------------------------------------------------------------------------- result

Schema<Transport> region_schema() {
  const auto tangle = [](const Transport& t) -> const Tangle& { return t.manifolds().tangle; };
  Schema<Transport> made;
  made.field(
          "area", "area", "area of R1", [](const Transport& t) { return t.regions.front().area; }, "error")
      .field("crosses_itself", "", "whether the polygon of the boundary crosses itself",
             [tangle](const Transport& t) { return tangle(t).boundary->crosses_itself; })
      .field("bip", "length", "the pip q at which the boundary passes from U to S",
             [](const Transport& t) { return t.manifolds().orbits.back().at; })
      .field("orientation", "", "orientation of the boundary along U: clockwise or counter_clockwise",
             [tangle](const Transport& t) {
               return tangle(t).boundary->orientation > 0 ? "counter_clockwise" : "clockwise";
             });
  return made;
}

const Schema<TransportBoundary>& boundary_turnstile() {
  using Boundary = TransportBoundary;
  static const Schema<Boundary> schema = [] {
    Schema<Boundary> made;
    made.parts(turnstile_schema(), [](const Boundary& b) { return b.manifolds.get(); })
        .field("flux12", "area", "area that leaves the region inside in one step", &Boundary::flux12)
        .field("flux21", "area", "area that enters the region inside in one step", &Boundary::flux21)
        .field("lobe_area12", "area", "sum of the lobes that leave, each counted fully", &Boundary::lobe_area12)
        .field("lobe_area21", "area", "sum of the lobes that enter, each counted fully", &Boundary::lobe_area21)
        .field("lobe_area12_by_action", "area", "the same by action; not known where the map has none",
               &Boundary::lobe_area12_by_action)
        .field("lobe_area21_by_action", "area", "the same by action; not known where the map has none",
               &Boundary::lobe_area21_by_action);
    return made;
  }();
  return schema;
}

Schema<TransportBoundary> boundary_schema() {
  using Boundary = TransportBoundary;
  Schema<Boundary> made;
  made.object("saddles", "saddles of its tangle", saddles_schema(), [](const Boundary& b) { return b.manifolds.get(); })
      .object("turnstile", "lobes and fluxes", boundary_turnstile(), [](const Boundary& b) { return &b; })
      .field("enclosed", "area",
             "area that it encloses; where it runs round a cylinder, above the line along the lattice",
             &Boundary::enclosed)
      .field("point_error", "length", "how far the manifolds may lie beside the true ones by integration and rounding",
             &Boundary::point_error)
      .field("outline", "length", "the polygon of the boundary",
             [](const Boundary& b) { return boundary_curve(*b.manifolds); });
  return made;
}

Schema<Transport> error_schema() {
  Schema<Transport> made = step_errors<Transport>();
  made.field("area_conservation", "area", "|flux12 - flux21| of the turnstile, by geometry", [](const Transport& t) {
    return std::fabs(t.boundaries.front().flux12.value - t.boundaries.front().flux21.value);
  });
  return made;
}

Schema<Transport> statistics_schema() {
  using Counts = std::vector<std::int64_t>;
  const auto of_both = [](auto count) {
    return [count](const Transport& t) {
      return Counts{static_cast<std::int64_t>(count(t.manifolds().u)),
                    static_cast<std::int64_t>(count(t.manifolds().s))};
    };
  };
  const auto nodes = [](const Transport& t) -> const Crossings& { return t.manifolds().tangle.nodes; };
  Schema<Transport> made;
  made.field("points", "", "number of points of U and of S",
             of_both([](const GrownManifold& m) { return m.points.size(); }))
      .field("images", "", "steps of the map taken for U and for S",
             of_both([](const GrownManifold& m) { return m.images; }))
      .field("pips", "", "number of pips", [](const Transport& t) { return t.manifolds().tangle.pips.size(); })
      .field("count", "", "number of crossings of U and S",
             [nodes](const Transport& t) { return nodes(t).crossings(); })
      .field("contacts", "", "number of points where U and S touch",
             [nodes](const Transport& t) { return nodes(t).touches(); })
      .field("shared_arcs", "", "number of arcs that U and S share",
             [nodes](const Transport& t) { return nodes(t).shared_arcs(); })
      .field("same_curve", "", "whether U and S are one and the same",
             [nodes](const Transport& t) { return nodes(t).same_curve(); });
  return made;
}

const TransportBoundary& first_boundary(const Transport& t) {
  return t.boundaries.front();
}

std::vector<Field> transport_fields() {
  Schema<SystemTransport> made;
  made.object("saddles", "saddles of the first tangle", saddles_schema(), &Transport::manifolds)
      .object("region", "R1, inside the first boundary", region_schema(),
              [](const SystemTransport& t) -> const Transport* { return &t; })
      .list("regions", "R1, R2, ...", regions_schema(), &Transport::regions)
      .object("turnstile", "turnstile of the first boundary", boundary_turnstile(), first_boundary)
      .list("boundaries", "a tangle each", boundary_schema(), &Transport::boundaries)
      .object("melnikov", "Melnikov's function, where it was asked for", melnikov_schema(),
              [](const SystemTransport& t) { return t.melnikov ? &*t.melnikov : nullptr; })
      .if_asked_for()
      .field("iterates_a_step", "", "iterates of the map in a step; 2 where both multipliers of a saddle are negative",
             &Transport::iterates_a_step)
      .list("steps", "n = 1, 2, ...", step_schema(), &Transport::steps)
      .field("remarks", "", "remarks on the result", &Transport::remarks)
      .object("error", "error bars of T21(n) and the checks that support them", error_schema(),
              [](const SystemTransport& t) -> const Transport* { return &t; })
      .object("statistics", "statistics of the first tangle", statistics_schema(),
              [](const SystemTransport& t) -> const Transport* { return &t; });
  return made.fields();
}

// ------------------------------------------------------------------------------------------------------------- run

Outcome run(std::span<const Input> inputs, const Options& options, const Context& context, const Field& steps) {
  const SystemInput& input = system_of(inputs);
  const System& system = *input.system;
  How how = transport_options().how(options);
  const ConnectionChoice choice = connection_options().how(options);
  const Connection connection = chosen_connection(choice, system);
  how.tolerance = tolerance_in(system, how.tolerance_given);
  how.lattice = system.lattice;
  how.further = further_of(choice, system, how.all_regions);
  if (choice.bip) how.bip_near = choice.bip;
  constexpr std::size_t bytes_per_point = 240;  // two manifolds that are grown, and data made from them
  how.max_points = std::min(how.max_points, std::max<std::size_t>(context.memory / bytes_per_point, 1000));
  how.progress = context.progress;
  if (context.on_element) {
    how.on_step = [&](const TransportStep& step, const Agreement& agreement) {
      context.on_element(steps, &step, agreement);
    };
  }
  if (how.seconds) how.budget = *how.seconds;
  // First, so that a system without one is refused before the work.
  std::optional<Melnikov> function;
  if (how.melnikov) function = melnikov_of(input, {}, system, connection);
  SystemTransport found{transport(*system.map, connection, how)};
  if (function) found.melnikov = melnikov_comparison(std::move(*function), system, found.manifolds());
  Outcome outcome = outcome_of(std::move(found), options);
  outcome.chosen = settings_of(connection);
  outcome.chosen.push_back({"tolerance", how.tolerance});
  return outcome;
}

}  // namespace

Operation transport_operation() {
  Operation operation;
  operation.name = "transport";
  operation.revision = 8;  // sums of hidden areas in another order
  operation.title = "transport across a boundary of a system, iterate by iterate: a(n) and T(n)";
  operation.summary =
      "Computes the transport across the boundary that a stable and an unstable manifold of a map make: grows them, "
      "finds the turnstile, and computes the fluxes a(n) and T(n) by lobes and by boundaries.";
  operation.inputs = {{"system", InputKind::system, "the system whose manifolds they are"}};
  operation.options = connection_options().specs();
  operation.options.insert(operation.options.end(), transport_options().specs().begin(),
                           transport_options().specs().end());
  operation.result = transport_fields();
  operation.examples = {
      {{"ovp"}, {}, "area that the vortex pair loses in seven periods of the strain"},
      {{"standard K=1.2"}, {{"iterates", std::int64_t{3}}}, "flux across the strip of the standard map"}};
  operation.run = [steps = field_at(operation.result, "steps")](std::span<const Input> inputs, const Options& options,
                                                                const Context& context) {
    return run(inputs, options, context, steps);
  };
  return operation;
}

}  // namespace lober::detail::table

// The tangle of a system's manifolds, which are grown from its equations.
#include "lober/tangle/manifold_tangle.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

#include "engine/base/stopwatch.hpp"
#include "engine/operations/connection_choice.hpp"
#include "engine/operations/growth_options.hpp"
#include "engine/operations/lobe_fields.hpp"
#include "engine/operations/option_list.hpp"
#include "engine/operations/outcome_of.hpp"
#include "engine/operations/schema.hpp"
#include "engine/operations/system_of.hpp"
#include "engine/operations/table.hpp"
#include "engine/operations/tangle_fields.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

struct ManifoldsHow : ManifoldTangleOptions {
  std::optional<double> tolerance_given{}, seconds{};
  bool overlaps = false;
};

const OptionList<ManifoldsHow>& manifolds_options() {
  static const OptionList<ManifoldsHow> options = [] {
    using How = ManifoldsHow;
    OptionList<How> list;
    add_growth_options(list)
        .option("before", &How::before, "number of pre-images of the bip up to which manifolds are grown",
                {.min = 1, .max = 1000, .value = "N"})
        .option("after", &How::after, "number of images of the bip up to which manifolds are grown",
                {.min = 0, .max = 1000, .value = "N"})
        .option("smooth", &How::smooth, "whether to take the areas of smooth curves through the points")
        .option("max_iterates", &How::max_iterates, "maximum number of images of the local manifolds",
                {.min = 1, .max = 100'000, .value = "N"})
        .option("max_work", &How::max_work,
                "work that growing the manifolds may take, in evaluations of the vector field, where no time is given",
                {.min = 0, .above_min = true, .value = "N"})
        .option("budget", &How::seconds, "wall-clock time that growing the manifolds may take, in seconds",
                {.min = 0,
                 .above_min = true,
                 .otherwise = "a limit on the work instead, which gives the same result on every machine",
                 .value = "SECONDS"})
        .option("overlaps", &How::overlaps, "whether to compute the area that each pair of lobes has in common, too");
    return list;
  }();
  return options;
}

std::vector<Field> manifold_tangle_fields() {
  const auto manifolds = [](const SystemTangle& t) { return t.manifolds.get(); };
  const auto points = [](const GrownManifold& grown) {
    return std::vector<Point>(grown.points.begin(), grown.points.end());
  };
  Schema<SystemTangle> made;
  made.field("tolerance", "length", "tolerance that the manifolds were grown to in the end",
             [](const SystemTangle& t) { return t.manifolds->tolerance; })
      .object("saddles", "saddles of the tangle", saddles_schema(), manifolds)
      .field("reflection", "", "whether the map exchanges the branches of a saddle",
             [](const SystemTangle& t) { return t.manifolds->local_u.multiplier < 0; })
      .field("steps_of_image", "", "iterates of the map that make an image; 2 with reflection",
             [](const SystemTangle& t) { return std::abs(t.manifolds->local_u.image().steps); })
      .object("turnstile_by_action", "the lobes of the turnstile, by geometry and by action", turnstile_schema(),
              manifolds)
      .parts(lobes_schema(), [](const SystemTangle& t) -> const CurveTangle* { return &t; })
      .field("u", "length", "points of the unstable manifold",
             [points](const SystemTangle& t) { return points(t.manifolds->u); })
      .field("s", "length", "points of the stable manifold",
             [points](const SystemTangle& t) { return points(t.manifolds->s); });
  return made.fields();
}

Outcome run_manifold_tangle(std::span<const Input> inputs, const Options& options, const Context& context) {
  const System& system = *system_of(inputs).system;
  ManifoldsHow how = manifolds_options().how(options);
  const ConnectionChoice choice = connection_options().how(options);
  const Connection connection = chosen_connection(choice, system);
  how.tolerance = tolerance_in(system, how.tolerance_given);
  if (choice.bip) how.bip_near = choice.bip;
  if (how.seconds) how.budget = *how.seconds;
  constexpr std::size_t bytes_per_point = 240;  // two manifolds that are grown, and data made from them
  how.max_points = std::min(how.max_points, std::max<std::size_t>(context.memory / bytes_per_point, 1000));
  how.progress = context.progress;
  const Stopwatch watch;
  const std::shared_ptr<const ManifoldTangle> grown = grow_tangle(*system.map, connection, how);
  SystemTangle found{{grown->tangle}, grown};
  found.growth_seconds = watch.seconds();
  found.smooth = how.smooth;
  measure_lobes(found, how.overlaps);
  found.agreement = agreement_of(*grown);
  if (std::string remark = remark_on_boundary(*grown, system.lattice); !remark.empty())
    found.remarks.push_back(std::move(remark));
  Outcome outcome = outcome_of(std::move(found), options);
  outcome.chosen = settings_of(connection);
  outcome.chosen.push_back({"tolerance", how.tolerance});
  return outcome;
}

}  // namespace

Operation manifold_tangle_operation() {
  Operation operation;
  operation.name = "manifold_tangle";
  operation.revision = 8;  // sums of hidden areas in another order
  operation.title = "tangle of the manifolds of a system, grown from its equations";
  operation.summary =
      "Grows the unstable and the stable manifold of a system's saddles and finds their tangle: pips, lobes, boundary "
      "and "
      "turnstile, with areas by geometry and by action.";
  operation.inputs = {{"system", InputKind::system, "the system whose manifolds they are"}};
  operation.options = connection_options().specs();
  operation.options.insert(operation.options.end(), manifolds_options().specs().begin(),
                           manifolds_options().specs().end());
  operation.result = manifold_tangle_fields();
  operation.examples = {{{"standard K=1.2"}, {}, "of the fixed point of the standard map"},
                        {{"duffing"}, {{"after", std::int64_t{1}}}, "up to the image of the bip"}};
  operation.run = run_manifold_tangle;
  return operation;
}

}  // namespace lober::detail::table

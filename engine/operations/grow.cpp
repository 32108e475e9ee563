// A branch of a manifold of a saddle, grown from the equations.
#include <algorithm>
#include <cstdlib>

#include "engine/base/growth_forecast.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/operations/growth_fields.hpp"
#include "engine/operations/growth_options.hpp"
#include "engine/operations/option_list.hpp"
#include "engine/operations/outcome_of.hpp"
#include "engine/operations/schema.hpp"
#include "engine/operations/system_of.hpp"
#include "engine/operations/table.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/fixed_points.hpp"
#include "lober/dynamics/shifted_map.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

// An optional one takes the place of what GrowthOptions has for it.
struct GrowHow : GrowthOptions {
  GrowHow() { max_work = unasked_work; }
  ManifoldSide side = ManifoldSide::unstable;
  std::optional<Point> from{};
  std::optional<std::string> branch{};
  int period = 1, turns = 0;
  std::optional<std::int64_t> iterates{}, max_memory{};
  std::optional<double> tolerance_given{}, length{}, max_length{};
  std::optional<Rectangle> box{};
};

const OptionList<GrowHow>& grow_options() {
  static const OptionList<GrowHow> options = [] {
    OptionList<GrowHow> list;
    list.choice("side", &GrowHow::side, all_manifold_sides, "side of the saddle whose manifold is grown")
        .option("from", &GrowHow::from, "point near the saddle, in the coordinates of the map",
                {.otherwise = "the saddle of the system's tangle, or else the only saddle in the system's window"})
        .option("branch", &GrowHow::branch,
                "branch of the manifold; + leaves the saddle to the right, - to the left, or up and down if the "
                "tangent is vertical; or a vector X,Y roughly along it",
                {.otherwise = "the branch of the system's tangle, or else +", .value = "+|-|X,Y"})
        .option("period", &GrowHow::period, "least period of the saddle, in iterates of the map",
                {.min = 1, .max = 1000, .value = "P"});
    add_turns_option(list);
    add_tolerance_option(list, "maximum distance between the manifold and its polygon")
        .option("iterates", &GrowHow::iterates, "number of images of the local manifold after which growing ends",
                {.min = 0, .max = 100'000, .otherwise = "no limit, and there has to be a length", .value = "N"})
        .option(
            "length", &GrowHow::length,
            "arc length of the manifold, without parts outside the box, at which growing ends, in units of the "
            "coordinates",
            {.min = 0, .above_min = true, .otherwise = "no limit, and there have to be iterates", .value = "LENGTH"})
        .option(
            "max_length", &GrowHow::max_length, "maximum length of a segment, in units of the coordinates",
            {.min = 0, .above_min = true, .otherwise = "1/50 of the extent of the local manifold", .value = "LENGTH"})
        .option("box", &GrowHow::box,
                "corners of the box in which the tolerance holds; outside it the manifold is followed coarsely, and "
                "what comes back may be wrong or missing",
                {.otherwise = "a square around the saddle, 200 extents of the local manifold wide"})
        .option("max_points", &GrowHow::max_points, "maximum number of points, at which growing ends",
                {.min = 2, .value = "N"})
        .option("max_memory", &GrowHow::max_memory, "memory in bytes at which growing ends",
                {.min = 1, .otherwise = "no limit", .value = "BYTES"});
    return add_work_option(list);
  }();
  return options;
}

// ---------------------------------------------------------------------------------------------------------- result

Schema<LocalManifold> local_schema() {
  Schema<LocalManifold> made;
  made.field("saddle", "length", "saddle where the manifold begins", &LocalManifold::saddle)
      .field("tangent", "", "unit vector along it there", &LocalManifold::tangent)
      .field("multiplier", "", "factor by which the map, or its inverse, stretches the manifold at the saddle",
             &LocalManifold::multiplier)
      .field("reflection", "", "whether the map exchanges the branches",
             [](const LocalManifold& l) { return l.multiplier < 0; })
      .field("steps_of_image", "", "iterates of the map that take a branch to itself",
             [](const LocalManifold& l) { return std::abs(l.image().steps); })
      .field("degree", "", "degree of the polynomial near the saddle",
             [](const LocalManifold& l) { return l.coefficients.size() - 1; })
      .field("reach", "length", "parameter up to which the polynomial is used", &LocalManifold::reach)
      .field("defect", "length", "largest distance of the polynomial from its image", &LocalManifold::defect)
      .field("defect_across", "length", "largest distance across the curve", &LocalManifold::defect_across);
  return made;
}

Schema<GrownManifold> growth_schema() {
  Schema<GrownManifold> made;
  made.field("points", "", "number of points", [](const GrownManifold& m) { return m.points.size(); })
      .field("length", "length", "length of the polygon, without parts outside the box", &GrownManifold::length)
      .field("iterates", "", "images of the local manifold",
             [](const GrownManifold& m) { return m.generation_begin.size() - 2; })
      .field("stop", "", "why growing ended: iterates, length, points, work, ended or failed",
             [](const GrownManifold& m) { return std::string(name(m.stop)); })
      .field("generations", "", "first point of each image of the local manifold",
             [](const GrownManifold& m) {
               return std::vector<std::int64_t>(m.generation_begin.begin(), m.generation_begin.end() - 1);
             })
      .field("images", "", "steps of the map that were taken", &GrownManifold::images);
  return made;
}

std::vector<Field> grow_fields() {
  using Grown = SystemManifold;
  Schema<Grown> made;
  made.object("local_manifold", "near the saddle", local_schema(), &Grown::local)
      .object("result", "the grown manifold", growth_schema(),
              [](const Grown& g) -> const GrownManifold* { return &g; })
      .object("diagnostics", "segments that do not meet the tolerance", diagnostics_schema<GrownManifold>(),
              [](const Grown& g) -> const GrownManifold* { return &g; })
      .field("points", "length", "points of the polygon, from the saddle on",
             [](const Grown& g) { return std::vector<Point>(g.points.begin(), g.points.end()); })
      .field("parameters", "",
             "parameter of each point, the image of the local manifold there by the iterates of its generation",
             [](const Grown& g) { return std::vector<double>(g.parameters.begin(), g.parameters.end()); })
      .not_in_json();
  return made.fields();
}

// ------------------------------------------------------------------------------------------------------------- run

// Whether it is the manifold of the tangle that the system is known for.
bool is_of_tangle(const GrowHow& how, const System& system) {
  return !how.from && how.period == 1 && how.turns == 0 && system.connection;
}

Point saddle_of(const GrowHow& how, const System& system) {
  if (how.from) return *how.from;
  if (is_of_tangle(how, system)) return system.connection->saddle(how.side);
  std::vector<Point> saddles;
  std::string positions;
  const FixedPointOptions wanted{.period = how.period, .turns = how.turns, .lattice = system.lattice};
  for (const FixedPoint& point : find_fixed_points(*system.map, system.window, wanted)) {
    const bool is_saddle = point.kind == FixedPointKind::saddle || point.kind == FixedPointKind::inverse_saddle ||
                           point.kind == FixedPointKind::reversing_saddle;
    if (!is_saddle || point.period != how.period) continue;
    saddles.push_back(point.at);
    positions += (positions.empty() ? "" : ", ") + to_string(OptionValue(point.at));
  }
  if (saddles.empty()) {
    const bool repeats = !(system.lattice == Point{});
    throw DataError("system " + system.info.name + ": no saddle of least period " + std::to_string(how.period) +
                    (repeats ? " that moves by " + std::to_string(how.turns) + " turns" : "") +
                    " was found in its window; give a point near one by option \"from\"" +
                    (repeats ? ", or other turns" : ""));
  }
  if (saddles.size() > 1) {
    throw UsageError("system " + system.info.name +
                     " has several saddles; choose one by option \"from\": " + positions);
  }
  return saddles.front();
}

Branch branch_of(const GrowHow& how, const System& system, const LocalManifold& local) {
  if (!how.branch) {
    return is_of_tangle(how, system) ? branch_towards(local, system.connection->direction(how.side)) : Branch::plus;
  }
  if (*how.branch == "+" || *how.branch == "plus") return Branch::plus;
  if (*how.branch == "-" || *how.branch == "minus") return Branch::minus;
  Point towards;  // 0,0 has no direction
  try {
    const OptionSpec vector{"branch", Point{}};
    towards = std::get<Point>(option_value(vector, "branch", *how.branch));
  } catch (const UsageError&) {
    towards = {};
  }
  if (towards == Point{}) {
    throw UsageError("a branch is +, - or a vector roughly along it, X,Y; not \"" + *how.branch + "\"");
  }
  return branch_towards(local, towards);
}

// The fraction of the growth that is done, as far as it can be known: by the length, and by the cost of the iterates so
// far.
class GrowthFraction {
 public:
  explicit GrowthFraction(const GrowthOptions& options) : options_(options) {}

  double operator()(const GrowthProgress& progress) {
    const auto images = static_cast<double>(progress.images);
    if (progress.iterates > iterates_) {
      cost_.add(std::max(images - begin_, 1.0));
      begin_ = images;
      iterates_ = progress.iterates;
    }
    const double by_length = progress.length / options_.length;
    double by_iterates = 0;
    if (options_.iterates > 0 && cost_.count() > 1) {
      by_iterates = images / std::max(begin_ + cost_.sum(options_.iterates - iterates_), images);
    }
    return std::clamp(std::max(by_length, by_iterates), 0.0, 1.0);
  }

 private:
  const GrowthOptions& options_;
  GrowthForecast cost_;  // images of points, iterate by iterate
  double begin_ = 0;     // begin of the present iterate
  int iterates_ = 0;
};

GrowthOptions growth_of(const GrowHow& how, const Context& context) {
  if (!how.iterates && !how.length) {
    throw UsageError("iterates or length has to be given: manifolds do not end");
  }
  const GrowthOptions& given = how;
  GrowthOptions options = given;
  if (how.iterates) options.iterates = static_cast<int>(*how.iterates);
  options.length = how.length.value_or(options.length);
  options.max_length = how.max_length.value_or(options.max_length);
  options.box = how.box.value_or(options.box);
  options.max_memory = context.memory;
  if (how.max_memory) options.max_memory = std::min(options.max_memory, static_cast<std::size_t>(*how.max_memory));
  return options;
}

// Why less came than was asked for.
std::string incomplete(const GrownManifold& grown) {
  const std::string begin = "the manifold ends early, with " + std::to_string(grown.points.size()) + " points, since ";
  if (grown.stop == GrowthStop::points) return begin + "max_points allows no more; give a larger max_points";
  if (grown.stop == GrowthStop::work) return begin + "max_work allows no more; give a larger max_work";
  if (grown.stop == GrowthStop::failed) return begin + "no point has an image near by";
  return {};
}

Outcome run_grow(std::span<const Input> inputs, const Options& options, const Context& context) {
  const System& system = *system_of(inputs).system;
  const GrowHow how = grow_options().how(options);
  GrowthOptions growth = growth_of(how, context);
  growth.tolerance = tolerance_in(system, how.tolerance_given);
  const Stopwatch watch;
  LocalManifoldOptions near;
  near.period = how.period;
  const ShiftedMap up_to_turns(*system.map, how.period, shift_by(how.turns, system));
  const PlanarMap& map = how.turns == 0 ? *system.map : up_to_turns;
  LocalManifold local = local_manifold(map, saddle_of(how, system), how.side, near);
  const Branch branch = branch_of(how, system, local);
  const double local_seconds = watch.seconds();
  GrowthFraction fraction(growth);
  if (context.progress) {
    growth.progress = [&](const GrowthProgress& at) {
      if (context.count) context.count(static_cast<double>(at.points), "points");
      return context.progress(fraction(at),
                              std::to_string(at.iterates) + " iterates, " + std::to_string(at.points) + " points");
    };
  }
  SystemManifold found{grow(map, local, branch, growth)};
  found.local = std::move(local);
  found.branch = branch;
  found.local_seconds = local_seconds;
  found.growth_seconds = watch.seconds() - local_seconds;
  if (found.stop == GrowthStop::cancelled && !context.keeps_what_is_known) throw Cancelled();
  const std::string why = incomplete(found);
  Outcome outcome = outcome_of(std::move(found), options);
  outcome.incomplete = why;
  outcome.chosen = {{"branch", branch == Branch::plus ? "+" : "-"}, {"tolerance", growth.tolerance}};
  return outcome;
}

}  // namespace

Operation grow_operation() {
  Operation operation;
  operation.name = "grow";
  operation.revision = 6;  // lengths and numbers of points asked for are kept to
  operation.title = "a branch of the stable or unstable manifold of a saddle";
  operation.summary =
      "Grows a branch of the stable or unstable manifold of a saddle of a map, or of a flow's Poincare map, to a "
      "tolerance.";
  operation.inputs = {{"system", InputKind::system, "the system whose manifold it is"}};
  operation.options = grow_options().specs();
  operation.result = grow_fields();
  operation.examples = {{{"henon"}, {{"side", "stable"}, {"length", 30.0}}, "thirty units of its stable manifold"},
                        {{"standard K=1.2"}, {{"side", "unstable"}, {"iterates", std::int64_t{8}}}, "eight iterates"}};
  operation.compares = false;
  operation.run = run_grow;
  return operation;
}

}  // namespace lober::detail::table

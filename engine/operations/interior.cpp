// The areas of two curves by way of the interior function.
#include "lober/overlay/interior.hpp"

#include "engine/base/stopwatch.hpp"
#include "engine/operations/curve_fields.hpp"
#include "engine/operations/curve_of.hpp"
#include "engine/operations/option_list.hpp"
#include "engine/operations/outcome_of.hpp"
#include "engine/operations/schema.hpp"
#include "engine/operations/table.hpp"
#include "engine/operations/underflow_remark.hpp"
#include "lober/base/error.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

struct InteriorHow : InteriorOptions {
  bool verify = false;
};

const OptionList<InteriorHow>& interior_options() {
  static const OptionList<InteriorHow> options = [] {
    OptionList<InteriorHow> list;
    list.choice("method", &InteriorHow::method, all_interior_methods,
                "way in which segments are weighted; split: at the points where the curves meet; ends: by their two "
                "ends, as Lober 1.8 does")
        .option("passes", &InteriorHow::passes,
                "number of passes that insert points where the ends of a segment differ; with ends",
                {.min = 0, .max = 1'000'000, .value = "P"})
        .option("points", &InteriorHow::points, "number of points that a pass inserts into such a segment; with ends",
                {.min = 0, .max = 1'000'000, .value = "N"});
    add_index_option(list)
        .option("check_simple", &InteriorHow::check_simple, "whether to refuse curves that are not simple")
        .option("verify", &InteriorHow::verify,
                "whether to compute the areas by the overlay too, and report how far the two results differ");
    return list;
  }();
  return options;
}

Schema<CurveInterior> interior_error() {
  Schema<CurveInterior> made;
  const auto known = [](const std::optional<Areas>& areas) { return areas ? &*areas : nullptr; };
  made.object("rounding",
              "bounds on the rounding of the sums in double-double; with split, on |area - exact area of the polygons|",
              areas_schema(), &CurveInterior::rounding)
      .object("splitting", "|area - area with segments split where the curves meet|; with ends", areas_schema(),
              [known](const CurveInterior& i) { return known(i.splitting); })
      .if_asked_for()
      .object("consistency", "|area - area by the overlay|; with verify", areas_schema(),
              [known](const CurveInterior& i) { return known(i.consistency); })
      .if_asked_for();
  return made;
}

std::vector<Field> interior_fields() {
  Schema<InteriorStatistics> statistics;
  statistics.parts(search_schema<InteriorStatistics>(), [](const InteriorStatistics& s) { return &s; })
      .field("arcs", "", "parts that the curves were split into", &InteriorStatistics::arcs)
      .field("queries", "", "winding numbers that were computed", &InteriorStatistics::queries)
      .field("points_inserted", "", "points inserted by passes and points", &InteriorStatistics::points_inserted);
  Schema<CurveInterior> made;
  made.object("crossings", "where the curves meet", meetings_schema(), &CurveInterior::nodes)
      .field("q1", "area", "Q1, the symmetric difference", &CurveInterior::q1)
      .field("q2", "area", "Q2, the union", &CurveInterior::q2)
      .field("q3", "area", "Q3, the intersection", &CurveInterior::q3)
      .object("areas", "areas of the polygons", areas_schema(), &CurveInterior::areas)
      .field("delta", "area", "1/4 |Q2 - Q3 - Q1|, zero by algebra: the rounding of the three sums",
             &CurveInterior::delta)
      .object("error", "error bars of the areas", interior_error(), [](const CurveInterior& i) { return &i; })
      .object("statistics", "work that was done", statistics, &CurveInterior::statistics);
  add_orientations(made);
  return made.fields();
}

Outcome run_interior(std::span<const Input> inputs, const Options& options, const Context& context) {
  const Operation& operation = named("interior");
  const IndexedCurve c1 = indexed_curve(operation, inputs, 0), c2 = indexed_curve(operation, inputs, 1);
  InteriorHow how = interior_options().how(options);
  if (how.method == InteriorMethod::split && (how.passes > 0 || how.points > 0)) {
    throw UsageError("option \"passes\" and option \"points\" need the method ends");
  }
  how.progress = context.progress;
  if (known_simple(inputs, 0) && known_simple(inputs, 1)) how.check_simple = false;
  CurveInterior found{interior_areas(c1, c2, how)};
  if (how.method == InteriorMethod::ends) {
    InteriorOptions split = static_cast<const InteriorOptions&>(how);
    split.method = InteriorMethod::split;
    split.check_simple = false;
    split.progress = {};
    found.splitting = distance(found.areas, interior_areas(c1, c2, split).areas);
  }
  if (how.verify) {
    const Stopwatch watch;
    OverlayOptions areas_only;
    areas_only.pieces = areas_only.check_simple = false;
    const Overlay other = overlay(c1, c2, areas_only);
    found.consistency = distance(found.areas, other.areas);
    compare_areas(found.agreement, "interior", "overlay", found.areas, other.areas,
                  sum(sum(found.rounding, other.rounding), found.splitting.value_or(Areas{})));
    found.verify_seconds = watch.seconds();
  }
  const Areas areas = found.areas, rounding = found.rounding;
  Outcome outcome = outcome_of(std::move(found), options);
  remark_on_underflow(areas, rounding, outcome);
  return outcome;
}

}  // namespace

Operation interior_operation() {
  Operation operation;
  operation.name = "interior";
  operation.title = "areas of two closed curves by the interior function, Q1, Q2 and Q3";
  operation.summary =
      "Computes the areas of two simple closed curves by the interior function (Q1, Q2, Q3), independently of the "
      "overlay.";
  operation.inputs = {{"c1", InputKind::closed_curve, "a simple closed curve"},
                      {"c2", InputKind::closed_curve, "another one"}};
  operation.options = interior_options().specs();
  operation.result = interior_fields();
  operation.examples = {
      {{"examples/resonance.dat", "examples/resonance_image.dat"}, {}, "a resonance and its image"},
      {{"examples/resonance.dat", "examples/resonance_image.dat"}, {{"verify", true}}, "and by the overlay"}};
  operation.run = run_interior;
  return operation;
}

}  // namespace lober::detail::table

// Regions of curves that may cross themselves.
#include "lober/overlay/regions.hpp"

#include "engine/operations/curve_fields.hpp"
#include "engine/operations/curve_of.hpp"
#include "engine/operations/option_list.hpp"
#include "engine/operations/outcome_of.hpp"
#include "engine/operations/schema.hpp"
#include "engine/operations/table.hpp"
#include "engine/operations/underflow_remark.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

struct RegionsHow : RegionOptions {
  FillRule rule = FillRule::nonzero;
  bool areas_only = false;
};

const OptionList<RegionsHow>& region_options() {
  static const OptionList<RegionsHow> options = [] {
    OptionList<RegionsHow> list;
    list.choice("rule", &RegionsHow::rule, all_fill_rules, "rule that says which winding numbers are inside")
        .option("areas_only", &RegionsHow::areas_only,
                "whether to compute the total areas but not the pieces, which is faster");
    add_index_option(list);
    return list;
  }();
  return options;
}

Schema<RegionCounts> arrangement_schema() {
  Schema<RegionCounts> meetings;
  meetings.field("c1", "", "pairs of C1 with itself", &RegionCounts::self1)
      .field("c2", "", "pairs of C2 with itself", &RegionCounts::self2)
      .field("c1_c2", "", "pairs of C1 with C2", &RegionCounts::mutual);
  Schema<RegionCounts> made;
  made.field("nodes", "", "points where edge chains meet or a spike ends", &RegionCounts::nodes)
      .field("edges", "", "edge chains between nodes, those that coincide counted once", &RegionCounts::edges)
      .field("faces", "", "faces, the unbounded one included", &RegionCounts::faces)
      .object("meetings", "pairs of edge chains that meet in a point", meetings,
              [](const RegionCounts& c) { return &c; });
  return made;
}

Schema<RegionCounts> regions_statistics() {
  Schema<RegionCounts> skipped;
  skipped.field("blocks", "", "blocks of the curves whose box meets nothing",
                [](const RegionCounts& c) { return c.search.blocks_skipped; });
  Schema<RegionCounts> made;
  made.field("index", "", "index used for C1 against C2",
             [](const RegionCounts& c) { return std::string(name(c.index)); })
      .field("boxes_tested", "", "pairs of boxes", [](const RegionCounts& c) { return c.search.boxes_tested; })
      .field("pairs_tested", "", "pairs of segments that the index proposed",
             [](const RegionCounts& c) { return c.search.pairs_proposed; })
      .field("filter_failures", "", "signs that doubles could not decide",
             [](const RegionCounts& c) { return c.predicates.filter_failures; })
      .field("exact_calls", "", "signs that took exact arithmetic",
             [](const RegionCounts& c) { return c.predicates.exact_calls; })
      .field("exact_parameters", "", "crossings whose position took exact arithmetic", &RegionCounts::exact_parameters)
      .field("exact_orders", "", "pairs of crossings that were ordered in exact arithmetic",
             &RegionCounts::exact_orders)
      .object("skipped", "parts that were not looked at", skipped, [](const RegionCounts& c) { return &c; });
  return made;
}

Schema<CurveRegions> region_pieces() {
  Schema<RegionPiece> piece;
  piece.field("area", "area", "area of the piece", &RegionPiece::area)
      .field("holes", "", "number of its holes", &RegionPiece::holes);
  Schema<CurveRegions> made;
  for (const Pairing pairing : all_pairings) {
    made.list(std::string(name(pairing)), "connected components, in the order of their faces along C1, then C2", piece,
              [pairing](const CurveRegions& r) -> const RegionPieces& {
                return (*r.pieces)[static_cast<std::size_t>(pairing)];
              });
  }
  return made;
}

Schema<CurveRegions> signed_schema() {
  Schema<CurveRegions> made;
  made.field("c1", "area", "signed area of C1", [](const CurveRegions& r) { return r.regions.signed_areas()[0]; })
      .field("c2", "area", "signed area of C2", [](const CurveRegions& r) { return r.regions.signed_areas()[1]; });
  return made;
}

std::vector<Field> region_fields() {
  Schema<WindingArea> winding;
  winding.field("c1", "", "winding number of C1", &WindingArea::w1)
      .field("c2", "", "winding number of C2", &WindingArea::w2)
      .field("area", "area", "area of the points with these winding numbers", &WindingArea::area);
  Schema<CurveRegions> error;
  error.object("rounding", "bounds on |area - exact area of the region of the polygons as given|", areas_schema(),
               &CurveRegions::rounding);
  const auto counts = [](const CurveRegions& r) { return r.regions.counts(); };
  Schema<CurveRegions> made;
  made.field("rule", "", "rule that says which winding numbers are inside",
             [](const CurveRegions& r) { return std::string(name(r.rule)); })
      .object("arrangement", "arrangement of both curves", arrangement_schema(), counts)
      .list("winding", "pairs of winding numbers that occur", winding,
            [](const CurveRegions& r) -> std::span<const WindingArea> { return r.regions.table(); })
      .object("signed_areas", "sums of winding number times area", signed_schema(),
              [](const CurveRegions& r) { return &r; })
      .field("q1", "area", "Q1, the symmetric difference",
             [](const CurveRegions& r) { return r.areas.symmetric_difference; })
      .field("q2", "area", "Q2, the union", [](const CurveRegions& r) { return r.areas.union_; })
      .field("q3", "area", "Q3, the intersection", [](const CurveRegions& r) { return r.areas.intersection; })
      .object("areas", "areas by the rule", areas_schema(), &CurveRegions::areas)
      .object("pieces", "pieces of each pairing, where they were asked for", region_pieces(),
              [](const CurveRegions& r) { return r.pieces ? &r : nullptr; })
      .if_asked_for()
      .object("error", "error bars of the areas", error, [](const CurveRegions& r) { return &r; })
      .object("statistics", "work that was done", regions_statistics(), counts);
  return made.fields();
}

Outcome run_regions(std::span<const Input> inputs, const Options& options, const Context& context) {
  const Operation& operation = named("regions");
  RegionsHow how = region_options().how(options);
  how.progress = context.progress;
  const IndexedCurve c1 = indexed_curve(operation, inputs, 0);
  CurveRegions found;
  found.rule = how.rule;
  found.regions = inputs.size() == 1 ? regions(c1, how) : regions(c1, indexed_curve(operation, inputs, 1), how);
  found.areas = found.regions.areas(how.rule);
  found.rounding = found.regions.rounding(how.rule);
  if (!how.areas_only) {
    found.pieces.emplace();
    for (const Pairing pairing : all_pairings) {
      (*found.pieces)[static_cast<std::size_t>(pairing)] = found.regions.pieces(how.rule, pairing);
    }
  }
  const Areas areas = found.areas, rounding = found.rounding;
  Outcome outcome = outcome_of(std::move(found), options);
  remark_on_underflow(areas, rounding, outcome);
  return outcome;
}

}  // namespace

Operation regions_operation() {
  Operation operation;
  operation.name = "regions";
  operation.title = "areas and pieces of one or two closed curves that may cross themselves";
  operation.summary =
      "Computes the area of each pair of winding numbers of one or two closed curves, which may cross themselves, and "
      "the areas and pieces that a rule makes of them.";
  operation.inputs = {{"c1", InputKind::closed_curve, "a closed curve"},
                      {"c2", InputKind::closed_curve, "another one", true}};
  operation.options = region_options().specs();
  operation.result = region_fields();
  operation.examples = {
      {{"examples/resonance.dat", "examples/resonance_image.dat"}, {{"rule", "evenodd"}}, "by the even-odd rule"},
      {{"examples/loops.csv"}, {}, "the areas of one curve by winding number"}};
  operation.run = run_regions;
  return operation;
}

}  // namespace lober::detail::table

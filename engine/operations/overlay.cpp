// The overlay of two closed curves.
#include "lober/overlay/overlay.hpp"

#include <cmath>
#include <optional>

#include "engine/base/stopwatch.hpp"
#include "engine/operations/curve_fields.hpp"
#include "engine/operations/curve_of.hpp"
#include "engine/operations/option_list.hpp"
#include "engine/operations/outcome_of.hpp"
#include "engine/operations/overlay_fields.hpp"
#include "engine/operations/table.hpp"
#include "engine/operations/underflow_remark.hpp"
#include "lober/overlay/interior.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

struct OverlayHow : OverlayOptions {
  bool areas_only = false, discretisation = true, verify = false, smooth = false, classes = false;
};

const OptionList<OverlayHow>& overlay_options() {
  static const OptionList<OverlayHow> options = [] {
    OptionList<OverlayHow> list;
    list.option("areas_only", &OverlayHow::areas_only,
                "whether to compute the total areas but not the pieces, which is faster")
        .option("discretisation", &OverlayHow::discretisation,
                "whether to estimate how far areas of polygons are from those between smooth curves");
    add_index_option(list)
        .option("check_simple", &OverlayHow::check_simple, "whether to refuse curves that are not simple")
        .option("verify", &OverlayHow::verify,
                "whether to compute the areas by the interior method too, and report how far the two results differ")
        .option("smooth", &OverlayHow::smooth,
                "whether to compute the areas between smooth curves through the points too, with error bars")
        .option("classes", &OverlayHow::classes,
                "whether to compute rho, A, gamma, sigma, class and S of every crossing, for C1 \\ C2 and C2 \\ C1 "
                "(Naik, Lekien & Ross 2017, Tables 1 to 4)");
    return list;
  }();
  return options;
}

// The estimate of the discretisation is right to the leading order only: on coarse curves smooth ones through the
// points tell more. Of 690 pairs, half of them coarse, none exceeded four times the estimate.
void compare_with_smooth(CurveOverlay& found) {
  const Areas estimate = found.discretisation.value_or(discretisation_error(found));
  compare_areas(found.agreement, "polygons", "smooth curves", found.areas, found.smooth->areas,
                sum(sum(found.rounding, scaled(4, estimate)), found.smooth->error));
  if (found.discretisation) found.discretisation = larger(estimate, distance(found.smooth->areas, found.areas));
}

// Half the sum of S is the area, whatever the origin. Crossings are rounded there, which moves the boundary by an ulp
// of the coordinates over two segments at most.
void add_classes(CurveOverlay& found) {
  found.steps = {sigma_steps(found, Pairing::c1_minus_c2), sigma_steps(found, Pairing::c2_minus_c1)};
  if (found.nodes.crossings() == 0) return;  // then no class has an area
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    double sum = 0, size = 0;
    for (const SigmaStep& step : (*found.steps)[k]) {
      sum += 0.5 * step.s;
      size += std::fabs(step.s);
    }
    const double moved =
        static_cast<double>(found.nodes.crossings()) * found.largest_coordinate * found.longest_segment;
    const double additions = static_cast<double>((*found.steps)[k].size() + 4) * size;
    found.agreement.compare({k == 0 ? "area of C1 \\ C2" : "area of C2 \\ C1", "overlay", "half the sum of S",
                             k == 0 ? found.areas.c1_minus_c2 : found.areas.c2_minus_c1, sum,
                             0x1p-51 * (moved + additions)});
  }
}

Outcome run_overlay(std::span<const Input> inputs, const Options& options, const Context& context) {
  const Operation& operation = named("overlay");
  std::optional<Stopwatch> index_watch;  // short jobs, whose curves are indexed, save the look at the clock
  if (!is_indexed(inputs, 0) || !is_indexed(inputs, 1)) index_watch.emplace();
  const IndexedCurve c1 = indexed_curve(operation, inputs, 0), c2 = indexed_curve(operation, inputs, 1);
  const double index_seconds = index_watch ? index_watch->seconds() : 0;
  OverlayHow how = overlay_options().how(options);
  how.pieces = !how.areas_only;
  how.progress = context.progress;
  const bool known = known_simple(inputs, 0) && known_simple(inputs, 1), unchecked = !known && !how.check_simple;
  if (known) how.check_simple = false;
  CurveOverlay found{overlay(c1, c2, how)};
  found.has_pieces = how.pieces;
  found.timing.index += index_seconds;
  found.timing.total += index_seconds;
  if (how.discretisation) {
    const DiscretisationSums *const first = known_sums(inputs, 0), *const second = known_sums(inputs, 1);
    found.discretisation = first != nullptr && second != nullptr ? discretisation_error(found, *first, *second)
                                                                 : discretisation_error(found);
  }
  if (how.verify) {
    const Stopwatch watch;
    const InteriorAreas other = interior_areas(c1, c2, {.index = how.index, .check_simple = false});
    found.consistency = distance(found.areas, other.areas);
    compare_areas(found.agreement, "overlay", "interior", found.areas, other.areas,
                  sum(found.rounding, other.rounding));
    found.verify_seconds = watch.seconds();
  }
  if (how.classes) add_classes(found);
  if (how.smooth) {
    const Stopwatch watch;
    found.smooth = smooth_areas(found);
    compare_with_smooth(found);
    found.smooth_seconds = watch.seconds();
  }
  const Areas areas = found.areas, rounding = found.rounding;
  Outcome outcome = outcome_of(std::move(found), options);
  if (unchecked) {
    outcome.remarks.emplace_back(
        "it was not checked whether the curves are simple: where one crosses itself, areas and pieces mean nothing, "
        "and error bars hold for neither");
  }
  remark_on_underflow(areas, rounding, outcome);
  return outcome;
}

}  // namespace

Operation overlay_operation() {
  Operation operation;
  operation.name = "overlay";
  operation.revision = 5;  // sums of hidden areas in another order
  operation.title = "crossings, lobes and areas of two closed curves";
  operation.summary =
      "Computes where two simple closed curves cross, the pieces of their differences, intersection and union, and all "
      "areas with error bars.";
  operation.inputs = {{"c1", InputKind::closed_curve, "a simple closed curve"},
                      {"c2", InputKind::closed_curve, "another one"}};
  operation.options = overlay_options().specs();
  operation.result = overlay_fields();
  operation.examples = {
      {{"examples/resonance.dat", "examples/resonance_image.dat"}, {}, "a resonance and its image"},
      {{"examples/resonance.dat", "examples/resonance_image.dat"}, {{"verify", true}}, "and by the interior function"}};
  operation.run = run_overlay;
  return operation;
}

}  // namespace lober::detail::table

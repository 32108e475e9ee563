// The tangle of two manifolds that are given as curves.
#include "lober/tangle/tangle.hpp"

#include <string>
#include <utility>

#include "engine/operations/curve_of.hpp"
#include "engine/operations/curves_tangle.hpp"
#include "engine/operations/lobe_fields.hpp"
#include "engine/operations/option_list.hpp"
#include "engine/operations/outcome_of.hpp"
#include "engine/operations/table.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

struct TangleHow : CurvesHow {
  bool overlaps = false;
};

const OptionList<TangleHow>& tangle_options() {
  static const OptionList<TangleHow> options = [] {
    using How = TangleHow;
    OptionList<How> list;
    add_curves_options(list)
        .option(
            "smooth", &How::smooth,
            "whether to compute the pips and areas of smooth curves through the points, with error bars, instead of "
            "those of the polygons")
        .option("overlaps", &How::overlaps, "whether to compute the area that each pair of lobes has in common, too");
    add_index_option(list).option("check_simple", &How::check_simple,
                                  "whether to refuse manifolds that cross or touch themselves");
    return list;
  }();
  return options;
}

// The area of each lobe against that of its image, where the period was inferred, which supposes that the map preserves
// area. Nothing where it was given: then nothing is known of the map.
void compare_images(CurveTangle& found) {
  const Images& images = found.images;
  if (images.given || images.period == 0) return;
  for (std::size_t k = 0; k + images.period < found.lobes.size(); ++k) {
    const std::size_t image = k + images.period;
    const double area = found.lobes[k].area, next = found.lobes[image].area;
    found.agreement.compare(
        {"area of lobe " + std::to_string(k), "itself", "its image under the map, lobe " + std::to_string(image), area,
         next, found.rounding(area) + found.rounding(next) + found.discretisation(k) + found.discretisation(image)});
  }
}

Outcome run_tangle(std::span<const Input> inputs, const Options& options, const Context& context) {
  const Operation& operation = named("tangle");
  TangleHow how = tangle_options().how(options);
  CurveTangle found{tangle_of_curves(operation, inputs, how, context)};
  found.smooth = how.smooth;
  measure_lobes(found, how.overlaps);
  compare_images(found);
  if (std::string remark = remark_on_boundary(found); !remark.empty()) found.remarks.push_back(std::move(remark));
  return outcome_of(std::move(found), options);
}

}  // namespace

Operation tangle_operation() {
  Operation operation;
  operation.name = "tangle";
  operation.revision = 5;  // sums of hidden areas in another order
  operation.title = "pips, lobes, boundary and turnstile of an unstable and a stable manifold";
  operation.summary =
      "Finds the tangle of two manifolds, which are given as curves: primary intersection points, lobes, boundary and "
      "turnstile, with areas and error bars.";
  operation.inputs = manifold_inputs();
  operation.options = tangle_options().specs();
  operation.result = lobes_schema().fields();
  operation.examples = {{{"examples/manifolds.dat#0", "examples/manifolds.dat#1"},
                         {{"smooth", true}},
                         "of smooth curves through the points"},
                        {{"examples/manifolds.dat#0", "examples/manifolds.dat#1"},
                         {{"overlaps", true}},
                         "and what lobes have in common"}};
  operation.run = run_tangle;
  return operation;
}

}  // namespace lober::detail::table

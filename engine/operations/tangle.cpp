// The tangle of two manifolds that are given as curves.
#include "lober/tangle.hpp"

#include "engine/operations/curve_of.hpp"
#include "engine/operations/lobe_fields.hpp"
#include "engine/operations/table.hpp"
#include "lober/error.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

// Some take the place of what TangleOptions has for them.
struct TangleHow : TangleOptions {
  std::optional<std::int64_t> bip_number{}, period_given{};
  std::optional<std::vector<double>> closure_corners{};
  bool overlaps = false;
};

const OptionList<TangleHow>& tangle_options() {
  static const OptionList<TangleHow> options = [] {
    using How = TangleHow;
    OptionList<How> list;
    list.option("bip", &How::bip_number,
                "number of the boundary intersection point, the pip at which the boundary passes from U to S, from 0",
                {.min = 0, .max = 4e9, .otherwise = "that nearest to bip_near, or the middle one", .value = "K"})
        .option("period", &How::period_given,
                "number of pips from one to its image, at most that of lobes, even where lobes alternate",
                {.min = 1, .max = 1'000'000, .otherwise = "inferred from the areas", .value = "P"})
        .option("bip_near", &How::bip_near, "point near it", {.otherwise = "none", .value = "X,Y"})
        .option("closure", &How::closure_corners,
                "corners of the path that closes the boundary, from the fixed point of S to that of U",
                {.otherwise = "the straight line", .value = "X1,Y1,X2,Y2,..."})
        .option(
            "smooth", &How::smooth,
            "whether to compute the pips and areas of smooth curves through the points, with error bars, instead of "
            "those of the polygons")
        .option("overlaps", &How::overlaps, "whether to compute the area that each pair of lobes has in common, too")
        .choice("index", &How::index, all_index_kinds,
                "index that proposes which segments can meet; the results do not depend on it")
        .option("check_simple", &How::check_simple, "whether to refuse manifolds that cross or touch themselves");
    return list;
  }();
  return options;
}

TangleHow how_of(const Options& options) {
  TangleHow how = tangle_options().how(options);
  if (how.bip_number) how.bip = static_cast<std::size_t>(*how.bip_number);
  if (how.period_given) how.period = static_cast<std::uint32_t>(*how.period_given);
  if (!how.closure_corners) return how;
  const std::vector<double>& numbers = *how.closure_corners;
  if (numbers.size() % 2 != 0) throw UsageError("option \"closure\" needs two coordinates of each corner");
  for (std::size_t k = 0; k < numbers.size(); k += 2) how.closure.push_back({numbers[k], numbers[k + 1]});
  return how;
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
  require_inputs(operation, inputs);
  TangleHow how = how_of(options);
  how.progress = fraction_to(context);
  if (known_simple(inputs, 0) && known_simple(inputs, 1)) how.check_simple = false;
  CurveTangle found{tangle(indexed_curve(operation, inputs, 0), indexed_curve(operation, inputs, 1), how)};
  found.smooth = how.smooth;
  if (!found.images.misfit.empty()) throw UsageError("option \"period\": " + found.images.misfit);
  measure_lobes(found, how.overlaps);
  compare_images(found);
  return outcome_of(std::move(found), options);
}

}  // namespace

Operation tangle_operation() {
  Operation operation;
  operation.name = "tangle";
  operation.title = "pips, lobes, boundary and turnstile of an unstable and a stable manifold";
  operation.summary =
      "Finds the tangle of two manifolds, which are given as curves: primary intersection points, lobes, boundary and "
      "turnstile, with areas and error bars.";
  operation.inputs = {{"u", InputKind::open_curve, "the unstable manifold, outward from its fixed point"},
                      {"s", InputKind::open_curve, "the stable manifold, likewise"}};
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

// `tangle`: pips, lobes, boundary and turnstile of an unstable (first) and a stable manifold.
#include "lober/tangle.hpp"

#include <cmath>

#include "engine/batch/operations/table.hpp"
#include "lober/error.hpp"

namespace lober::detail {
namespace {

TangleOptions tangle_options(const Options& options) {
  TangleOptions how;
  how.index = index_kind(options);
  if (options.whole("bip") >= 0) how.bip = static_cast<std::size_t>(options.whole("bip"));
  how.period = static_cast<std::uint32_t>(options.whole("period"));
  how.smooth = options.flag("smooth");
  how.check_simple = false;  // done when the curve was read
  return how;
}

Result run_tangle(JobCurves curves, const Options& options) {
  const Tangle found = tangle(curves[0]->index(), curves[1]->index(), tangle_options(options));
  if (!found.images.misfit.empty()) throw DataError("tangle: " + found.images.misfit);
  Result record;
  const auto real = [&](double value) { record.values.push_back(value); };
  const auto count = [&](std::size_t number) { real(static_cast<double>(number)); };
  const bool bounded = found.boundary.has_value(), paired = found.images.period != 0;
  count(found.nodes.crossings());
  count(found.nodes.touches());
  count(found.nodes.shared_arcs());
  count(found.pips.size());
  count(found.lobes.size());
  real(bounded ? static_cast<double>(found.boundary->bip) : -1);
  count(found.images.period);
  count(found.images.compared);
  real(bounded ? found.boundary->area : NAN);
  real(paired ? found.images.lobe_area12 : NAN);
  real(paired ? found.images.lobe_area21 : NAN);
  real(paired ? found.images.turnstile_sum : NAN);
  real(paired ? found.images.area_change : NAN);
  record.lists.resize(4);
  for (const Lobe& lobe : found.lobes) {
    record.lists[0].push_back(lobe.area);
    record.lists[1].push_back(lobe.inside);
    if (options.flag("smooth")) record.lists[2].push_back(lobe.smooth_error);
  }
  if (options.flag("overlaps")) {
    for (const LobeOverlap& both : overlaps(found)) {
      record.lists[3].insert(record.lists[3].end(),
                             {static_cast<double>(both.i), static_cast<double>(both.j), both.area});
    }
  }
  return record;
}

}  // namespace

Operation tangle_operation() {
  Operation operation;
  operation.name = "tangle";
  operation.view = "tangles";
  operation.open = true;
  operation.summary = "pips, lobes, boundary and turnstile of an unstable and a stable manifold";
  operation.options = {
      {"bip", std::int64_t{-1}, "number of the pip that bounds the region, from 0; -1 for the middle one", {}, -1},
      {"period",
       std::int64_t{0},
       "number of pips from one to its image, at most that of lobes, even where lobes alternate; 0 to infer it from "
       "the "
       "areas",
       {},
       0,
       1'000'000},
      {"smooth", false, "areas between smooth curves through the points"},
      {"overlaps", false, "list the areas that lobes have in common"},
      {"check_simple", true, "refuse manifolds that cross themselves"},
      index_option()};
  for (const char* const name :
       {"crossings", "touches", "shared_arcs", "pips", "lobes", "bip", "period", "lobes_compared"}) {
    operation.columns.push_back({name, Column::Kind::count});
  }
  for (const char* const name : {"boundary", "lobe_area12", "lobe_area21", "turnstile_sum", "area_change"}) {
    operation.columns.push_back({name, Column::Kind::real});
  }
  // Signed areas of the lobes, their parts inside the boundary, error bars if smooth; overlaps as i, j, area, i, ...
  operation.lists = {"areas", "inside", "errors", "overlaps"};
  operation.requirements = [](const Options& options) {
    return Requirements{.index = true, .simple = options.flag("check_simple")};
  };
  operation.run = run_tangle;
  operation.cost = [](std::size_t points) { return 20 + 1e-2 * static_cast<double>(points); };
  return operation;
}

}  // namespace lober::detail

// `overlay`: areas with error bars, how often the curves meet, how many pieces, and the areas of the lobes if asked
// for.
#include <cmath>

#include "engine/batch/operations/table.hpp"
#include "lober/overlay.hpp"

namespace lober::detail {
namespace {

Result run_overlay(JobCurves curves, const Options& options) {
  const PreparedCurve &first = *curves[0], &second = *curves[1];
  OverlayOptions how;
  how.index = index_kind(options);
  how.pieces = !options.flag("areas_only");
  how.check_simple = false;  // done when the curve was read
  const Overlay result = overlay(first.index(), second.index(), how);

  Result record;
  record.values.reserve(31);  // the number of columns
  add_areas(record.values, result.areas);
  add_areas(record.values, result.rounding);
  const Areas unknown{NAN, NAN, NAN, NAN, NAN, NAN, NAN};
  add_areas(record.values,
            options.flag("discretisation") ? discretisation_error(result, first.sums(), second.sums()) : unknown);
  const auto count = [&](std::size_t number) { record.values.push_back(static_cast<double>(number)); };
  count(result.nodes.crossings());
  count(result.nodes.touches());
  count(result.nodes.shared_arcs());
  count(result.class_count);
  for (const Pairing pairing : all_pairings) count(result.pieces(pairing).size());
  record.values.push_back(static_cast<double>(result.orientation1));
  record.values.push_back(static_cast<double>(result.orientation2));
  if (options.flag("lobes")) {
    const auto areas = [&](Pairing pairing) {
      const std::span<const double> all = result.pieces(pairing).areas();
      return std::vector<double>(all.begin(), all.end());
    };
    record.lists = {areas(Pairing::c1_minus_c2), areas(Pairing::c2_minus_c1)};
  }
  return record;
}

}  // namespace

Operation overlay_operation() {
  Operation operation;
  operation.name = "overlay";
  operation.summary = "areas of two closed curves and of their pairings, with error bars, crossings and pieces";
  operation.view = "overlaps";
  operation.options = {{"areas_only", false, "leave out pieces"},
                       {"discretisation", true, "estimate the difference between polygons and smooth curves"},
                       {"lobes", false, "list the areas of the pieces of both differences"},
                       index_option()};
  for (const char* const kind : {"", "rounding_", "discretisation_"}) add_area_columns(operation.columns, kind);
  for (const char* const count :
       {"crossings", "touches", "shared_arcs", "classes", "pieces_c1_minus_c2", "pieces_c2_minus_c1",
        "pieces_intersection", "pieces_union", "orientation1", "orientation2"}) {
    operation.columns.push_back({count, Column::Kind::count});
  }
  operation.lists = {"lobes_c1_minus_c2", "lobes_c2_minus_c1"};
  operation.requirements = [](const Options& options) {
    return Requirements{
        .index = true, .simple = true, .closed = true, .discretisation = options.flag("discretisation")};
  };
  operation.run = run_overlay;
  // Measured on circles and wavy curves that cross a few times: 5 us, and 0.1 ns a point; tangles cost far more.
  operation.cost = [](std::size_t points) { return 5 + 1e-4 * static_cast<double>(points); };
  return operation;
}

}  // namespace lober::detail

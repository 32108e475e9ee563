// `interior`: the areas by way of the interior function, an independent method.
#include "lober/interior.hpp"

#include "engine/batch/operations/table.hpp"

namespace lober::detail {
namespace {

Result run_interior(JobCurves curves, const Options& options) {
  const PreparedCurve &first = *curves[0], &second = *curves[1];
  InteriorOptions how;
  how.method = options.text("method") == "ends" ? InteriorMethod::ends : InteriorMethod::split;
  how.passes = static_cast<int>(options.whole("passes"));
  how.points = static_cast<int>(options.whole("points"));
  how.index = index_kind(options);
  how.check_simple = false;  // done when the curve was read
  const InteriorAreas result = interior_areas(first.index(), second.index(), how);

  Result record;
  add_areas(record.values, result.areas);
  add_areas(record.values, result.rounding);
  record.values.insert(record.values.end(), {result.q1, result.q2, result.q3, result.delta});
  for (const std::size_t count : {result.nodes.crossings(), result.nodes.touches(), result.nodes.shared_arcs(),
                                  static_cast<std::size_t>(result.statistics.points_inserted)}) {
    record.values.push_back(static_cast<double>(count));
  }
  record.values.push_back(static_cast<double>(result.orientation1));
  record.values.push_back(static_cast<double>(result.orientation2));
  return record;
}

}  // namespace

Operation interior_operation() {
  Operation operation;
  operation.name = "interior";
  operation.view = "interiors";
  operation.summary = "areas of two closed curves by the interior function, Q1, Q2 and Q3";
  operation.options = {
      {"method", "split", "split segments where the curves meet, or count them by their ends", {"split", "ends"}},
      {"passes",
       std::int64_t{0},
       "with ends: number of passes that insert points where the ends of a segment differ",
       {},
       0,
       1'000'000},
      {"points",
       std::int64_t{0},
       "with ends: number of points that a pass inserts into such a segment",
       {},
       0,
       1'000'000},
      index_option()};
  for (const char* const kind : {"", "rounding_"}) add_area_columns(operation.columns, kind);
  for (const char* const name : {"q1", "q2", "q3", "delta"}) operation.columns.push_back({name, Column::Kind::real});
  for (const char* const name :
       {"crossings", "touches", "shared_arcs", "points_inserted", "orientation1", "orientation2"}) {
    operation.columns.push_back({name, Column::Kind::count});
  }
  operation.requirements = [](const Options&) { return Requirements{.index = true, .simple = true, .closed = true}; };
  operation.run = run_interior;
  operation.cost = [](std::size_t points) { return 10 + 1e-3 * static_cast<double>(points); };
  return operation;
}

}  // namespace lober::detail

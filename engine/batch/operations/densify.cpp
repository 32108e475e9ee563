// `densify` and `simplify`: more points on a curve, or fewer. The operations that write curves.
#include "engine/batch/operations/of_table.hpp"
#include "engine/batch/operations/table.hpp"

namespace lober::detail {
namespace {

Operation refining(const char* name, TableJob job) {
  job.points = [](const operations::Outcome& found) -> std::span<const Point> {
    return found.as<operations::RefinedCurve>().points;
  };
  job.microseconds = 10;
  job.microseconds_a_point = 0.1;
  return operation_of(operations::named(name), job);
}

}  // namespace

Operation densify_operation() {
  return refining("densify", {"densified",
                              {{"signed_area", "signed_area"},
                               {"points_in", "given"},
                               {"points", "result.points"},
                               {"rounds", "rounds"},
                               {"segments_with_diagnostics", "diagnostics.segments"}},
                              {}});
}

Operation simplify_operation() {
  return refining(
      "simplify",
      {"simplified", {{"signed_area", "signed_area"}, {"points_in", "given"}, {"points", "result.points"}}, {}});
}

}  // namespace lober::detail

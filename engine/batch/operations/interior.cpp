// `interior`: the areas by way of the interior function, an independent method.
#include "engine/batch/operations/of_table.hpp"
#include "engine/batch/operations/table.hpp"

namespace lober::detail {

Operation interior_operation() {
  TableJob job;
  job.view = "interiors";
  add_areas(job.columns, "", "areas");
  add_areas(job.columns, "rounding_", "error.rounding");
  add_all(job.columns, {{"q1", "q1"},
                        {"q2", "q2"},
                        {"q3", "q3"},
                        {"delta", "delta"},
                        {"crossings", "crossings.count"},
                        {"touches", "crossings.contacts"},
                        {"shared_arcs", "crossings.shared_arcs"},
                        {"points_inserted", "statistics.points_inserted"},
                        {"orientation1", "orientation1"},
                        {"orientation2", "orientation2"}});
  job.microseconds = 10;
  job.microseconds_a_point = 1e-3;
  return operation_of(operations::named("interior"), job);
}

}  // namespace lober::detail

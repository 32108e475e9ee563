// `winding`: winding numbers of the first curve about the vertices of the second.
#include "engine/batch/operations/of_table.hpp"
#include "engine/batch/operations/table.hpp"

namespace lober::detail {

Operation winding_operation() {
  TableJob job;
  job.view = "windings";
  job.columns = {{"on", "on"}, {"consistency", "error.consistency"}};
  job.lists = {{"winding", "counts.winding"}, {"points", "counts.points"}};
  job.microseconds = 10;
  job.microseconds_a_point = 0.2;
  return operation_of(operations::named("winding"), job);
}

}  // namespace lober::detail

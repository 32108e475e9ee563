// `fixed_points`: fixed and periodic points of a system's map in a box. No curves.
#include "engine/batch/operations/of_table.hpp"
#include "engine/batch/operations/table.hpp"

namespace lober::detail {

Operation fixed_points_operation() {
  TableJob job{"periodic_points",
               {{"settled", "search.settled"},
                {"out_of_work", "search.out_of_work"},
                {"index_sum", "search.index_sum"},
                {"index_of_box", "search.index_of_box"}},
               {{"x", "points.x"},
                {"y", "points.y"},
                {"least_period", "points.period"},
                {"residue", "points.residue"},
                {"index", "points.index"},
                {"rotation", "points.rotation"}}};
  job.needs_tangle = false;
  job.microseconds = 5e5;
  job.memory = std::size_t{16} << 20;
  return operation_of(operations::named("fixed_points"), job);
}

}  // namespace lober::detail

// `grow`: a branch of a manifold of a saddle; how far it goes, not its points. No curves.
#include "engine/batch/operations/of_table.hpp"
#include "engine/batch/operations/table.hpp"

namespace lober::detail {

Operation grow_operation() {
  TableJob job{"manifolds",
               {{"points", "result.points"},
                {"arc_length", "result.length"},
                {"images_of_local_manifold", "result.iterates"},
                {"multiplier", "local_manifold.multiplier"},
                {"defect", "local_manifold.defect"}},
               {}};
  job.needs_tangle = false;
  job.microseconds = 1e5;
  job.memory = std::size_t{64} << 20;
  return operation_of(operations::named("grow"), job);
}

}  // namespace lober::detail

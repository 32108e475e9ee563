// `escape`: the table of escape from a potential well. No curves.
#include "engine/batch/operations/of_table.hpp"
#include "engine/batch/operations/table.hpp"

namespace lober::detail {

Operation escape_operation() {
  TableJob job{"escapes",
               {{"total_energy", "energy"}, {"known_crossings", "crossings"}},
               {{"n", "table.crossings"}, {"fraction", "table.fraction"}, {"fraction_error", "table.error"}}};
  job.needs_tangle = false;
  job.microseconds = 5e6;
  job.memory = std::size_t{256} << 20;
  return operation_of(operations::named("escape"), job);
}

}  // namespace lober::detail

// `sweep`: areas of the turnstile of a system for values of a parameter, as one job. No curves.
#include "engine/batch/operations/of_table.hpp"
#include "engine/batch/operations/table.hpp"

namespace lober::detail {

Operation sweep_operation() {
  TableJob job{"sweeps",
               {{"failures", "failures"}},
               {{"value", "rows.value"},
                {"flux21", "rows.flux21"},
                {"flux21_error", "rows.flux21_error"},
                {"lobe_area21", "rows.lobe_area21"},
                {"lobe_area21_by_action", "rows.lobe_area21_by_action"},
                {"difference", "rows.difference"},
                {"zeros", "zeros.value"}}};
  job.not_kept = {"melnikov"};
  job.microseconds = 2e6;
  job.memory = std::size_t{64} << 20;
  return operation_of(operations::named("sweep"), job);
}

}  // namespace lober::detail

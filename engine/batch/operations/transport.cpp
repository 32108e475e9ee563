// `transport`: flux out of a region of a system, iterate by iterate, from its equations alone. No curves.
#include "engine/batch/operations/of_table.hpp"
#include "engine/batch/operations/table.hpp"

namespace lober::detail {

Operation transport_operation() {
  TableJob job{"transports",
               {{"region", "region.area"},
                {"flux12", "turnstile.flux12"},
                {"flux21", "turnstile.flux21"},
                {"lobe_area12", "turnstile.lobe_area12"},
                {"lobe_area21", "turnstile.lobe_area21"},
                {"lobe_area12_by_action", "turnstile.lobe_area12_by_action"},
                {"lobe_area21_by_action", "turnstile.lobe_area21_by_action"},
                {"period", "turnstile.period"},
                {"points_u", "saddles.unstable.points"},
                {"points_s", "saddles.stable.points"}},
               {{"a21", "steps.a21"},
                {"total21", "steps.T21"},
                {"total21_error", "steps.T21_error"},
                {"total21_by_boundaries", "steps.T_by_boundaries"}}};
  job.microseconds = 2e5;
  job.memory = std::size_t{64} << 20;
  return operation_of(operations::named("transport"), job);
}

}  // namespace lober::detail

// `transport` and `curve_transport`: flux out of a region, iterate by iterate, from the equations of a system alone,
// and from manifolds that are given.
#include "engine/batch/operations/of_table.hpp"
#include "engine/batch/operations/table.hpp"

namespace lober::detail {
namespace {

const TableJob::Names lists_of_steps{{"a21", "steps.a21"},
                                     {"total21", "steps.T21"},
                                     {"total21_error", "steps.T21_error"},
                                     {"total21_by_boundaries", "steps.T_by_boundaries"}};

}  // namespace

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
               lists_of_steps};
  job.not_kept = {"melnikov", "all_regions"};
  job.microseconds = 2e5;
  job.memory = std::size_t{64} << 20;
  return operation_of(operations::named("transport"), job);
}

Operation curve_transport_operation() {
  TableJob job{"curve_transports",
               {{"region", "enclosed"},
                {"region_error", "enclosed_error"},
                {"period", "period"},
                {"flux12", "turnstile.flux12"},
                {"flux21", "turnstile.flux21"},
                {"lobe_area12", "turnstile.lobe_area12"},
                {"lobe_area21", "turnstile.lobe_area21"}},
               lists_of_steps};
  job.microseconds = 50;
  job.microseconds_a_point = 2e-2;
  return operation_of(operations::named("curve_transport"), job);
}

}  // namespace lober::detail

// `tangle` and `manifold_tangle`: pips, lobes, boundary and turnstile of two manifolds, from files and from equations.
#include "engine/batch/operations/of_table.hpp"
#include "engine/batch/operations/table.hpp"

namespace lober::detail {
namespace {

// Not known where areas are those of polygons. Behind the others, whose numbers callers may know.
void add_parts_errors(TableJob& job) {
  job.lists.emplace_back("parts_errors", "lobes.parts_error");
}

TableJob tangle_job(const char* view) {
  TableJob job;
  job.view = view;
  job.columns = {{"crossings", "crossings.count"},
                 {"touches", "crossings.contacts"},
                 {"shared_arcs", "crossings.shared_arcs"},
                 {"pips", "counts.pips"},
                 {"lobes", "counts.lobes"},
                 {"bip", "counts.bip"},
                 {"period", "counts.period"},
                 {"lobes_compared", "images.compared"},
                 {"boundary", "boundary.area"},
                 {"lobe_area12", "turnstile.lobe_area12"},
                 {"lobe_area21", "turnstile.lobe_area21"},
                 {"turnstile_sum", "error.consistency.turnstile_sum"},
                 {"area_change", "error.consistency.area_change"}};
  // Overlaps are there where they are asked for.
  job.lists = {{"areas", "lobes.area"},     {"inside", "lobes.inside"},  {"errors", "lobes.discretisation"},
               {"overlap_i", "overlaps.i"}, {"overlap_j", "overlaps.j"}, {"overlap_areas", "overlaps.area"}};
  return job;
}

}  // namespace

Operation tangle_operation() {
  TableJob job = tangle_job("tangles");
  add_parts_errors(job);
  job.microseconds = 20;
  job.microseconds_a_point = 1e-2;
  return operation_of(operations::named("tangle"), job);
}

Operation manifold_tangle_operation() {
  TableJob job = tangle_job("manifold_tangles");
  add_all(job.columns,
          {{"multiplier_u", "saddles.unstable.multiplier"}, {"multiplier_s", "saddles.stable.multiplier"}});
  add_all(job.lists, {{"areas_by_action", "turnstile_by_action.lobes.action"},
                      {"action_errors", "turnstile_by_action.lobes.action_error"}});
  add_parts_errors(job);
  job.microseconds = 1e6;
  job.memory = std::size_t{64} << 20;
  return operation_of(operations::named("manifold_tangle"), job);
}

}  // namespace lober::detail

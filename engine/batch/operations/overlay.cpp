// `overlay`: areas with error bars, how often the curves meet, how many pieces, and the areas of the lobes if asked
// for.
#include "engine/batch/operations/of_table.hpp"
#include "engine/batch/operations/table.hpp"

namespace lober::detail {

Operation overlay_operation() {
  TableJob job;
  job.view = "overlaps";
  add_areas(job.columns, "", "areas");
  add_areas(job.columns, "rounding_", "error.rounding");
  add_areas(job.columns, "discretisation_", "error.discretisation");
  add_all(job.columns, {{"crossings", "crossings.count"},
                        {"touches", "crossings.contacts"},
                        {"shared_arcs", "crossings.shared_arcs"},
                        {"classes", "crossings.classes"},
                        {"pieces_c1_minus_c2", "piece_counts.c1_minus_c2"},
                        {"pieces_c2_minus_c1", "piece_counts.c2_minus_c1"},
                        {"pieces_intersection", "piece_counts.intersection"},
                        {"pieces_union", "piece_counts.union"},
                        {"orientation1", "orientation1"},
                        {"orientation2", "orientation2"}});
  job.lists = {{"lobes_c1_minus_c2", "pieces.c1_minus_c2.area"}, {"lobes_c2_minus_c1", "pieces.c2_minus_c1.area"}};
  job.lists_if = OptionSpec{"lobes", false, "whether to list the areas of the pieces of both differences"};
  job.not_kept = {"smooth"};
  // Measured on circles and wavy curves that cross a few times; tangles cost far more.
  job.microseconds = 5;
  job.microseconds_a_point = 1e-4;
  return operation_of(operations::named("overlay"), job);
}

}  // namespace lober::detail

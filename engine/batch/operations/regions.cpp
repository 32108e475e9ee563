// `regions`: areas of one or two curves that may cross themselves, by a rule, and of each pair of winding numbers.
#include "engine/batch/operations/of_table.hpp"
#include "engine/batch/operations/table.hpp"

namespace lober::detail {

Operation regions_operation() {
  TableJob job;
  job.view = "regions";
  add_areas(job.columns, "", "areas");
  add_areas(job.columns, "rounding_", "error.rounding");
  add_all(job.columns, {{"signed_area1", "signed_areas.c1"},
                        {"signed_area2", "signed_areas.c2"},
                        {"nodes", "arrangement.nodes"},
                        {"faces", "arrangement.faces"}});
  job.lists = {{"winding1", "winding.c1"}, {"winding2", "winding.c2"}, {"winding_areas", "winding.area"}};
  job.microseconds = 20;
  job.microseconds_a_point = 5e-3;
  return operation_of(operations::named("regions"), job);
}

}  // namespace lober::detail

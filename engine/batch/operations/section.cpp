// `section`: orbits of a system's map, whose points are counted. No curves.
#include "engine/batch/operations/of_table.hpp"
#include "engine/batch/operations/table.hpp"

namespace lober::detail {

Operation section_operation() {
  TableJob job{"sections",
               {{"points", "points"},
                {"points_in_box", "points_in_box"},
                {"lost_orbits", "lost_orbits"},
                {"unreached_starts", "unreached_starts"}},
               {{"crossings", "exit_times.leaving.crossings"}, {"leaving", "exit_times.leaving.orbits"}}};
  job.needs_tangle = false;
  job.microseconds = 1e6;
  job.memory = std::size_t{128} << 20;
  return operation_of(operations::named("section"), job);
}

}  // namespace lober::detail

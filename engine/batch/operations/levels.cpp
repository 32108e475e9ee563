// `levels`: level curves of the energy of a flow. No curves.
#include "engine/batch/operations/of_table.hpp"
#include "engine/batch/operations/table.hpp"

namespace lober::detail {

Operation levels_operation() {
  TableJob job{"levels",
               {{"least_energy", "levels.energy"}},
               {{"energies", "levels.energy"},
                {"curves", "levels.curves"},
                {"closed", "levels.closed"},
                {"points", "levels.points"},
                {"saddle_energies", "saddles.energy"}}};
  job.needs_tangle = false;
  job.microseconds = 5e5;
  job.memory = std::size_t{64} << 20;
  return operation_of(operations::named("levels"), job);
}

}  // namespace lober::detail

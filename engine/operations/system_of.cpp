#include "engine/operations/system_of.hpp"

#include "lober/base/error.hpp"

namespace lober::detail::table {

const SystemInput& system_input_of(std::span<const Input> inputs) {
  return std::get<SystemInput>(inputs[0]);
}

const SystemInput& system_of(std::span<const Input> inputs) {
  const SystemInput& input = system_input_of(inputs);
  if (!input.system->map)
    throw UsageError("system " + input.system->info.name + " has no planar map, which this operation needs");
  return input;
}

Point shift_by(int turns, const System& system) {
  if (turns != 0 && system.lattice == Point{}) {
    throw UsageError("system " + system.info.name + " does not repeat after a shift; leave option \"turns\" out");
  }
  return {turns * system.lattice.x, turns * system.lattice.y};
}

}  // namespace lober::detail::table

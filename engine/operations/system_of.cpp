#include "engine/operations/system_of.hpp"

#include <limits>

#include "lober/error.hpp"

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

std::function<bool(const std::string&)> lines_to(const Context& context) {
  if (!context.progress) return {};
  return
      [&context](const std::string& line) { return context.progress(std::numeric_limits<double>::quiet_NaN(), line); };
}

}  // namespace lober::detail::table

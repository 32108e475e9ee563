#include <limits>

#include "engine/operations/system_of.hpp"
#include "lober/error.hpp"

namespace lober::operations {

SystemInput system_input(const std::string& name, const ParameterValues& values,
                         const IntegrationOptions& integration) {
  SystemInput input;
  input.system = std::make_shared<const System>(make_system(name, values, integration));
  input.integration = integration;
  input.with = [name, values, integration](const ParameterValues& changed) {
    ParameterValues all = values;
    for (const auto& other : changed) {
      std::erase_if(all, [&other](const auto& one) { return one.first == other.first; });
      all.push_back(other);
    }
    return make_system(name, all, integration);
  };
  return input;
}

}  // namespace lober::operations

namespace lober::detail::table {

const SystemInput& system_of(std::span<const Input> inputs) {
  const auto* const input = inputs.size() == 1 ? std::get_if<SystemInput>(&inputs[0]) : nullptr;
  if (input == nullptr || !input->system) throw UsageError("the operation takes one system and nothing else");
  if (!input->system->map)
    throw UsageError("system " + input->system->info.name + " has no planar map, which this operation needs");
  return *input;
}

std::function<bool(const std::string&)> lines_to(const Context& context) {
  if (!context.progress) return {};
  return
      [&context](const std::string& line) { return context.progress(std::numeric_limits<double>::quiet_NaN(), line); };
}

}  // namespace lober::detail::table

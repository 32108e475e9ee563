#include <utility>

#include "lober/curve/files.hpp"
#include "lober/operations.hpp"

namespace lober::operations {

SystemInput system_input(const std::string& name, const ParameterValues& values,
                         const IntegrationOptions& integration) {
  SystemInput input;
  System system = make_system(name, values, integration);
  if (!system.info.library.empty()) system.info.library_sha256 = sha256_of_file(system.info.library);
  input.system = std::make_shared<const System>(std::move(system));
  input.integration = integration;
  input.given = values;
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

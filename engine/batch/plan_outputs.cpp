#include "engine/batch/plan_outputs.hpp"

#include <map>
#include <set>
#include <vector>

#include "lober/base/error.hpp"

namespace lober::detail {

OutputFolder output_folder_of(const std::string& root, const std::string& manifest_path, const Plan& plan,
                              const std::string& store) {
  std::set<std::string> inputs;  // none have to be protected where nothing is written
  if (!plan.may_write()) return {root, manifest_path, {}, store};
  for (const CurveSource& curve : plan.curves) {
    if (!curve.file.empty()) inputs.insert(curve.file);
  }
  return {root, manifest_path, std::vector<std::string>(inputs.begin(), inputs.end()), store};
}

void accept_outputs(const OutputFolder& folder, const std::string& manifest_path, const Plan& plan) {
  if (!plan.may_write()) return;
  std::map<std::string, std::size_t> writers;
  for (std::size_t number = 0; number < plan.jobs.size(); ++number) {
    const std::string name = plan.output_of(plan.jobs[number]);
    if (name.empty()) continue;
    try {
      const auto [at, is_new] = writers.try_emplace(folder.accept(name), number);
      if (!is_new) {
        throw UsageError("\"" + name + "\" is the output of both job " + std::to_string(at->second) + " and job " +
                         std::to_string(number) + "; put {name}, {second} or the {key} of an option into the name");
      }
    } catch (const UsageError& error) {
      throw UsageError(manifest_path + ": options.output: " + error.what());
    }
  }
}

}  // namespace lober::detail

#include "cli/batch/job_values.hpp"

#include <algorithm>
#include <set>

#include "cli/batch/batch_page.hpp"
#include "engine/base/nearest_word.hpp"
#include "lober/base/error.hpp"
#include "lober/batch.hpp"

namespace lober::cli {
namespace {

const std::string option_prefix = "parameters.";

// "K" of the option "parameters.K".
std::string short_option(const std::string& key) {
  return key.starts_with(option_prefix) ? key.substr(option_prefix.size()) : key;
}

}  // namespace

JobValues::JobValues(const std::string& store, const std::string& operation, const lober::Progress& progress) {
  ExportCounts counts;
  const Json exported = Json::parse(jobs_json(store, counts, progress));
  std::vector<std::string> operations;
  for (const Json& job : exported["jobs"]) {
    const std::string name = job["operation"];
    if (std::find(operations.begin(), operations.end(), name) == operations.end()) operations.push_back(name);
    if (job["status"] == "done" && (operation.empty() || name == operation)) jobs_.push_back(job);
  }
  if (operation.empty() && operations.size() > 1) {
    throw UsageError("the store has several operations; choose one by --operation: " + detail::joined(operations));
  }
  if (!operation.empty() && std::find(operations.begin(), operations.end(), operation) == operations.end()) {
    throw UsageError("--operation " + operation + ": the store has no job of it; there are " +
                     detail::joined(operations));
  }
  if (jobs_.empty()) throw DataError(store + ": no job is done yet, so there is nothing to draw");
  // Names in the order in which the export has them.
  std::vector<std::string> inputs, options;
  std::set<std::string> seen;
  for (const Json& job : jobs_) {
    for (const auto& [key, one] : job["options"].items()) {
      if (seen.insert("options." + key).second) options.push_back(short_option(key));
    }
    for (const auto& [key, one] : job.items()) {
      if (!seen.insert(key).second) continue;
      if (key == "first" || key == "second") inputs.push_back(key);
      if (one.is_number() && key != "job") results_.push_back(key);
    }
  }
  inputs.insert(inputs.end(), options.begin(), options.end());
  for (const std::string& name : inputs) {
    const auto differs = [&](std::size_t k) { return value(k, name) != value(0, name); };
    bool varies = false;
    for (std::size_t k = 1; k < jobs_.size() && !varies; ++k) varies = differs(k);
    if (varies) varied_.push_back(name);
  }
}

const Json& JobValues::value(std::size_t job, const std::string& name) const {
  static const Json none;
  const Json &one = jobs_[job], &options = one["options"];
  for (const std::string& key : {name, option_prefix + name}) {
    if (const auto found = options.find(key); found != options.end()) return *found;
  }
  const auto found = one.find(name);
  return found != one.end() ? *found : none;
}

}  // namespace lober::cli

#include "engine/batch/manifest/swept_options.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

// "\n" for an option that is not given, which no value is spelled as.
std::string spelled_value(const OptionValue* value) {
  return value != nullptr ? to_string(*value) : "\n";
}

bool has_column(const Operation& operation, const std::string& name) {
  const auto is_it = [&](const Column& column) { return column.name == name; };
  return std::any_of(operation.columns.begin(), operation.columns.end(), is_it) ||
         std::find(operation.lists.begin(), operation.lists.end(), name) != operation.lists.end();
}

// By the name: a table of results has an operation with further columns.
bool is_of(const JobGroup& group, const Operation& operation) {
  return group.operation->name == operation.name;
}

}  // namespace

std::vector<SweptOption> swept_options(const Plan& plan, const Operation& operation) {
  std::set<std::string> keys;
  for (const JobGroup& group : plan.groups) {
    if (!is_of(group, operation)) continue;
    for (const OptionSetting& setting : group.options.settings()) keys.insert(setting.key);
  }
  std::vector<SweptOption> swept;
  for (const std::string& key : keys) {
    std::set<std::string> values;
    for (const JobGroup& group : plan.groups) {
      if (is_of(group, operation)) values.insert(spelled_value(group.options.find(key)));
    }
    if (values.size() > 1) swept.push_back({key, has_column(operation, key) ? "options." + key : key});
  }
  return swept;
}

std::string swept_values(const std::vector<SweptOption>& swept, const JobGroup& group) {
  std::string text;
  for (const SweptOption& option : swept) {
    const OptionValue* const value = group.options.find(option.key);
    if (value != nullptr) text += (text.empty() ? "" : " ") + option.key + "=" + to_string(*value);
  }
  return text;
}

const OptionValue& any_value(const SweptOption& swept, const Plan& plan, const Operation& operation) {
  for (const JobGroup& group : plan.groups) {
    const OptionValue* const value = is_of(group, operation) ? group.options.find(swept.key) : nullptr;
    if (value != nullptr) return *value;
  }
  throw DataError("no group has the option " + swept.key);
}

}  // namespace lober::detail

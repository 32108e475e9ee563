#include "cli/report/outcome_json.hpp"

#include <algorithm>

#include "cli/report/agreement_report.hpp"

namespace lober::cli {
namespace {

Json setting_json(const operations::OptionValue& value) {
  if (const auto* const flag = std::get_if<bool>(&value)) return *flag;
  if (const auto* const whole = std::get_if<std::int64_t>(&value)) return *whole;
  if (const auto* const real = std::get_if<double>(&value)) return number_json(*real);
  if (const auto* const text = std::get_if<std::string>(&value)) return *text;
  return operations::numbers_of(value);
}

// The remarks that the fields of a result do not have.
std::vector<std::string> remarks_beside(const operations::Operation& operation, const operations::Outcome& outcome) {
  std::vector<std::string> left = outcome.remarks;
  for (const operations::Field& field : operation.result) {
    if (field.name != "remarks") continue;
    const operations::FieldValue value = field.get(outcome.value.get());
    const auto* const known = std::get_if<std::vector<std::string>>(&value);
    if (known == nullptr) continue;
    std::erase_if(left,
                  [&](const std::string& one) { return std::find(known->begin(), known->end(), one) != known->end(); });
  }
  return left;
}

}  // namespace

void write_outcome_json(const std::string& path, std::string_view command,
                        const std::vector<std::pair<std::string, Json>>& inputs, const operations::Operation& operation,
                        const operations::Outcome& outcome, const std::function<Json()>& timing,
                        const std::function<void(detail::OutputFile&)>& more) {
  JsonFile json(path, command);
  if (operation.compares) add_agreement(json, outcome.agreement);
  for (const auto& [name, value] : inputs) json.member(name, value);
  Json options = Json::object();
  for (const operations::OptionSetting& setting : outcome.settings())
    options[setting.key] = setting_json(setting.value);
  for (const operations::OptionSpec& spec : operation.options) {
    if (!options.contains(spec.key)) options[spec.key] = nullptr;
  }
  json.member("options", options);
  if (const std::vector<std::string> warnings = remarks_beside(operation, outcome); !warnings.empty()) {
    json.member("warnings", warnings);
  }
  write_json_members(operation.result, outcome.value.get(), [&](std::string_view text) { json.file().write(text); });
  json.file().write(",\n");
  if (more) more(json.file());
  json.finish(timing());
}

}  // namespace lober::cli

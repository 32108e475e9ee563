#include "engine/batch/operations/options.hpp"

#include <map>

#include <algorithm>

#include "engine/batch/operations/text.hpp"
#include "lober/error.hpp"

namespace lober::detail {
namespace {

[[noreturn]] void refuse(const OptionSpec& spec, const std::string& message) {
  throw UsageError(spec.key + ": " + message);
}

const char* type_name(const OptionValue& value) {
  constexpr const char* names[] = {"true or false", "a whole number", "a number", "a string"};
  return names[value.index()];
}

std::string joined(std::span<const std::string> words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

OptionValue checked(OptionSpec spec, const OptionSetting& setting) {
  OptionValue value = setting.value;
  spec.key = setting.key;
  if (std::holds_alternative<double>(spec.fallback) && std::holds_alternative<std::int64_t>(value)) {
    value = static_cast<double>(std::get<std::int64_t>(value));
  }
  if (value.index() != spec.fallback.index()) refuse(spec, std::string("has to be ") + type_name(spec.fallback));
  if (const auto* text = std::get_if<std::string>(&value); text != nullptr && !spec.choices.empty()) {
    if (std::find(spec.choices.begin(), spec.choices.end(), *text) == spec.choices.end()) {
      refuse(spec, "\"" + *text + "\" cannot be read as one of " + joined(spec.choices));
    }
  }
  double number = 0;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) number = static_cast<double>(*whole);
  if (const auto* real = std::get_if<double>(&value)) number = *real;
  if (std::holds_alternative<std::int64_t>(value) || std::holds_alternative<double>(value)) {
    if (!(number >= spec.min)) refuse(spec, "has to be at least " + format_number(spec.min));
    if (!(number <= spec.max)) refuse(spec, "has to be at most " + format_number(spec.max));
  }
  return value;
}

}  // namespace

Options::Options(std::span<const OptionSpec> specs, std::span<const OptionSetting> settings) {
  std::map<std::string, OptionValue> chosen, of_families;
  for (const OptionSetting& setting : settings) {
    const auto spec =
        std::find_if(specs.begin(), specs.end(), [&](const OptionSpec& any) { return any.is_for(setting.key); });
    if (spec == specs.end()) {
      std::vector<std::string> known;
      for (const OptionSpec& any : specs) known.push_back(any.key);
      throw UsageError(setting.key + ": there is no such option; there are " + joined(known));
    }
    (spec->family() ? of_families : chosen)[setting.key] = checked(*spec, setting);
  }
  for (const OptionSpec& spec : specs) {
    if (spec.family()) continue;
    const auto given = chosen.find(spec.key);
    settings_.push_back({spec.key, given != chosen.end() ? given->second : spec.fallback});
  }
  for (const auto& [key, value] : of_families) settings_.push_back({key, value});
}

std::vector<std::pair<std::string, double>> Options::reals_of(std::string_view prefix) const {
  std::vector<std::pair<std::string, double>> found;
  for (const OptionSetting& setting : settings_) {
    if (!setting.key.starts_with(std::string(prefix) + ".")) continue;
    found.emplace_back(setting.key.substr(prefix.size() + 1), std::get<double>(setting.value));
  }
  return found;
}

const OptionValue* Options::find(std::string_view key) const {
  const auto found =
      std::find_if(settings_.begin(), settings_.end(), [&](const OptionSetting& any) { return any.key == key; });
  return found == settings_.end() ? nullptr : &found->value;
}

const OptionValue& Options::at(std::string_view key) const {
  const OptionValue* const found = find(key);
  if (found == nullptr) throw UsageError("no option " + std::string(key));
  return *found;
}

std::string to_string(const OptionValue& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* real = std::get_if<double>(&value)) return format_number(*real);
  return std::get<std::string>(value);
}

std::string to_string(std::span<const OptionSetting> settings) {
  std::string text;
  for (const OptionSetting& setting : settings) {
    text += (text.empty() ? "" : " ") + setting.key + "=" + to_string(setting.value);
  }
  return text;
}

std::string Options::to_string() const {
  return detail::to_string(settings_);
}

}  // namespace lober::detail

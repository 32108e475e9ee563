#include "cli/program/table_options.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lober/base/error.hpp"

namespace lober::cli {
namespace {

using operations::OptionSpec;

std::string capitalised(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

// A flag that is true unless it is refused: --no-check-simple.
bool is_on(const OptionSpec& spec) {
  const bool* const flag = std::get_if<bool>(&spec.fallback);
  return flag != nullptr && *flag;
}

// "The number of iterates n up to which the table goes (default: 7)."
std::string help_of(const OptionSpec& spec) {
  const std::string whether = "whether to ";
  if (spec.meaning.starts_with(whether)) {
    const std::string phrase = spec.meaning.substr(whether.size());
    return (is_on(spec) ? "Do not " + phrase : capitalised(phrase)) + ".";
  }
  const std::size_t aside = std::min(spec.meaning.find(';'), spec.meaning.size());
  const std::string otherwise = spec.optional ? spec.otherwise : operations::to_string(spec.fallback);
  const char* const article = std::holds_alternative<Point>(spec.fallback)       ? "A "
                              : std::holds_alternative<Rectangle>(spec.fallback) ? "The two "
                                                                                 : "The ";
  std::string text = article + spec.meaning.substr(0, aside);
  if (!otherwise.empty()) text += " (default: " + otherwise + ")";
  text += spec.meaning.substr(aside) + ".";
  const bool says = std::all_of(spec.choices.begin(), spec.choices.end(), [&](const std::string& choice) {
    return spec.meaning.find(choice) != std::string::npos;
  });
  for (std::size_t k = 0; !says && k < spec.choices.size(); ++k) {
    text += (k == 0 ? " It is " : k + 1 == spec.choices.size() ? " or " : ", ") + spec.choices[k];
  }
  return text + (says ? "" : ".");
}

void limit(Option option, const OptionSpec& spec) {
  // Other limits, of one side only, the operation checks itself.
  if (std::holds_alternative<double>(spec.fallback)) {
    if (spec.above_min && spec.min == 0 && std::isinf(spec.max)) option.positive();
    if (!spec.above_min && spec.min == 0 && std::isinf(spec.max)) option.not_negative();
    if (!spec.above_min && std::isfinite(spec.min) && std::isfinite(spec.max)) option.range(spec.min, spec.max);
  } else if (std::isfinite(spec.min) && std::isfinite(spec.max)) {
    option.range(static_cast<std::int64_t>(spec.min), static_cast<std::int64_t>(spec.max));
  }
}

// "standard --param K=1.2" of "standard K=1.2".
std::string argument_of(const std::string& input) {
  std::string text;
  for (std::size_t begin = 0, end = 0; begin < input.size(); begin = end + 1) {
    end = std::min(input.find(' ', begin), input.size());
    text += (begin == 0 ? "" : " --param ") + input.substr(begin, end - begin);
  }
  return text;
}

// The example as a command line; nothing where it has an option that the command takes in another way.
std::optional<std::string> line_of(const operations::Example& example, const operations::Operation& operation,
                                   const std::set<std::string>& besides, const std::string& command) {
  std::string line = command;
  for (const std::string& input : example.inputs) line += " " + argument_of(input);
  for (const operations::OptionSetting& setting : example.options) {
    const auto spec = std::find_if(operation.options.begin(), operation.options.end(),
                                   [&](const OptionSpec& one) { return one.is_for(setting.key); });
    if (spec == operation.options.end()) return std::nullopt;
    if (besides.contains(setting.key)) {  // choices that are flags: --stable
      if (spec->choices.empty()) return std::nullopt;
      line += " " + option_name(std::get<std::string>(setting.value));
    } else if (const bool* const flag = std::get_if<bool>(&setting.value)) {
      line += *flag ? " " + option_name(setting.key) : " --no-" + option_name(setting.key).substr(2);
    } else {
      const std::string value = operations::to_string(setting.value);
      line += " " + option_name(setting.key) + (value.starts_with('-') ? "=" : " ") + value;
    }
  }
  return line;
}

}  // namespace

std::string option_name(const std::string& key) {
  std::string name = "--" + key;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

TableOptions::TableOptions(OptionParser& parser, const operations::Operation& operation,
                           const std::set<std::string>& besides, const ExampleForm& examples) {
  for (const OptionSpec& spec : operation.options) {
    if (!besides.contains(spec.key)) add(parser, spec);
  }
  for (const operations::Example& example : operation.examples) {
    if (const auto line = line_of(example, operation, besides, parser.command() + examples.before_inputs)) {
      parser.add_example(*line + examples.at_end, example.meaning);
    }
  }
}

void TableOptions::add(OptionParser& parser, const OptionSpec& spec) {
  const std::string name = is_on(spec) ? "--no-" + option_name(spec.key).substr(2) : option_name(spec.key);
  const std::string help = help_of(spec);
  const auto add_as = [&](auto value) {
    auto& stored = std::get<decltype(value)>(values_.emplace_back(spec.key, std::move(value)).second);
    if constexpr (std::is_same_v<decltype(value), bool>) {
      return parser.add_flag(name.c_str(), stored, help.c_str());
    } else {
      return parser.add(name.c_str(), stored, help.c_str());
    }
  };
  Option option = std::holds_alternative<bool>(spec.fallback)           ? add_as(false)
                  : std::holds_alternative<std::int64_t>(spec.fallback) ? add_as(std::int64_t{0})
                  : std::holds_alternative<double>(spec.fallback)       ? add_as(0.0)
                  : std::holds_alternative<std::string>(spec.fallback)  ? add_as(std::string{})
                                                                        : add_as(std::vector<double>{});
  if (std::holds_alternative<Point>(spec.fallback)) option.comma_separated().count(2).value("X,Y");
  if (std::holds_alternative<Rectangle>(spec.fallback)) option.comma_separated().count(4).value("X0,Y0,X1,Y1");
  if (std::holds_alternative<std::vector<double>>(spec.fallback)) option.comma_separated().count(1, 1000);
  if (!spec.value.empty()) option.value(spec.value.c_str());
  if (spec.value.empty() && !spec.choices.empty()) option.value("KIND");
  if (is_on(spec)) on_.insert(spec.key);
  limit(option, spec);
  if (!spec.choices.empty()) option.one_of(spec.choices);
  if (spec.required) option.required();
  options_.emplace(spec.key, option);
}

std::vector<operations::OptionSetting> TableOptions::settings() const {
  std::vector<operations::OptionSetting> settings;
  for (const auto& [key, stored] : values_) {
    if (!options_.at(key).given()) continue;
    settings.push_back({key, std::visit(
                                 [on = on_.contains(key)](const auto& value) -> operations::OptionValue {
                                   if constexpr (std::is_same_v<std::decay_t<decltype(value)>, bool>) {
                                     return !on;
                                   } else {
                                     return value;
                                   }
                                 },
                                 stored)});
  }
  return settings;
}

operations::Options checked_options(const operations::Operation& operation,
                                    const std::vector<operations::OptionSetting>& settings) {
  try {
    return {operation.options, settings};
  } catch (const UsageError& error) {
    const std::string text = error.what();
    const std::size_t colon = std::min(text.find(": "), text.size());
    throw UsageError(option_name(text.substr(0, colon)) + text.substr(colon));
  }
}

}  // namespace lober::cli

// Options of operations: the chosen values, checked, and their one spelling in keys and exports.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "engine/base/nearest_word.hpp"
#include "engine/base/text.hpp"
#include "lober/base/error.hpp"
#include "lober/operations.hpp"

namespace lober::operations {
using detail::did_you_mean;
using detail::format_number;
using detail::joined;
namespace {

[[noreturn]] void refuse(const OptionSpec& spec, const std::string& message) {
  throw UsageError(spec.key + ": " + message);
}

const char* type_name(const OptionValue& value) {
  constexpr const char* names[] = {"true or false",  "a whole number",         "a number", "a string",
                                   "a point [x, y]", "a box [x0, y0, x1, y1]", "numbers"};
  return names[value.index()];
}

// As what the option takes them for; nothing where there are more or fewer than it has.
std::optional<OptionValue> fitted(const OptionSpec& spec, const std::vector<double>& numbers) {
  if (std::holds_alternative<std::vector<double>>(spec.fallback)) return numbers;
  if (std::holds_alternative<Point>(spec.fallback) && numbers.size() == 2) return Point{numbers[0], numbers[1]};
  if (std::holds_alternative<Rectangle>(spec.fallback) && numbers.size() == 4)
    return Rectangle{numbers[0], numbers[1], numbers[2], numbers[3]};
  return std::nullopt;
}

OptionValue checked(OptionSpec spec, const OptionSetting& setting) {
  OptionValue value = setting.value;
  spec.key = setting.key;
  if (std::holds_alternative<double>(spec.fallback) && std::holds_alternative<std::int64_t>(value)) {
    value = static_cast<double>(std::get<std::int64_t>(value));
  }
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) value = fitted(spec, *numbers).value_or(value);
  if (value.index() != spec.fallback.index()) refuse(spec, std::string("has to be ") + type_name(spec.fallback));
  if (const auto* text = std::get_if<std::string>(&value); text != nullptr && !spec.choices.empty()) {
    if (std::find(spec.choices.begin(), spec.choices.end(), *text) == spec.choices.end()) {
      refuse(spec,
             "\"" + *text + "\" cannot be read as one of " + joined(spec.choices) + did_you_mean(*text, spec.choices));
    }
  }
  double number = 0;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) number = static_cast<double>(*whole);
  if (const auto* real = std::get_if<double>(&value)) number = *real;
  if (std::holds_alternative<std::int64_t>(value) || std::holds_alternative<double>(value)) {
    if (!std::isfinite(number)) refuse(spec, "has to be a finite number");
    if (spec.above_min && !(number > spec.min)) refuse(spec, "has to be above " + format_number(spec.min));
    if (!(number >= spec.min)) refuse(spec, "has to be at least " + format_number(spec.min));
    if (!(number <= spec.max)) refuse(spec, "has to be at most " + format_number(spec.max));
  }
  for (const double one : numbers_of(value)) {
    if (!std::isfinite(one)) refuse(spec, "the numbers have to be finite");
  }
  if (const auto* box = std::get_if<Rectangle>(&value); box != nullptr && !(box->width() > 0 && box->height() > 0)) {
    refuse(spec, "the corners have to have x0 < x1 and y0 < y1");
  }
  return value;
}

std::optional<double> number_of(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && !std::isnan(number) ? std::optional(number)
                                                                                         : std::nullopt;
}

}  // namespace

Options::Options(std::span<const OptionSpec> specs, std::span<const OptionSetting> settings) {
  std::map<std::string, OptionValue> chosen, of_families;
  std::vector<OptionSetting> all;
  for (const OptionSetting& setting : settings) {
    const auto spec =
        std::find_if(specs.begin(), specs.end(), [&](const OptionSpec& any) { return any.is_for(setting.key); });
    if (spec == specs.end()) {
      std::vector<std::string> known;
      for (const OptionSpec& any : specs) known.push_back(any.key);
      throw UsageError(setting.key + ": there is no such option; there are " + joined(known) +
                       did_you_mean(setting.key, known));
    }
    (spec->family() ? of_families : chosen)[setting.key] = checked(*spec, setting);
  }
  for (const OptionSpec& spec : specs) {
    if (spec.family()) continue;
    const auto given = chosen.find(spec.key);
    if (spec.required && given == chosen.end()) refuse(spec, "is missing: the " + spec.meaning);
    if (spec.optional && given == chosen.end()) continue;
    all.push_back({spec.key, given != chosen.end() ? given->second : spec.fallback});
  }
  for (const auto& [key, value] : of_families) all.push_back({key, value});
  settings_ = std::make_shared<const std::vector<OptionSetting>>(std::move(all));
}

std::optional<Point> Options::point(std::string_view key) const {
  const OptionValue* const found = find(key);
  return found == nullptr ? std::nullopt : std::optional(std::get<Point>(*found));
}

std::vector<std::pair<std::string, double>> Options::reals_of(std::string_view prefix) const {
  std::vector<std::pair<std::string, double>> found;
  for (const OptionSetting& setting : *settings_) {
    if (!setting.key.starts_with(std::string(prefix) + ".")) continue;
    found.emplace_back(setting.key.substr(prefix.size() + 1), std::get<double>(setting.value));
  }
  return found;
}

const OptionValue* Options::find(std::string_view key) const {
  const auto found =
      std::find_if(settings_->begin(), settings_->end(), [&](const OptionSetting& any) { return any.key == key; });
  return found == settings_->end() ? nullptr : &found->value;
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
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  std::string list;
  for (const double one : numbers_of(value)) list += (list.empty() ? "" : ",") + format_number(one);
  return list;
}

std::vector<double> numbers_of(const OptionValue& value) {
  if (const auto* point = std::get_if<Point>(&value)) return {point->x, point->y};
  if (const auto* box = std::get_if<Rectangle>(&value)) return {box->min_x, box->min_y, box->max_x, box->max_y};
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  return numbers != nullptr ? *numbers : std::vector<double>{};
}

OptionValue option_value(const OptionSpec& spec, std::string_view key, const std::string& text) {
  const auto refuse_text = [&](const std::string& wanted) -> OptionValue {
    throw UsageError(std::string(key) + ": \"" + text + "\" is not " + wanted);
  };
  if (std::holds_alternative<bool>(spec.fallback)) {
    if (text == "true" || text == "1") return true;
    return text == "false" || text == "0" ? OptionValue(false) : refuse_text("true or false, 1 or 0");
  }
  if (std::holds_alternative<std::int64_t>(spec.fallback)) {
    std::int64_t whole = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), whole);
    return error == std::errc() && end == text.data() + text.size() ? OptionValue(whole)
                                                                    : refuse_text("a whole number");
  }
  if (std::holds_alternative<double>(spec.fallback)) {
    const std::optional<double> number = number_of(text);
    return number ? OptionValue(*number) : refuse_text("a number");
  }
  if (std::holds_alternative<std::string>(spec.fallback)) return text;
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::optional<double> number = number_of(std::string_view(text).substr(begin, end - begin));
    if (!number) return refuse_text("numbers with commas between");
    numbers.push_back(*number);
    begin = end + 1;
  }
  const std::optional<OptionValue> value = fitted(spec, numbers);
  return value ? *value : refuse_text(type_name(spec.fallback));
}

std::string to_string(std::span<const OptionSetting> settings) {
  std::string text;
  for (const OptionSetting& setting : settings) {
    text += (text.empty() ? "" : " ") + setting.key + "=" + to_string(setting.value);
  }
  return text;
}

std::string Options::to_string() const {
  return operations::to_string(*settings_);
}

std::vector<OptionSetting> Outcome::settings() const {
  std::vector<OptionSetting> all(options.settings().begin(), options.settings().end());
  for (const OptionSetting& one : chosen) {
    std::erase_if(all, [&](const OptionSetting& any) { return any.key == one.key; });
    all.push_back(one);
  }
  return all;
}

}  // namespace lober::operations

// The options of an operation: what there is, what was chosen, and one spelling of it that keys and exports use.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace lober::detail {

using OptionValue = std::variant<bool, std::int64_t, double, std::string>;

/// An option of an operation. The type of `fallback` is the type of the option; a whole number is taken for a
/// double too. A key "parameters.*" stands for any number of options "parameters.NAME" without a fallback.
struct OptionSpec {
  std::string key;
  OptionValue fallback;
  std::string meaning = {};
  std::vector<std::string> choices = {};  ///< of a string; empty: any
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool family() const { return key.ends_with(".*"); }
  [[nodiscard]] bool is_for(std::string_view wanted) const {
    return wanted == key || (family() && wanted.starts_with(std::string_view(key).substr(0, key.size() - 1)));
  }
};

struct OptionSetting {
  std::string key;
  OptionValue value;
};

/// All options of an operation, each with its value. Cheap to share, never changed.
class Options {
 public:
  Options() = default;
  /// Every option at its fallback, but for the settings, of which the last one for a key counts. Throws UsageError
  /// "key: what is wrong".
  Options(std::span<const OptionSpec> specs, std::span<const OptionSetting> settings);

  [[nodiscard]] bool flag(std::string_view key) const { return std::get<bool>(at(key)); }
  [[nodiscard]] std::int64_t whole(std::string_view key) const { return std::get<std::int64_t>(at(key)); }
  [[nodiscard]] double real(std::string_view key) const { return std::get<double>(at(key)); }
  [[nodiscard]] const std::string& text(std::string_view key) const { return std::get<std::string>(at(key)); }
  /// Null for one that is not there: all of the specs are, but those of families only if they were given.
  [[nodiscard]] const OptionValue* find(std::string_view key) const;
  /// Those whose keys begin with "prefix.", which is left out; by name.
  [[nodiscard]] std::vector<std::pair<std::string, double>> reals_of(std::string_view prefix) const;

  /// In the order of the specs.
  [[nodiscard]] std::span<const OptionSetting> settings() const { return settings_; }
  /// "areas_only=false index=auto": the same for the same values, whatever was spelled out.
  [[nodiscard]] std::string to_string() const;

 private:
  [[nodiscard]] const OptionValue& at(std::string_view key) const;

  std::vector<OptionSetting> settings_;
};

/// As JSON, where SQL can look into it: {"system": "henon", "parameters": {"k": 1.5}}, keys nested at their dots.
[[nodiscard]] std::string encoded_settings(const Options& options);

/// "key=value key=value".
[[nodiscard]] std::string to_string(std::span<const OptionSetting> settings);
/// A value as Options::to_string has it: numbers in the shortest form that reads back to the same bits.
[[nodiscard]] std::string to_string(const OptionValue& value);

}  // namespace lober::detail

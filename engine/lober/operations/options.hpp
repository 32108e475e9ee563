// Options of operations: how they are described, and their values.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/curve/densify.hpp"
#include "lober/curve/point.hpp"

namespace lober::operations {

/// The value of an option.
using OptionValue = std::variant<bool, std::int64_t, double, std::string, Point, Rectangle, std::vector<double>>;

/// An option. The type of `fallback` is the type of the option; a whole number is taken for a double too, and numbers
/// for a point or a rectangle: x0, y0, x1, y1. A key "parameters.*" stands for any number of options "parameters.NAME"
/// without a fallback.
struct OptionSpec {
  std::string key;                                        ///< its name in every face
  OptionValue fallback;                                   ///< the value when it is not given, which also fixes the type
  std::string meaning = {};                               ///< a phrase: "number of iterates n"
  std::vector<std::string> choices = {};                  ///< allowed values of a string; empty: any string
  double min = -std::numeric_limits<double>::infinity();  ///< the least number
  double max = std::numeric_limits<double>::infinity();   ///< the largest number
  bool above_min = false;                                 ///< min itself is excluded
  bool optional = false;  ///< absent unless given: `fallback` has its type, `otherwise` says what is done without it
  bool required = false;  ///< optional, but a value has to be given
  std::string otherwise = {};  ///< what is done without it, as a phrase
  std::string value = {};      ///< name of the value in help texts: "N"

  /// Whether it stands for any number of options.
  [[nodiscard]] bool family() const { return key.ends_with(".*"); }
  /// Whether a key names this option.
  [[nodiscard]] bool is_for(std::string_view wanted) const {
    return wanted == key || (family() && wanted.starts_with(std::string_view(key).substr(0, key.size() - 1)));
  }
};

/// An option with a value.
struct OptionSetting {
  std::string key;    ///< name of the option
  OptionValue value;  ///< its value
};

/// All options of an operation, each with its value. Cheap to share, never changed.
class LOBER_API Options {
 public:
  Options() = default;
  /// Every option has its fallback, except for the settings, where the last one for a key counts. Throws UsageError
  /// "key: what is wrong".
  Options(std::span<const OptionSpec> specs, std::span<const OptionSetting> settings);

  /// The value of a flag, which has to be there.
  [[nodiscard]] bool flag(std::string_view key) const { return std::get<bool>(at(key)); }
  /// The value of a whole number, which has to be there.
  [[nodiscard]] std::int64_t whole(std::string_view key) const { return std::get<std::int64_t>(at(key)); }
  /// The value of a number, which has to be there.
  [[nodiscard]] double real(std::string_view key) const { return std::get<double>(at(key)); }
  /// The value of a text, which has to be there.
  [[nodiscard]] const std::string& text(std::string_view key) const { return std::get<std::string>(at(key)); }
  /// The value of a point; none if it is absent.
  [[nodiscard]] std::optional<Point> point(std::string_view key) const;
  /// The value of an option; null if it is absent: all options of the specs are there, except those without a fallback
  /// that were not given.
  [[nodiscard]] const OptionValue* find(std::string_view key) const;
  /// The options whose keys begin with "prefix.", which is left out, in the order of their names.
  [[nodiscard]] std::vector<std::pair<std::string, double>> reals_of(std::string_view prefix) const;

  /// All settings in the order of the specs.
  [[nodiscard]] std::span<const OptionSetting> settings() const { return *settings_; }
  /// "areas_only=false index=auto": the same for the same values, whether they were given or not.
  [[nodiscard]] std::string to_string() const;

 private:
  [[nodiscard]] const OptionValue& at(std::string_view key) const;

  std::shared_ptr<const std::vector<OptionSetting>> settings_ = std::make_shared<const std::vector<OptionSetting>>();
};

/// The settings as "key=value key=value".
[[nodiscard]] LOBER_API std::string to_string(std::span<const OptionSetting> settings);
/// A value as Options::to_string has it: numbers in the shortest form that reads back to the same bits, points as
/// "x,y", rectangles as "x0,y0,x1,y1".
[[nodiscard]] LOBER_API std::string to_string(const OptionValue& value);
/// The numbers of a point, a rectangle or a list; empty for any other value.
[[nodiscard]] LOBER_API std::vector<double> numbers_of(const OptionValue& value);
/// The value of an option that is written as text: "true", "1e-5", "0.5,-1". Throws UsageError "key: what is wrong".
[[nodiscard]] LOBER_API OptionValue option_value(const OptionSpec& spec, std::string_view key, const std::string& text);

}  // namespace lober::operations

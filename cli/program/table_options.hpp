// The options of an operation of the table (lober/operations.hpp) on the command line: max_points is --max-points, and
// check_simple, which is true unless it is refused, --no-check-simple.
#pragma once

#include <deque>
#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "cli/program/option_parser.hpp"
#include "lober/operations.hpp"

namespace lober::cli {

/// Words of a command around the inputs and options of an example.
struct ExampleForm {
  std::string before_inputs = {}, at_end = {};
};

class TableOptions {
 public:
  /// Adds all of them but those that a command spells in its own way, with help and examples from the table. Has to
  /// stay where it is until the parser has parsed.
  TableOptions(OptionParser& parser, const operations::Operation& operation, const std::set<std::string>& besides = {},
               const ExampleForm& examples = {});
  TableOptions(const TableOptions&) = delete;
  TableOptions& operator=(const TableOptions&) = delete;

  /// The option with this key, to say more about it; the key has to be in the table.
  [[nodiscard]] Option operator[](const std::string& key) const { return options_.at(key); }
  /// The options that were given.
  [[nodiscard]] std::vector<operations::OptionSetting> settings() const;

 private:
  using Storage = std::variant<bool, std::int64_t, double, std::string, std::vector<double>>;

  void add(OptionParser& parser, const operations::OptionSpec& spec);

  std::deque<std::pair<std::string, Storage>> values_;  // parsed into, so that they stay in place
  std::map<std::string, Option> options_;
  std::set<std::string> on_;  // keys of flags that are given to refuse something
};

/// "--max-points" of "max_points".
[[nodiscard]] std::string option_name(const std::string& key);

/// The settings as the operation takes them. Throws UsageError with the names that they have here.
[[nodiscard]] operations::Options checked_options(const operations::Operation& operation,
                                                  const std::vector<operations::OptionSetting>& settings);

}  // namespace lober::cli

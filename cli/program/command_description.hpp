// A command as its parser declares it: what its help, its manual page and the completions of shells are made of.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lober::cli {

/// The groups of options in a help text, in their order.
enum class OptionGroup : std::uint8_t { inputs, computation, accuracy, results, pictures, running };

/// The values of an option, for completions.
enum class ValueKind : std::uint8_t {
  none,       ///< a flag
  other,      ///< a number or a text, which cannot be completed
  choice,     ///< one of a list
  file,       ///< read or written
  folder,     ///< an existing or a new one
  system,     ///< the name of a system, or a shared library
  parameter,  ///< NAME=VALUE of a parameter of the system
  operation,  ///< the name of an operation of the table
};

struct OptionDescription {
  std::string position;            ///< name as an argument: "C1"; empty for those that are options only
  std::vector<std::string> names;  ///< "-o", "--output"; empty for those that are arguments only
  std::string value;               ///< name of the value: "FILE"; empty for a flag. "CURVE [AGAINST]" of an argument
  std::string meaning;             ///< sentences, with default and range
  std::vector<std::string> choices;
  ValueKind kind = ValueKind::none;
  OptionGroup group = OptionGroup::computation;
  bool required = false;
  bool repeats = false;                      ///< takes any number of values
  std::vector<std::string> needs, not_with;  ///< options that have to be there too, or must not

  /// As an argument: "C1", "CURVE [AGAINST]".
  [[nodiscard]] std::string argument() const;
  /// "-o, --output FILE", "SYSTEM, --system SYSTEM", "C1".
  [[nodiscard]] std::string label() const;
  /// The meaning, and the options that it needs or excludes.
  [[nodiscard]] std::string full_meaning() const;
};

struct CommandExample {
  std::string line, meaning;
};

struct CommandDescription {
  std::string name;     ///< "lober batch run"
  std::string summary;  ///< sentences
  std::vector<CommandExample> examples;
  std::vector<OptionDescription> options;  ///< arguments first, then by group

  /// "lober densify CURVES... -o FILE [options]".
  [[nodiscard]] std::string usage() const;
};

/// "Curves and inputs".
[[nodiscard]] const char* title_of(OptionGroup group);

/// Fills in `kind` and `group`, which follow from the other members, and puts the options into their order.
void classify(CommandDescription& command);

}  // namespace lober::cli

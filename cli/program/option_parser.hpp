// The arguments and options of a command: declared in one list, then parsed. CLI11 does both; only option_parser.cpp
// includes it, since it takes longer to compile than most commands.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/program/command_description.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace lober::cli {

struct RunningOptions;

/// One of them, to say more about. A handle: valid as long as its parser.
class Option {
 public:
  Option(CLI::Option* option, std::vector<std::string>& choices) : option_(option), choices_(&choices) {}

  Option value(const char* name);  ///< what the help calls the value: "FILE"
  Option required();
  Option needs(Option other);
  Option excludes(Option other);
  Option count(int least, int most);  ///< number of values
  Option count(int exactly) { return count(exactly, exactly); }
  Option repeatable();  ///< in add_call: the function is called for each value
  Option comma_separated();
  // These three add the range to the help.
  Option positive();
  Option not_negative();  ///< and finite
  template <typename T>
  Option range(T first, T last);  ///< both of them included
  Option one_of(const std::vector<std::string>& values);
  Option bytes();  ///< a number with a unit, as 4G

  [[nodiscard]] bool given() const;  ///< after parsing

 private:
  template <typename T, typename Accepts>
  Option limited(const Accepts& accepts, const std::string& kind, const std::string& limits);

  CLI::Option* option_;
  std::vector<std::string>* choices_;  // those of one_of, for descriptions
};

class OptionParser {
 public:
  OptionParser(const char* description, const char* command);
  OptionParser(const OptionParser&) = delete;
  OptionParser& operator=(const OptionParser&) = delete;
  ~OptionParser();

  /// `names`: "C1" is an argument by its position, "-o,--output" an option; "SYSTEM,--system" may be either. T: see the
  /// end of option_parser.cpp.
  template <typename T>
  Option add(const char* names, T& variable, const char* help);
  /// Instead of setting a variable, calls `take` with the value.
  Option add_call(const char* names, const std::function<void(const std::string&)>& take, const char* help);
  Option add_flag(const char* names, bool& variable, const char* help);

  /// Adds a command line to the help, before its options: "lober grow henon", and a phrase that says what it does.
  void add_example(const std::string& line, const std::string& meaning);
  [[nodiscard]] std::string command() const;  ///< "lober grow"

  /// Adds the options that every command has (running.hpp), parses, and begins the run. Returns false when the
  /// arguments asked for help, which is then printed; throws UsageError.
  [[nodiscard]] bool parse(const std::vector<std::string>& arguments);

 private:
  [[nodiscard]] Option added(CLI::Option* option);
  [[nodiscard]] CommandDescription description() const;

  std::unique_ptr<CLI::App> app_;
  std::vector<CommandExample> examples_;
  std::map<const CLI::Option*, std::vector<std::string>> choices_;
  std::unique_ptr<RunningOptions> running_;
};

/// Runs a command whose parsers describe themselves instead of parsing: parse() returns false, as for --help, and
/// nothing is printed.
[[nodiscard]] std::vector<CommandDescription> described(const std::function<void()>& command);

/// The whole text as a number, in the C locale; nothing if it is none.
[[nodiscard]] std::optional<double> number_of(const std::string& text);

}  // namespace lober::cli

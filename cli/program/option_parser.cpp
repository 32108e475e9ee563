#include "cli/program/option_parser.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "cli/program/command_line.hpp"
#include "cli/report/text.hpp"
#include "lober/error.hpp"

namespace lober::cli {

Option Option::value(const char* name) {
  option_->type_name(name);
  return *this;
}
Option Option::required() {
  option_->required();
  return *this;
}
Option Option::needs(Option other) {
  option_->needs(other.option_);
  return *this;
}
Option Option::excludes(Option other) {
  option_->excludes(other.option_);
  return *this;
}
Option Option::count(int least, int most) {
  option_->expected(least, most);
  return *this;
}
Option Option::comma_separated() {
  option_->delimiter(',');
  return *this;
}
// CLI11 has such checks too, but its messages show small and large limits with six decimals, and its help shows limits
// beside the name of the value instead of in the text.
template <typename T, typename Accepts>
Option Option::limited(const Accepts& accepts, const std::string& kind, const std::string& limits) {
  const auto message = [accepts, kind](const std::string& text) {
    T value{};
    const bool good = CLI::detail::lexical_cast(text, value) && accepts(value);
    return good ? std::string() : text + " is not " + kind;
  };
  option_->check(message, "");
  option_->description(option_->get_description() + " Range: " + limits + ".");
  return *this;
}
Option Option::positive() {
  return limited<double>([](double value) { return value > 0; }, "a number above 0", "above 0");
}
Option Option::not_negative() {
  return limited<double>([](double value) { return value >= 0 && std::isfinite(value); }, "a number from 0 on",
                         "0 or above");
}
template <typename T>
Option Option::range(T first, T last) {
  std::string limits;
  append_all(limits, first, " to ", last);
  const std::string kind = std::is_floating_point_v<T> ? "a number from " : "a whole number from ";
  return limited<T>([first, last](T value) { return value >= first && value <= last; }, kind + limits, limits);
}
Option Option::one_of(std::initializer_list<const char*> values) {
  option_->check(CLI::IsMember(std::vector<std::string>(values.begin(), values.end())));
  return *this;
}
Option Option::bytes() {
  option_->transform(CLI::AsSizeValue(false));
  return *this;
}
bool Option::given() const {
  return option_->count() > 0;
}

OptionParser::OptionParser(const char* description, const char* command)
    : app_(std::make_unique<CLI::App>(description, command)) {
  app_->set_help_flag("-h,--help", "Print this help and exit.");
}
OptionParser::~OptionParser() = default;

template <typename T>
Option OptionParser::add(const char* names, T& variable, const char* help) {
  return Option(app_->add_option(names, variable, help));
}
Option OptionParser::add_call(const char* names, std::function<void(const std::string&)> take, const char* help) {
  return Option(app_->add_option_function<std::string>(names, take, help));
}
Option OptionParser::add_flag(const char* names, bool& variable, const char* help) {
  return Option(app_->add_flag(names, variable, help));
}

bool OptionParser::parse(const std::vector<std::string>& arguments) {
  // An empty text would mean that the option was not given: a variable of the shell that was never set.
  const auto refuse_empty = [&](const std::string& name) {
    throw UsageError(name + " has an empty value (see " + app_->get_name() + " --help)");
  };
  for (std::size_t k = 1; k < arguments.size(); ++k) {
    if (arguments[k].empty() && arguments[k - 1].starts_with('-')) refuse_empty(arguments[k - 1]);
  }
  try {
    std::vector<std::string> last_first(arguments.rbegin(), arguments.rend());  // as CLI11 takes them
    app_->parse(std::move(last_first));
  } catch (const CLI::CallForHelp&) {
    print(app_->help());
    return false;
  } catch (const CLI::ParseError& error) {
    throw UsageError(std::string(error.what()) + " (see " + app_->get_name() + " --help)");
  }
  for (const CLI::Option* option : app_->get_options()) {
    const auto& values = option->results();
    if (std::find(values.begin(), values.end(), std::string()) != values.end()) refuse_empty(option->get_name());
  }
  return true;
}

std::optional<double> number_of(const std::string& text) {
  double value = 0;
  if (!CLI::detail::lexical_cast(text, value)) return std::nullopt;
  return value;
}

// The types of values that commands have.
template Option OptionParser::add(const char*, int&, const char*);
template Option OptionParser::add(const char*, std::uint32_t&, const char*);
template Option OptionParser::add(const char*, std::uint64_t&, const char*);
template Option OptionParser::add(const char*, double&, const char*);
template Option OptionParser::add(const char*, std::string&, const char*);
template Option OptionParser::add(const char*, std::vector<double>&, const char*);
template Option OptionParser::add(const char*, std::vector<int>&, const char*);
template Option OptionParser::add(const char*, std::vector<std::string>&, const char*);
template Option OptionParser::add(const char*, std::pair<int, int>&, const char*);
template Option Option::range(int, int);
template Option Option::range(std::uint64_t, std::uint64_t);
template Option Option::range(double, double);

}  // namespace lober::cli

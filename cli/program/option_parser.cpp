#include "cli/program/option_parser.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>
#include <type_traits>
#include <utility>

#include "cli/program/command_line.hpp"
#include "cli/program/help_text.hpp"
#include "cli/program/running.hpp"
#include "cli/program/wrapped_text.hpp"
#include "cli/report/text.hpp"
#include "engine/base/nearest_word.hpp"
#include "engine/files/curve_spec.hpp"
#include "lober/base/error.hpp"

namespace lober::cli {
namespace {

// CLI11's own sentences are of its making; these say what is wrong with which option. One function for all of them.

// Where parsers describe themselves, while described() runs; null elsewhere.
thread_local std::vector<CommandDescription>* recorded_descriptions = nullptr;

std::string quoted(const std::string& text) {
  return "\"" + text + "\"";
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

bool looks_like_option(const std::string& argument) {
  return argument.size() > 1 && argument[0] == '-' && std::isdigit(static_cast<unsigned char>(argument[1])) == 0;
}

// Names an argument that the command does not know, and the option that is spelled nearly like it.
std::string about_unknown(const CLI::App& app, const std::string& argument) {
  if (!looks_like_option(argument)) return "unexpected argument " + quoted(argument);
  std::error_code ignored;
  if (std::filesystem::exists(detail::file_of_curve(argument), ignored)) {
    return "there is no option " + argument + "; the file of that name is ./" + argument;
  }
  const std::string name = argument.substr(0, argument.find('='));
  std::vector<std::string> words;  // without the dashes, which would count as letters that are right
  for (const CLI::Option* const option : app.get_options()) {
    for (const std::string& known : names_of(*option)) words.push_back(known.substr(known.find_first_not_of('-')));
  }
  const std::string word = name.substr(std::min(name.find_first_not_of('-'), name.size()));
  const std::string meant = detail::nearest_word(word, words);
  const std::string dashes = meant.size() == 1 ? "-" : "--";
  return "there is no option " + name + (meant.empty() ? "" : "; did you mean " + dashes + meant + "?");
}

// The option that a sentence of CLI11's begins with; null if none.
const CLI::Option* subject_of(const CLI::App& app, const std::string& sentence) {
  const std::string name = sentence.substr(0, sentence.find_first_of(": "));
  return app.get_option_no_throw(name);
}

std::string about_values(const CLI::Option& option) {
  const std::string form = option.get_type_name();
  const int least = option.get_items_expected_min(), most = option.get_items_expected_max();
  const auto given = static_cast<int>(option.count());
  if (given == 0) return option.get_name() + " needs a value" + (form.empty() ? "" : ", " + form);
  if (most == 1) return option.get_name() + " is given " + (given == 2 ? "twice" : std::to_string(given) + " times");
  std::string wanted = std::to_string(least);
  if (most > least) wanted += most < CLI::detail::expected_max_vector_size ? " to " + std::to_string(most) : " or more";
  return option.get_name() + " takes " + wanted + " values, " + form + ", not " + std::to_string(given);
}

std::string message_of(const CLI::App& app, const CLI::ParseError& error) {
  std::string sentence = error.what();
  const auto names_around = [&](const std::string& word, const std::string& between) {
    const std::size_t at = sentence.find(word);
    return at == std::string::npos ? sentence : sentence.substr(0, at) + between + sentence.substr(at + word.size());
  };
  // The value behind an option that is misspelt is taken for another argument, and the option may be missing.
  const std::vector<std::string> unknown = app.remaining();
  const auto mark = std::find(unknown.begin(), unknown.end(), "--");
  const auto misspelt = std::find_if(unknown.begin(), mark, looks_like_option);
  if (misspelt != mark) return about_unknown(app, *misspelt);
  const auto behind = std::find_if(mark, unknown.end(), [](const std::string& argument) { return argument != "--"; });
  if (behind != unknown.end()) return "unexpected argument " + quoted(*behind) + " behind --, which ends the options";
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    return unknown.empty() ? sentence : about_unknown(app, unknown.front());
  }
  if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr) {
    return names_around(" excludes ", " and ") + " cannot be given together";
  }
  if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr) return names_around(" requires ", " needs ");
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) return names_around(" is required", " is missing");
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    const CLI::Option* const option = subject_of(app, sentence);
    return option == nullptr ? sentence : about_values(*option);
  }
  if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) {
    const std::string before = "Could not convert: ", between = " = ";
    const std::size_t at = sentence.find(between);
    if (!sentence.starts_with(before) || at == std::string::npos) return sentence;
    const std::string name = sentence.substr(before.size(), at - before.size());
    const CLI::Option* const option = app.get_option_no_throw(name);
    if (option != nullptr && option->get_items_expected_max() == 0) return name + " takes no value";
    const std::string form = option == nullptr ? std::string() : option->get_type_name();
    return name + ": " + quoted(sentence.substr(at + between.size())) + " cannot be read as " +
           (form.find(',') == std::string::npos ? "a number" : form);
  }
  return sentence;
}

}  // namespace

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
Option Option::repeatable() {
  option_->trigger_on_parse();
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
Option Option::one_of(const std::vector<std::string>& allowed) {
  *choices_ = allowed;
  std::string list;
  for (std::size_t k = 0; k < allowed.size(); ++k) {
    list += (k == 0 ? "" : k + 1 == allowed.size() ? " or " : ", ") + allowed[k];
  }
  option_->check(
      [allowed, list](const std::string& text) {
        const bool good = std::find(allowed.begin(), allowed.end(), text) != allowed.end();
        return good ? std::string() : quoted(text) + " is not " + list + detail::did_you_mean(text, allowed);
      },
      "");
  return *this;
}
Option Option::bytes() {
  option_->transform(CLI::Validator(
      [](std::string& text) {
        const std::string given = text;
        try {
          if (!given.starts_with('-') && CLI::AsSizeValue(false)(text).empty()) return std::string();
        } catch (const CLI::ParseError&) {  // a unit that it does not know
        }
        return quoted(given) + " is not a size such as 4G, 500M or 64k";
      },
      ""));
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
  return added(app_->add_option(names, variable, help));
}
Option OptionParser::add_call(const char* names, const std::function<void(const std::string&)>& take,
                              const char* help) {
  return added(app_->add_option_function<std::string>(names, take, help));
}
Option OptionParser::add_flag(const char* names, bool& variable, const char* help) {
  return added(app_->add_flag(names, variable, help));
}
Option OptionParser::added(CLI::Option* option) {
  return {option, choices_[option]};
}

void OptionParser::add_example(const std::string& line, const std::string& meaning) {
  examples_.push_back({line, meaning});
}
std::string OptionParser::command() const {
  return app_->get_name();
}

CommandDescription OptionParser::description() const {
  CommandDescription command{app_->get_name(), app_->get_description(), examples_, {}};
  const std::vector<const CLI::Option*> options = std::as_const(*app_).get_options();
  // The names of those in the set, in the order in which they were added.
  const auto names_in = [&](const std::set<CLI::Option*>& set) {
    std::vector<std::string> names;
    for (const CLI::Option* const one : options) {
      const bool is_in = std::any_of(set.begin(), set.end(), [&](const CLI::Option* other) { return other == one; });
      if (is_in) names.push_back(one->get_name());
    }
    return names;
  };
  for (const CLI::Option* const option : options) {
    OptionDescription one;
    if (option->get_positional()) one.position = option->get_name(true);
    one.names = names_of(*option);
    if (option->get_items_expected_max() > 0) one.value = option->get_type_name();
    if (one.value == "TEXT" && !one.position.empty()) one.value = one.position;
    one.meaning = option->get_description();
    if (const auto found = choices_.find(option); found != choices_.end()) one.choices = found->second;
    one.required = option->get_required();
    one.repeats = option->get_items_expected_max() >= CLI::detail::expected_max_vector_size;
    one.needs = names_in(option->get_needs());
    one.not_with = names_in(option->get_excludes());
    command.options.push_back(std::move(one));
  }
  classify(command);
  return command;
}

bool OptionParser::parse(const std::vector<std::string>& arguments) {
  running_ = std::make_unique<RunningOptions>();
  add_running_options(*this, *running_);
  if (recorded_descriptions != nullptr) {
    recorded_descriptions->push_back(description());
    return false;
  }
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
    print(help_text(description(), text_width()));
    return false;
  } catch (const CLI::ParseError& error) {
    throw UsageError(message_of(*app_, error) + " (see " + app_->get_name() + " --help)");
  }
  for (const CLI::Option* option : app_->get_options()) {
    const auto& values = option->results();
    if (std::find(values.begin(), values.end(), std::string()) != values.end()) refuse_empty(option->get_name());
  }
  begin_run(app_->get_name(), *running_);
  return true;
}

std::vector<CommandDescription> described(const std::function<void()>& command) {
  std::vector<CommandDescription> found;
  std::vector<CommandDescription>* const before = std::exchange(recorded_descriptions, &found);
  try {
    command();
  } catch (...) {
    recorded_descriptions = before;
    throw;
  }
  recorded_descriptions = before;
  return found;
}

std::optional<double> number_of(const std::string& text) {
  double value = 0;
  if (!CLI::detail::lexical_cast(text, value)) return std::nullopt;
  return value;
}

// The types of values that commands have.
template Option OptionParser::add(const char*, int&, const char*);
template Option OptionParser::add(const char*, std::int64_t&, const char*);
template Option OptionParser::add(const char*, std::uint32_t&, const char*);
template Option OptionParser::add(const char*, std::uint64_t&, const char*);
template Option OptionParser::add(const char*, double&, const char*);
template Option OptionParser::add(const char*, std::string&, const char*);
template Option OptionParser::add(const char*, std::vector<double>&, const char*);
template Option OptionParser::add(const char*, std::vector<int>&, const char*);
template Option OptionParser::add(const char*, std::vector<std::string>&, const char*);
template Option OptionParser::add(const char*, std::pair<int, int>&, const char*);
template Option Option::range(int, int);
template Option Option::range(std::int64_t, std::int64_t);
template Option Option::range(std::uint64_t, std::uint64_t);
template Option Option::range(double, double);

}  // namespace lober::cli

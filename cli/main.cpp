// The program: finds out which command is wanted, and turns each error into one line and an exit status.

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/doctor/build.hpp"
#include "cli/generate/generate_command.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/commands.hpp"
#include "cli/program/interrupt.hpp"
#include "cli/program/log.hpp"
#include "cli/program/program_help.hpp"
#include "cli/program/running.hpp"
#include "cli/program/terminal.hpp"
#include "cli/program/wrapped_text.hpp"
#include "cli/published/published_form.hpp"
#include "cli/published/published_tangle.hpp"
#include "engine/base/input_guard.hpp"
#include "engine/base/nearest_word.hpp"
#include "engine/files/curve_spec.hpp"
#include "kernels/cpu.hpp"
#include "lober/base/agreement.hpp"
#include "lober/base/cancellation.hpp"
#include "lober/base/error.hpp"
#include "lober/base/version.hpp"

namespace lober::cli {
namespace {

// A misspelt name would quietly run the best copies.
void check_instruction_set() {
  const char* const asked = std::getenv("LOBER_ISA");
  const auto names = detail::instruction_set_names();
  if (asked == nullptr || std::find(names.begin(), names.end(), asked) != names.end()) return;
  throw UsageError(std::string("LOBER_ISA is ") + asked +
                   ", which is not an instruction set; set it to baseline, avx2 or avx512");
}

// The command that a word is a slip of, or empty. The published forms take any word for a file, and the last one for a
// file to write.
std::string command_meant(const std::string& word) {
  std::error_code ignored;
  if (word.empty() || word.front() == '-' || std::filesystem::exists(detail::file_of_curve(word), ignored)) return {};
  return detail::nearest_word(word, command_names());
}

// The option of the program itself that a word is a slip of, or empty.
std::string option_meant(const std::string& word) {
  const std::vector<std::string> known{"--help", "--version", "--generate"};
  return word.starts_with("--") ? detail::nearest_word(word.substr(0, word.find('=')), known) : std::string();
}

// "-:2,3", columns of standard input, would be taken for an option.
std::vector<std::string> with_standard_input(std::vector<std::string> arguments) {
  for (std::string& argument : arguments) {
    if (argument.starts_with("-:") || argument.starts_with("-#")) argument.replace(0, 1, "/dev/stdin");
  }
  return arguments;
}

void print_version(const std::vector<std::string>& options) {
  std::string text = std::string("lober ") + version() + "\n";
  for (const std::string& option : options) {
    if (option != "--verbose" && option != "-v") {
      throw UsageError("--version takes no other option than --verbose, not " + option);
    }
    const std::size_t width = text_width();
    text += wrapped(build_text(), width) + "\n" + wrapped(library_text(), width) + "\n";
  }
  print(text);
}

// `lober help overlay`, `lober help batch run`.
void print_help(const std::vector<std::string>& words) {
  if (words.empty()) return print(program_help(text_width()));
  if (!is_command(words[0])) {
    throw UsageError("there is no command \"" + words[0] + "\"" + detail::did_you_mean(words[0], command_names()) +
                     " (see lober --help)");
  }
  std::vector<std::string> arguments(words.begin() + 1, words.end());
  arguments.emplace_back("--help");
  run_command(words[0], arguments);
}

bool asks_for_version(std::span<const std::string> arguments) {
  return std::find(arguments.begin(), arguments.end(), "--version") != arguments.end();
}

void run_program(const std::vector<std::string>& arguments) {
  check_instruction_set();
  if (arguments.empty()) throw UsageError("no command is given (see lober --help)");
  const detail::InputGuard guard;
  const std::string& first = arguments[0];
  const std::vector<std::string> rest(arguments.begin() + 1, arguments.end());
  if (first == "--help" || first == "-h" || (first == "help" && rest.empty())) {
    print_help({});
  } else if (first == "help" && !std::filesystem::exists(first)) {  // a file could be meant, in a published form
    print_help(rest);
  } else if (first == "--version") {
    print_version(rest);
  } else if (first == "--generate" || first.starts_with("--generate=")) {
    run_generate(arguments);
  } else if (is_command(first)) {
    asks_for_version(rest) ? print_version({}) : run_command(first, rest);
  } else if (const std::string meant = command_meant(first); !meant.empty()) {
    throw UsageError("\"" + first + "\" is neither a command nor a file; did you mean " + meant +
                     "? (see lober --help)");
  } else if (const std::string option = option_meant(first); !option.empty()) {
    throw UsageError("unknown option " + first + "; did you mean " + option + "? (see lober --help)");
  } else {
    begin_run("lober", {});  // the published forms have no options of ours
    is_published_tangle(arguments) ? run_published_tangle(arguments) : run_published_form(arguments);
  }
}

// Exactly one line, whatever the message holds, and nothing that a terminal obeys.
int fail(std::string message, int status) {
  end_run(status);
  std::replace(message.begin(), message.end(), '\n', ' ');
  log_error(printable(message));
  return status;
}

int guarded(const std::vector<std::string>& arguments) {
  watch_for_interrupt();
  const CancellationScope cancellation(interrupt_flag());
  try {
    run_program(arguments);
    end_work();
    end_run(0);
    return 0;
  } catch (const UsageError& error) {
    return fail(error.what(), 2);
  } catch (const DisagreementError& error) {
    return fail(error.what(), 3);
  } catch (const Cancelled& error) {
    return fail(error.what(), 130);
  } catch (const std::bad_alloc&) {
    return fail("out of memory", 1);
  } catch (const std::exception& error) {
    return fail(error.what(), 1);
  }
}

}  // namespace
}  // namespace lober::cli

int main(int count, char** arguments) {
  // Standard output belongs to results. Warnings and errors go to standard error, more with --verbose.
  lober::cli::begin_log("lober");
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of the write, with a message
  return lober::cli::guarded(lober::cli::with_standard_input({arguments + 1, arguments + count}));
}

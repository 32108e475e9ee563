#include "cli/command_line.hpp"

#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "cli/output_names.hpp"
#include "engine/curve/curve_spec.hpp"
#include "engine/curve/output_file.hpp"
#include "engine/error.hpp"
#include "engine/parallel/parallel.hpp"

namespace lober::cli {
namespace {

namespace fs = std::filesystem;

bool same_file(const std::string& first, const std::string& second) {
  if (first == second) return true;
  std::error_code ignored;
  if (fs::equivalent(first, second, ignored)) return true;
  return fs::weakly_canonical(fs::absolute(first), ignored) == fs::weakly_canonical(fs::absolute(second), ignored);
}

// "-" is what standard input was redirected from.
std::string input_path(const std::string& spec) {
  return spec == "-" ? "/dev/stdin" : file_of_curve(spec);
}

// Pipes and devices can take several outputs, and opening them has effects.
bool is_special(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return path == "-" || (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
}

}  // namespace

void print(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) throw DataError("standard output cannot be written");
}

void check_outputs(std::span<const Output> outputs, std::span<const std::string> inputs) {
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const Output& output = outputs[k];
    for (const Output& earlier : outputs.first(k)) {
      if (earlier.path == "-" ? output.path == "-" : !is_special(output.path) && same_file(earlier.path, output.path)) {
        throw UsageError(earlier.option + " and " + output.option + " both write " + output.path);
      }
    }
    if (is_special(output.path)) continue;
    for (const std::string& input : inputs) {
      if (same_file(input_path(input), output.path)) {
        throw UsageError(output.option + " would overwrite the input " + output.path);
      }
    }
  }
  for (const Output& output : outputs) {
    if (!is_special(output.path)) require_fitting_name(output.option, output.path);
  }
  for (const Output& output : outputs) {
    // Opens a temporary file beside it, and removes that again.
    if (!is_special(output.path)) OutputFile probe(output.path);
  }
}

bool takes_standard_output(std::span<const Output> outputs) {
  return std::any_of(outputs.begin(), outputs.end(), [](const Output& output) { return output.path == "-"; });
}

bool parse_arguments(CLI::App& app, const std::vector<std::string>& arguments) {
  try {
    std::vector<std::string> last_first(arguments.rbegin(), arguments.rend());  // as CLI11 takes them
    app.parse(std::move(last_first));
  } catch (const CLI::CallForHelp&) {
    print(app.help());
    return false;
  } catch (const CLI::ParseError& error) {
    throw UsageError(std::string(error.what()) + " (see " + app.get_name() + " --help)");
  }
  // An empty text would mean that the option was not given: a variable of the shell that was never set.
  for (const CLI::Option* option : app.get_options()) {
    const auto& values = option->results();
    if (option->count() > 0 && std::find(values.begin(), values.end(), std::string()) != values.end()) {
      throw UsageError(option->get_name() + " is given an empty text (see " + app.get_name() + " --help)");
    }
  }
  return true;
}

void add_threads_option(CLI::App& app, int& threads) {
  app.add_option("--threads", threads, "how many (default: all); the results are the same bits")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
}

void add_index_option(CLI::App& app, IndexKind& kind) {
  app.add_option_function<std::string>(
         "--index", [&kind](const std::string& name) { kind = index_kind(name); },
         "auto (default), tree, grid or kd; the results are the same bits")
      ->type_name("KIND")
      ->check(CLI::IsMember({"auto", "tree", "grid", "kd"}));
}

void with_thread_limit(int threads, const std::function<void()>& function) {
  // The arena sets how many threads work; the global limit lets there be more of them than the machine has cores.
  std::optional<tbb::global_control> limit;
  if (threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }
  with_threads(threads, function);
}

}  // namespace lober::cli

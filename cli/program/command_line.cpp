#include "cli/program/command_line.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "cli/program/output_names.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/files/curve_spec.hpp"
#include "engine/files/output_file.hpp"
#include "lober/error.hpp"

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

void add_threads_option(OptionParser& parser, int& threads) {
  parser.add("--threads", threads, "how many (default: all); the results are the same bits").value("N").range(1, 4096);
}

void add_index_option(OptionParser& parser, IndexKind& kind) {
  parser
      .add_call(
          "--index", [&kind](const std::string& name) { kind = index_kind(name); },
          "auto (default), tree, grid or kd; the results are the same bits")
      .value("KIND")
      .one_of({"auto", "tree", "grid", "kd"});
}

void with_thread_limit(int threads, const std::function<void()>& function) {
  with_threads(threads, function);
}

}  // namespace lober::cli

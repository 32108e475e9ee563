#include "cli/program/command_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <optional>

#include "cli/program/output_names.hpp"
#include "cli/program/terminal.hpp"
#include "cli/program/written_files.hpp"
#include "engine/base/output_file.hpp"
#include "engine/files/curve_spec.hpp"
#include "lober/base/error.hpp"
#include "lober/base/threads.hpp"
#include "lober/curve/cylinders.hpp"

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
  const std::string file = detail::file_of_curve(spec);
  return file == "-" ? "/dev/stdin" : file;
}

// Pipes and devices can take several outputs, and opening them has effects.
bool is_special(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return path == "-" || (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
}

}  // namespace

void print(std::string_view text) {
  bool written = false;
  write_above_status_line(
      [&] { written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0; });
  if (!written) throw DataError("standard output cannot be written");
}

void check_outputs(std::span<const Output> outputs, std::span<const std::string> inputs) {
  // A file that is redirected can be opened again as /dev/stdin; a pipe cannot.
  const auto is_standard = [](const std::string& input) {
    const std::string file = detail::file_of_curve(input);
    return file == "-" || (file == "/dev/stdin" && is_special(file));
  };
  if (std::count_if(inputs.begin(), inputs.end(), is_standard) > 1) {
    throw UsageError(
        "standard input is named twice and can be read once; write it to a file, and name its zones, FILE#0 and "
        "FILE#1");
  }
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const Output& output = outputs[k];
    for (const Output& earlier : outputs.first(k)) {
      if (earlier.path == "-" ? output.path == "-" : !is_special(output.path) && same_file(earlier.path, output.path)) {
        throw UsageError(earlier.option + " and " + output.option + " both write " + output.path +
                         "; name a file for each");
      }
    }
    if (is_special(output.path)) continue;
    for (const std::string& input : inputs) {
      if (same_file(input_path(input), output.path)) {
        throw UsageError(output.option + " would overwrite the input " + output.path + "; name another file");
      }
    }
  }
  for (const Output& output : outputs) {
    if (!is_special(output.path)) require_fitting_name(output.option, output.path, output.format);
  }
  for (const Output& output : outputs) {
    // Opens a temporary file beside it, and removes that again.
    if (is_special(output.path)) continue;
    { detail::OutputFile probe(output.path); }
    expect_written(output.option, output.path);
  }
}

std::vector<Output> checked_outputs(std::initializer_list<Output> named, std::span<const std::string> inputs,
                                    std::vector<Output> further) {
  std::vector<Output> outputs = std::move(further);
  std::copy_if(named.begin(), named.end(), std::back_inserter(outputs),
               [](const Output& output) { return !output.path.empty(); });
  check_outputs(outputs, inputs);
  return outputs;
}

bool takes_standard_output(std::span<const Output> outputs) {
  return std::any_of(outputs.begin(), outputs.end(), [](const Output& output) { return output.path == "-"; });
}

namespace {

void take_period_option(const std::string& text, Periods& periods) {
  if (take_period(text, periods)) return;
  throw UsageError("--periodic: \"" + text + "\" is not x=PERIOD or y=PERIOD, such as x=2pi");
}

}  // namespace

void add_periodic_option(OptionParser& parser, Periods& periods) {
  parser
      .add_call(
          "--periodic", [&periods](const std::string& text) { take_period_option(text, periods); },
          "The period of a coordinate: x=1, y=360 or x=2pi. Curves that were stored modulo it are followed across the "
          "seam, and the second curve is moved by whole periods to the first. May be given for both coordinates.")
      .value("x=PERIOD")
      .repeatable();
}

void add_curve_arguments(OptionParser& parser, std::array<std::string, 2>& curves, Periods& periods) {
  parser.add("C1", curves[0], "The first curve: FILE, or FILE#ZONE for one zone of it (by number from 0, or by title).")
      .required();
  parser.add("C2", curves[1], "The second curve, in the same form.").required();
  add_periodic_option(parser, periods);
}

void add_points_option(OptionParser& parser, std::string& path, std::string& format, bool required) {
  std::string help =
      "Write the points to FILE, whose ending is its format: " + written_endings() + "; - is text on standard output";
  help += required ? "." : " (default: no file).";
  Option option = parser.add("-o,--output", path, help.c_str()).value("FILE");
  if (required) option.required();
  add_format_option(parser, format).needs(option);
}

Option add_format_option(OptionParser& parser, std::string& format) {
  return parser.add("--format", format, "The format of curves that are written (default: by the ending of FILE).")
      .value("KIND")
      .one_of(written_formats());
}

void add_json_option(OptionParser& parser, std::string& path, const std::string& what) {
  const std::string help = "Write " + what + " to FILE as one JSON object; - is standard output (default: no file).";
  parser.add("--json", path, help.c_str()).value("FILE");
}

void add_threads_option(OptionParser& parser, int& threads) {
  parser
      .add("--threads", threads,
           "The number of threads (default: one per core). The results are the same bits for any number.")
      .value("N")
      .range(1, max_threads);
}

Option add_memory_option(OptionParser& parser, std::uint64_t& bytes, const char* help) {
  return parser.add("--memory", bytes, help).bytes().range(std::uint64_t{1}, std::uint64_t{1} << 60).value("SIZE");
}

void add_reverse_option(OptionParser& parser, std::array<bool, 2>& reverse) {
  parser
      .add_call(
          "--reverse",
          [&reverse](const std::string& which) {
            reverse = {which != "s", which != "u"};
          },
          "The manifolds whose points run inward, toward the fixed point, and are taken in reverse order: u, s or "
          "both (default: neither).")
      .value("WHICH")
      .one_of({"u", "s", "both"});
}

}  // namespace lober::cli

// Common parts of the commands: where to print, and which outputs are acceptable.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/program/option_parser.hpp"
#include "lober/curve/periods.hpp"
#include "lober/curve/point.hpp"
#include "lober/tangle/tangle.hpp"

namespace lober::cli {

/// Prints to standard output; throws DataError when that fails (a full disk).
void print(std::string_view text);

/// An output file as named on the command line; `option` is how the user named it, for messages.
struct Output {
  std::string option;
  std::string path;
  std::string format = {};  ///< as --format names it, whatever the ending is
};

/// Refuses, before any work is done, outputs that would overwrite each other or an input, outputs whose names say
/// another format than is written (UsageError; output_names.hpp), and outputs that cannot be written (DataError).
/// `inputs` may carry a zone (FILE#ZONE). OutputFile refuses to replace inputs that are not known yet, such as the
/// files that a manifest names (engine/base/input_guard.hpp).
void check_outputs(std::span<const Output> outputs, std::span<const std::string> inputs);

/// The outputs that were named, and further ones, checked.
[[nodiscard]] std::vector<Output> checked_outputs(std::initializer_list<Output> named,
                                                  std::span<const std::string> inputs,
                                                  std::vector<Output> further = {});

/// Whether one of the files is standard output, which holds one thing only: then nothing else is printed there.
[[nodiscard]] bool takes_standard_output(std::span<const Output> outputs);

// Options that several commands have, in one spelling and with one text.

/// C1 and C2, closed curves, and --periodic.
void add_curve_arguments(OptionParser& parser, std::array<std::string, 2>& curves, Periods& periods);
/// --periodic x=2pi of curves that are read (ReadOptions::periods).
void add_periodic_option(OptionParser& parser, Periods& periods);
/// -o FILE, of points, and --format of it.
void add_points_option(OptionParser& parser, std::string& path, std::string& format, bool required);
/// --format KIND of the files of curves.
Option add_format_option(OptionParser& parser, std::string& format);
/// --json FILE. `what` is written to it.
void add_json_option(OptionParser& parser, std::string& path, const std::string& what = "the results");
/// --threads N, for run_with_threads (lober/threads.hpp).
void add_threads_option(OptionParser& parser, int& threads);
/// --memory SIZE: "4G", "500M", "64k" or bytes.
Option add_memory_option(OptionParser& parser, std::uint64_t& bytes, const char* help);
/// --reverse u|s|both, of two manifolds U and S.
void add_reverse_option(OptionParser& parser, std::array<bool, 2>& reverse);

}  // namespace lober::cli

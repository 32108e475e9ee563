// What the commands share: where to print, and which outputs are acceptable.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/program/option_parser.hpp"
#include "lober/index.hpp"

namespace lober::cli {

/// Prints to standard output; throws DataError when that fails (a full disk).
void print(std::string_view text);

/// An output file as named on the command line; `option` is how the user named it, for messages.
struct Output {
  std::string option;
  std::string path;
};

/// Refuses, before any work is done, outputs that would overwrite each other or an input, outputs whose names say
/// another format than is written (UsageError; output_names.hpp), and outputs that cannot be written (DataError).
/// `inputs` may carry a zone (FILE#ZONE). What is not known yet, as the files that a manifest names, OutputFile refuses
/// to replace (engine/base/input_guard.hpp).
void check_outputs(std::span<const Output> outputs, std::span<const std::string> inputs);

/// Whether one of the files is standard output, which holds one thing only: then nothing else is printed there.
[[nodiscard]] bool takes_standard_output(std::span<const Output> outputs);

/// --threads N, for with_thread_limit.
void add_threads_option(OptionParser& parser, int& threads);
/// --index KIND.
void add_index_option(OptionParser& parser, IndexKind& kind);

/// Runs the function with so many threads, also more than the machine has cores; 0: one for each.
void with_thread_limit(int threads, const std::function<void()>& function);

}  // namespace lober::cli

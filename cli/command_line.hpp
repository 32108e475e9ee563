// What the commands share: where to print, and which outputs are acceptable.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lober::cli {

/// Prints to standard output; throws DataError when that fails (a full disk).
void print(std::string_view text);

/// An output file as named on the command line; `option` is how the user named it, for messages.
struct Output {
  std::string option;
  std::string path;
};

/// Refuses, before any work is done, outputs that would overwrite each other or an input (UsageError) and
/// outputs that cannot be written (DataError). `inputs` may carry a zone (FILE#ZONE).
void check_outputs(std::span<const Output> outputs, std::span<const std::string> inputs);

}  // namespace lober::cli

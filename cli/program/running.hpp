// The options that every command has, --progress, --quiet and --verbose, and the run that they are about: from the
// arguments that were parsed to the exit status. One run a process; all of this is process-wide, as the log is.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cli/program/option_parser.hpp"

namespace lober::cli {

enum class ProgressKind : std::uint8_t {
  automatic,  ///< a line on a terminal, once two seconds have passed
  json,       ///< an object a line on standard error
  none,
};

struct RunningOptions {
  ProgressKind progress = ProgressKind::automatic;
  bool quiet = false;    ///< neither the line nor hints; warnings and errors stay
  bool verbose = false;  ///< messages of log_info, and the time of each phase in the end
};

/// --progress, --quiet and --verbose; OptionParser adds them to each command.
void add_running_options(OptionParser& parser, RunningOptions& options);

/// Work begins: "lober batch run". Later calls change nothing.
void begin_run(const std::string& command, const RunningOptions& options);
/// Work has ended, whose exit status that will be: wipes the line away, or writes the last object; with --verbose
/// reports the seconds of each phase; names the files that were written, to those who want hints. Before the message of
/// an error.
void end_run(int status);

/// An error that spoils one output only, so that the work and the other outputs are not lost: `end_work` throws the
/// first of them, UsageError, once all is written.
void keep_error(const std::string& message);
void end_work();

/// Those of the run; the defaults where none has begun.
[[nodiscard]] const RunningOptions& running_options();
/// Whether somebody wants hints: standard error is a terminal, and --quiet was not given.
[[nodiscard]] bool wants_hints();

/// The seconds of parts that the engine has measured, instead of those of the phases of Progress, for --verbose.
void report_seconds(const std::vector<std::pair<std::string, double>>& parts);

}  // namespace lober::cli

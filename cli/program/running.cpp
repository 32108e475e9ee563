#include "cli/program/running.hpp"

#include <cstdio>
#include <memory>
#include <string_view>

#include "cli/program/log.hpp"
#include "cli/program/meter.hpp"
#include "cli/program/terminal.hpp"
#include "cli/program/written_files.hpp"
#include "lober/base/error.hpp"

namespace lober::cli {
namespace {

std::unique_ptr<Meter> the_meter;
std::string kept_error;  // the first one

std::string_view status_of(int exit_status) {
  return exit_status == 0 ? "done" : exit_status == 130 ? "interrupted" : "failed";
}

}  // namespace

Meter* run_meter() {
  return the_meter.get();
}

void add_running_options(OptionParser& parser, RunningOptions& options) {
  parser
      .add_call(
          "--progress",
          [&options](const std::string& kind) {
            options.progress = kind == "json"   ? ProgressKind::json
                               : kind == "none" ? ProgressKind::none
                                                : ProgressKind::automatic;
          },
          "Report on standard error how far the work is: auto, a line on a terminal once two seconds have passed; "
          "json, "
          "for programs, an object of JSON a line at most five times a second; none (default: auto).")
      .value("KIND")
      .one_of({"auto", "json", "none"});
  parser.add_flag("-q,--quiet", options.quiet,
                  "Print neither the line of progress nor hints on standard error; warnings and errors stay.");
  parser.add_flag("-v,--verbose", options.verbose,
                  "Print the time that each phase took, in seconds, on standard error.");
}

void begin_run(const std::string& command, const RunningOptions& options) {
  if (the_meter) return;
  if (options.verbose) show_all_messages();
  the_meter = std::make_unique<Meter>(command, options);
}

void end_run(int status) {
  if (!the_meter) return;
  the_meter->end(status_of(status));
  if (the_meter->options().verbose) log_info(the_meter->seconds_text());
  if (wants_hints()) std::fputs(written_files_text().c_str(), stderr);
}

void keep_error(const std::string& message) {
  if (kept_error.empty()) kept_error = message;
}

void end_work() {
  if (!kept_error.empty()) throw UsageError(kept_error);
}

const RunningOptions& running_options() {
  static const RunningOptions defaults;
  return the_meter ? the_meter->options() : defaults;
}

bool wants_hints() {
  return the_meter && !the_meter->options().quiet && is_error_terminal();
}

void report_seconds(const std::vector<std::pair<std::string, double>>& parts) {
  if (the_meter) the_meter->report_seconds(parts);
}

}  // namespace lober::cli

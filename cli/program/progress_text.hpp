// How far a command is, as a line for people and as an object for programs.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lober::cli {

/// All that is known about it.
struct ProgressState {
  std::string what;             ///< the phase, or the last step
  double fraction = 0;          ///< fraction of the whole command, from 0 to 1; 0 when nothing is known
  double amount = 0;            ///< done so far, in units of ...
  std::string_view unit;        ///< ... for example points; empty when nothing is counted
  double seconds = 0;           ///< since the command began
  double next_step = 0;         ///< seconds until the next step, by the growth of the steps so far; 0 when not known
  double counting_seconds = 0;  ///< since the counting began; 0: since the command began
};

/// Units a second; 0 where nothing is counted.
[[nodiscard]] double rate_of(const ProgressState& state);
/// The seconds that are left, if the rest goes as fast; nothing while too little is done to tell.
[[nodiscard]] std::optional<double> seconds_left(const ProgressState& state);

/// For example "tubes: 43 %, 1.2e+05 points, 9.8e+03 points/s, 12 s, about 16 s left". A line longer than `width`
/// characters has a shorter `what`, or is cut.
[[nodiscard]] std::string progress_line(const ProgressState& state, std::size_t width = 1000);

/// The object of --progress json, on one line with a line feed (docs/reference/program.md). `status` is "running",
/// "done", "failed" or "interrupted".
[[nodiscard]] std::string progress_json(const std::string& command, const ProgressState& state,
                                        std::string_view status);

}  // namespace lober::cli

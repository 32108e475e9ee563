// The progress of a command, for people: one line on standard error, only on a terminal, and only for work that takes
// more than two seconds.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "engine/base/growth_forecast.hpp"
#include "engine/base/stopwatch.hpp"

namespace lober::cli {

/// The content of the line.
struct ProgressState {
  std::string what;       ///< the phase, or the last step
  double fraction = 0;    ///< fraction of the whole command, from 0 to 1; 0 when nothing is known
  double amount = 0;      ///< done so far, in units of ...
  std::string_view unit;  ///< ... for example points; empty when nothing is counted
  double seconds = 0;     ///< since the command began
  double next_step = 0;   ///< seconds until the next step, by the growth of the steps so far; 0 when not known
};

/// For example "tubes: 43 %, 1.2e+05 points, 9.8e+03 points/s, 12 s, about 16 s left".
[[nodiscard]] std::string progress_line(const ProgressState& state);

class Progress {
 public:
  Progress();
  ~Progress();  ///< wipes the line away
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// A phase begins; it is the part from `begin` to `end`, fractions of the whole. Throws Cancelled after an interrupt
  /// from the keyboard.
  void phase(std::string_view name, double begin, double end);

  /// How far the phase is, from 0 to 1. Returns false when the user has interrupted.
  bool advance(double fraction);

  /// How much is done by now, for example of points; the line reports the rate too.
  void count(double amount, std::string_view unit);
  /// The same from now on by the fraction of the whole, of which there is so much.
  void of(double total, std::string_view unit);

  /// Calls write() with the line wiped away: for results that are printed before the end.
  void above(const std::function<void()>& write);

  /// A step has begun, one of a sequence whose length nobody knows but whose members grow about evenly; nothing new
  /// when it has no name. Returns as `advance`.
  bool step(std::string_view what);

 private:
  class Line;
  double begin_ = 0, end_ = 0, total_ = 0;
  std::string_view total_unit_;
  std::unique_ptr<Line> line_;  ///< none unless standard error is a terminal
};

/// The progress of an operation: lines where nobody knows how much there is to do.
[[nodiscard]] std::function<bool(double fraction, const std::string& line)> told_to(Progress& progress);

}  // namespace lober::cli

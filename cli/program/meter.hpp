// The state of a run, and how far it is: Progress sets it, a thread of its own shows it, so that the clock
// goes on inside long phases.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "cli/program/progress_text.hpp"
#include "cli/program/running.hpp"
#include "engine/base/growth_forecast.hpp"
#include "engine/base/stopwatch.hpp"

namespace lober::cli {

class Meter {
 public:
  /// Starts the thread if there is somebody who looks.
  Meter(std::string command, const RunningOptions& options);
  ~Meter();
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;

  /// The functions may be called by any thread. A phase of the same name as the one before goes on with it.
  void phase(std::string_view name);
  void step(std::string_view what);
  void label(std::string_view what);  ///< what is shown, within the phase
  void fraction(double of_the_whole);
  void count(double amount, std::string_view unit);
  /// The files that are read from now on are the part from `begin` to `end` of the whole, each `share` of it.
  void expect_file(double begin, double share);
  void report_seconds(const std::vector<std::pair<std::string, double>>& parts);

  /// Stops the thread; wipes the line away or writes the last object.
  void end(std::string_view status);
  /// "seconds: reading 0.0012, overlay 0.0345, total 0.0400".
  [[nodiscard]] std::string seconds_text() const;
  [[nodiscard]] const RunningOptions& options() const { return options_; }

 private:
  void show_lines();
  void show_objects();
  [[nodiscard]] ProgressState snapshot();
  void write_object(std::string_view status);
  void end_phase();

  const std::string command_;
  const RunningOptions options_;
  std::mutex mutex_;
  std::condition_variable wake_;
  detail::Stopwatch watch_;
  ProgressState state_;
  detail::GrowthForecast forecast_;  // seconds that steps take
  double step_begin_ = -1, counting_begin_ = 0;
  double file_begin_ = 0, file_share_ = 0;  // fractions of the whole
  std::uint64_t file_shown_ = 0;
  double file_seen_ = 0;
  std::string phase_;
  double phase_begin_ = 0;
  std::vector<std::pair<std::string, double>> seconds_;  // phases that have ended
  bool measured_ = false;                                // by the engine instead
  bool stop_ = false;
  std::thread thread_;
};

/// The meter of the run; null where none has begun.
[[nodiscard]] Meter* run_meter();

}  // namespace lober::cli

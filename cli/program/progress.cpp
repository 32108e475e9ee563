#include "cli/program/progress.hpp"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <thread>

#include "cli/program/interrupt.hpp"
#include "lober/base/error.hpp"

namespace lober::cli {
namespace {

std::string format_duration(double seconds) {
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

std::string progress_line(const ProgressState& state) {
  std::string line = state.what + ":";
  const bool known = state.fraction >= 0.01;
  if (known) line += fmt::format(" {:.0f} %,", 100 * state.fraction);
  if (!state.unit.empty() && state.amount > 0) {
    line += fmt::format(" {:.3g} {}, {:.3g} {}/s,", state.amount, state.unit,
                        state.amount / std::max(state.seconds, 1e-9), state.unit);
  }
  line += " " + format_duration(state.seconds);
  if (known) {
    line += ", about " + format_duration(state.seconds * (1 - state.fraction) / state.fraction) + " left";
  } else if (state.next_step > 0) {
    line += ", next step in about " + format_duration(state.next_step);
  } else {
    line += ", time left not known yet";
  }
  return line;
}

// Draws from a thread of its own, so that the clock goes on inside long phases.
class Progress::Line {
 public:
  Line() : thread_([this] { run(); }) {}
  ~Line() {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
    }
    wake_.notify_one();
    thread_.join();
  }

  /// Calls change(state) when nobody looks.
  template <typename Change>
  void set(const Change& change) {
    const std::lock_guard lock(mutex_);
    change(state_);
  }

  void step(std::string_view what) {
    const std::lock_guard lock(mutex_);
    const double now = watch_.seconds();
    if (steps_begun_) forecast_.add(std::max(now - step_begin_, 1e-6));
    steps_begun_ = true;
    step_begin_ = now;
    state_.what = what;
  }

 private:
  void run() {
    using namespace std::chrono_literals;
    std::unique_lock lock(mutex_);
    if (wake_.wait_for(lock, 2s, [&] { return stop_; })) return;
    bool drawn = false;
    do {
      if (interrupted()) break;  // its own line is there now
      draw();
      drawn = true;
    } while (!wake_.wait_for(lock, 200ms, [&] { return stop_; }));
    if (drawn && !interrupted()) std::fputs("\r\x1b[K", stderr);
  }

  void draw() {
    state_.seconds = watch_.seconds();
    state_.next_step = steps_begun_ ? std::max(forecast_.next() - (state_.seconds - step_begin_), 0.0) : 0;
    std::fputs(("\r\x1b[K" + progress_line(state_)).c_str(), stderr);
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  detail::Stopwatch watch_;
  ProgressState state_;
  detail::GrowthForecast forecast_;  // seconds that steps take
  bool steps_begun_ = false;
  double step_begin_ = 0;
  bool stop_ = false;
  std::thread thread_;
};

Progress::Progress() {
  if (isatty(STDERR_FILENO) != 0) line_ = std::make_unique<Line>();
}

Progress::~Progress() = default;

void Progress::phase(std::string_view name, double begin, double end) {
  begin_ = begin;
  end_ = end;
  if (line_) line_->set([&](ProgressState& state) { state.what = name; });
  if (!advance(0)) throw Cancelled();
}

bool Progress::advance(double fraction) {
  if (line_) {
    line_->set([&](ProgressState& state) {
      state.fraction = begin_ + fraction * (end_ - begin_);
      if (total_ <= 0) return;
      state.amount = total_ * state.fraction;
      state.unit = total_unit_;
    });
  }
  return !interrupted();
}

void Progress::count(double amount, std::string_view unit) {
  if (!line_) return;
  line_->set([&](ProgressState& state) {
    state.amount = amount;
    state.unit = unit;
  });
}

void Progress::of(double total, std::string_view unit) {
  total_ = total;
  total_unit_ = unit;
}

void Progress::above(const std::function<void()>& write) {
  if (!line_) return write();
  line_->set([&](ProgressState&) {
    std::fputs("\r\x1b[K", stderr);
    write();
  });
}

bool Progress::step(std::string_view what) {
  if (line_ && !what.empty()) line_->step(what);
  return !interrupted();
}

std::function<bool(double, const std::string&)> told_to(Progress& progress) {
  return [&progress](double fraction, const std::string& line) {
    return std::isnan(fraction) ? progress.step(line) : progress.advance(fraction);
  };
}

}  // namespace lober::cli

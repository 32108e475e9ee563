#include "cli/program/meter.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "cli/program/interrupt.hpp"
#include "cli/program/terminal.hpp"
#include "engine/base/file_activity.hpp"

namespace lober::cli {
namespace {

using namespace std::chrono_literals;
constexpr std::chrono::milliseconds first_line_after = 2s, between_reports = 200ms;

// Phases in which the files tell more than the phase.
bool is_about_files(const std::string& phase) {
  return phase.empty() || phase == "reading" || phase == "writing";
}

}  // namespace

Meter::Meter(std::string command, const RunningOptions& options) : command_(std::move(command)), options_(options) {
  if (options.progress == ProgressKind::json) {
    thread_ = std::thread([this] { show_objects(); });
  } else if (options.progress == ProgressKind::automatic && !options.quiet && is_error_terminal()) {
    thread_ = std::thread([this] { show_lines(); });
  }
}

Meter::~Meter() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Meter::end_phase() {
  const double now = watch_.seconds();
  if (!phase_.empty() && !measured_) {
    if (seconds_.empty() || seconds_.back().first != phase_) seconds_.emplace_back(phase_, 0);
    seconds_.back().second += now - phase_begin_;
  }
  phase_begin_ = now;
}

void Meter::phase(std::string_view name) {
  const std::lock_guard lock(mutex_);
  end_phase();
  phase_ = name;
  state_.what = name;
  step_begin_ = -1;
  forecast_ = {};
}

void Meter::step(std::string_view what) {
  const std::lock_guard lock(mutex_);
  const double now = watch_.seconds();
  if (step_begin_ >= 0) forecast_.add(std::max(now - step_begin_, 1e-6));
  step_begin_ = now;
  state_.what = what;
}

void Meter::label(std::string_view what) {
  const std::lock_guard lock(mutex_);
  state_.what = what;
}

void Meter::fraction(double of_the_whole) {
  const std::lock_guard lock(mutex_);
  state_.fraction = of_the_whole;
}

void Meter::count(double amount, std::string_view unit) {
  const std::lock_guard lock(mutex_);
  if (unit != state_.unit || amount < state_.amount) counting_begin_ = watch_.seconds();
  state_.amount = amount;
  state_.unit = unit;
}

void Meter::expect_file(double begin, double share) {
  const std::lock_guard lock(mutex_);
  file_begin_ = begin;
  file_share_ = share;
}

void Meter::report_seconds(const std::vector<std::pair<std::string, double>>& parts) {
  const std::lock_guard lock(mutex_);
  seconds_ = parts;
  measured_ = true;
}

ProgressState Meter::snapshot() {
  ProgressState state = state_;
  state.seconds = watch_.seconds();
  state.next_step = step_begin_ < 0 ? 0 : std::max(forecast_.next() - (state.seconds - step_begin_), 0.0);
  state.counting_seconds = state.seconds - counting_begin_;
  const std::optional<detail::FileActivity> file = detail::file_activity();
  if (state.what.empty()) state.what = "starting";
  if (!file || !is_about_files(phase_)) return state;
  if (file_shown_ != file->number) {
    file_shown_ = file->number;
    file_seen_ = state.seconds;
  }
  state.what = (file->is_written ? "writing " : "reading ") + std::filesystem::path(file->path).filename().string();
  state.fraction = file->is_written ? 0 : file_begin_ + file_share_ * file->fraction;
  state.amount = file->bytes / 1e6;
  state.unit = "MB";
  state.counting_seconds = state.seconds - file_seen_;
  return state;
}

void Meter::show_lines() {
  std::unique_lock lock(mutex_);
  const auto stopped = [&] { return stop_; };
  if (wake_.wait_for(lock, first_line_after, stopped)) return;
  do {
    if (interrupted()) break;  // its own line is there now
    draw_status_line(progress_line(snapshot(), error_terminal_width() - 1));
  } while (!wake_.wait_for(lock, between_reports, stopped));
  wipe_status_line();
}

void Meter::show_objects() {
  std::unique_lock lock(mutex_);
  do {
    write_object("running");
  } while (!wake_.wait_for(lock, between_reports, [&] { return stop_; }));
}

void Meter::write_object(std::string_view status) {
  ProgressState state = snapshot();
  if (status == "done") {
    state.what = "done";
    state.fraction = 1;
  }
  const std::string line = progress_json(command_, state, status);
  write_above_status_line([&] {
    std::fwrite(line.data(), 1, line.size(), stderr);
    std::fflush(stderr);
  });
}

void Meter::end(std::string_view status) {
  {
    const std::lock_guard lock(mutex_);
    end_phase();
    stop_ = true;
  }
  if (!thread_.joinable()) return;
  wake_.notify_one();
  thread_.join();
  if (options_.progress == ProgressKind::json) write_object(status);
}

std::string Meter::seconds_text() const {
  std::string text = "seconds: ";
  for (const auto& [name, seconds] : seconds_) text += fmt::format("{} {:.4f}, ", name, seconds);
  return text + fmt::format("total {:.4f}", watch_.seconds());
}

}  // namespace lober::cli

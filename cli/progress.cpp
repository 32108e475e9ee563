#include "cli/progress.hpp"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <string>
#include <thread>

#include "cli/interrupt.hpp"
#include "engine/error.hpp"

namespace lober::cli {

// Draws from a thread of its own, so that the clock goes on inside long phases.
class Progress::Ticker {
 public:
  Ticker() : thread_([this] { run(); }) {}
  ~Ticker() {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
    }
    wake_.notify_one();
    thread_.join();
  }

  void set(std::string_view phase) {
    const std::lock_guard lock(mutex_);
    phase_ = phase;
  }
  void set(double fraction) {
    const std::lock_guard lock(mutex_);
    fraction_ = fraction;
  }

 private:
  void run() {
    using namespace std::chrono_literals;
    const auto start = std::chrono::steady_clock::now();
    std::unique_lock lock(mutex_);
    if (wake_.wait_for(lock, 1s, [&] { return stop_; })) return;
    do {
      draw(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    } while (!wake_.wait_for(lock, 100ms, [&] { return stop_; }));
    std::fputs("\r\x1b[K", stderr);
  }

  void draw(double seconds) const {
    constexpr int width = 30;
    const int done = static_cast<int>(fraction_ * width);
    const std::string bar =
        std::string(static_cast<std::size_t>(done), '=') + std::string(static_cast<std::size_t>(width - done), ' ');
    std::fputs(fmt::format("\r\x1b[K[{}] {:3.0f} %  {:.1f} s  {}", bar, 100 * fraction_, seconds, phase_).c_str(),
               stderr);
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  std::string phase_;
  double fraction_ = 0;
  bool stop_ = false;
  std::thread thread_;
};

Progress::Progress() {
  watch_for_interrupt();
  if (isatty(STDERR_FILENO) != 0) ticker_ = std::make_unique<Ticker>();
}

Progress::~Progress() = default;

void Progress::phase(std::string_view name, double begin, double end) {
  begin_ = begin;
  end_ = end;
  if (ticker_) ticker_->set(name);
  if (!advance(0)) throw Cancelled();
}

bool Progress::advance(double fraction) {
  if (ticker_) ticker_->set(begin_ + fraction * (end_ - begin_));
  return !interrupted();
}

}  // namespace lober::cli

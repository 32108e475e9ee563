#include "engine/base/time_limit.hpp"

#include <chrono>
#include <cmath>

namespace lober::detail {

TimeLimit::TimeLimit(const Stopwatch& watch, double seconds) {
  if (!std::isfinite(seconds)) return;
  thread_ = std::thread([this, &watch, seconds] {
    std::unique_lock lock(mutex_);
    while (!over_ && !passed_) {
      if (watch.seconds() > seconds) {
        passed_ = true;
      } else {
        ends_.wait_for(lock, std::chrono::milliseconds(20));
      }
    }
  });
}

TimeLimit::~TimeLimit() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  ends_.notify_all();
  thread_.join();
}

}  // namespace lober::detail

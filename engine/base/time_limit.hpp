// A limit of time that ends work where it is, not only between its steps.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "engine/base/stopwatch.hpp"

namespace lober::detail {

/// Raises a flag for a CancellationScope once the watch shows more than `seconds`; looks fifty times a second. An
/// infinite limit costs nothing. The watch must outlive it.
class TimeLimit {
 public:
  TimeLimit(const Stopwatch& watch, double seconds);
  ~TimeLimit();
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;

  [[nodiscard]] const std::atomic<bool>& flag() const { return passed_; }
  [[nodiscard]] bool passed() const { return passed_; }

 private:
  std::atomic<bool> passed_{false};
  bool over_ = false;  // the work that is limited
  std::mutex mutex_;
  std::condition_variable ends_;
  std::thread thread_;
};

}  // namespace lober::detail

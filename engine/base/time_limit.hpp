// A limit of time that ends work where it is, not only between its steps.
#pragma once

#include <atomic>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <thread>
#include <utility>

#include "engine/base/stopwatch.hpp"
#include "lober/base/cancellation.hpp"
#include "lober/base/error.hpp"

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

/// A budget of seconds as a limit: 0 stands for none.
[[nodiscard]] inline double seconds_of(double budget) {
  return budget > 0 ? budget : std::numeric_limits<double>::infinity();
}

/// Does work until the watch shows more than `seconds`: false when that ended it. Throws what `work` throws, and
/// Cancelled when something else than the limit cancelled it.
template <typename Work>
bool done_within(const Stopwatch& watch, double seconds, Work&& work) {
  const TimeLimit limit(watch, seconds);
  try {
    const CancellationScope limited(limit.flag());
    std::forward<Work>(work)();
    return true;
  } catch (const Cancelled&) {
    if (!limit.passed()) throw;
  }
  throw_if_cancelled();  // by a scope around it
  return false;
}

}  // namespace lober::detail

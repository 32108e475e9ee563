#include "engine/c/progress.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

#include "lober/base/cancellation.hpp"
#include "lober/base/error.hpp"
#include "lober/lober.h"

namespace lober::detail::c {
namespace {

thread_local lober_progress progress_function = nullptr;
thread_local void* progress_context = nullptr;
thread_local bool in_progress_function = false;

}  // namespace

std::function<bool(double)> progress() {
  if (!progress_function) return {};
  return [function = progress_function, context = progress_context](double fraction) {
    in_progress_function = true;
    const bool goes_on = function(fraction, context) != 0;
    in_progress_function = false;
    return goes_on;
  };
}

void refuse_in_progress_function() {
  if (in_progress_function) {
    throw UsageError("a progress function cannot call lober; let it return, and call lober afterwards");
  }
}

void run_watched(const std::atomic<double>& done, const std::function<void()>& work) {
  const std::function<bool(double)> report = progress();
  if (!report) return work();
  std::atomic<bool> cancelled{false};
  std::mutex mutex;
  std::condition_variable_any ended;
  const auto watch = [&](const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    while (!ended.wait_for(lock, stop, std::chrono::milliseconds(100), [] { return false; }) &&
           !stop.stop_requested()) {
      if (!report(done)) return cancelled.store(true);
    }
  };
  const std::jthread timer(watch);  // stops and is joined when work has ended, however it did
  const CancellationScope scope(cancelled);
  work();
}

}  // namespace lober::detail::c

void lober_set_progress(lober_progress function, void* context) {
  lober::detail::c::progress_function = function;
  lober::detail::c::progress_context = context;
}

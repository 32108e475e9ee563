// Tasks that may start further ones, on the threads of the present arena (private to jobs/). They ask what the thread
// that starts them asks whether they are cancelled.
#pragma once

#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <utility>

#include "engine/parallel/cancellation.hpp"

#ifdef __SANITIZE_THREAD__
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#endif

namespace lober {

#ifdef __SANITIZE_THREAD__

// On plain threads, for the reason that engine/parallel/plain_threads.hpp gives.
class LaneTasks {
 public:
  template <typename Task>
  void start(Task task) {
    const std::lock_guard lock(mutex_);
    threads_.emplace_back([this, task, scope = CancellationScope::current()] {
      const detail::InheritedCancellation inherited(scope);
      try {
        task();
      } catch (...) {
        const std::lock_guard error_lock(mutex_);
        if (!error_) error_ = std::current_exception();
      }
    });
  }
  void wait() {
    for (;;) {
      std::thread next;
      {
        const std::lock_guard lock(mutex_);
        if (threads_.empty()) break;
        next = std::move(threads_.back());
        threads_.pop_back();
      }
      next.join();
    }
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::mutex mutex_;
  std::vector<std::thread> threads_;
  std::exception_ptr error_;
};

template <typename Function>
void isolated(const Function& function) {
  function();
}

#else

class LaneTasks {
 public:
  template <typename Task>
  void start(Task task) {
    group_.run([task = std::move(task), scope = CancellationScope::current()] {
      const detail::InheritedCancellation inherited(scope);
      task();
    });
  }
  /// Passes on what a task threw.
  void wait() { group_.wait(); }

 private:
  tbb::task_group group_;
};

/// A thread that waits inside `function` does nothing but work that it started.
template <typename Function>
void isolated(const Function& function) {
  tbb::this_task_arena::isolate(function);
}

#endif

}  // namespace lober

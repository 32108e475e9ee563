// The same as parallel.hpp with plain threads, for ThreadSanitizer only (private to parallel/).
//
// oneTBB as Debian ships it is not instrumented: ThreadSanitizer cannot see that a task starts after it was spawned and
// ends before it is waited for, and takes every hand-over for a race. Under it the work runs on std::thread, which it
// understands. Pieces, their contents and all that our code does on them are the same.
#pragma once

#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace lober {

/// Calls piece(k) for each k < count, on as many threads as the present arena would give, but at most four.
template <typename Piece>
void on_plain_threads(std::size_t count, const Piece& piece) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr error;
  const auto work = [&] {
    for (std::size_t k = next++; k < count; k = next++) {
      try {
        piece(k);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!error) error = std::current_exception();
        next = count;
      }
    }
  };
  const auto allowed = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  std::vector<std::thread> threads;
  for (std::size_t k = 1; k < std::min({allowed, count, std::size_t{4}}); ++k) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (error) std::rethrow_exception(error);
}

}  // namespace lober

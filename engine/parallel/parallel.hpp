// The one place where threads come from: a thin cover of oneTBB.
//
// Nothing in the engine may depend on the number of threads, so work is cut into pieces of a size that the *data*
// decides, never the machine, and whatever a piece produces is joined in the order of the pieces.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cstddef>
#include <utility>

namespace lober {

#ifdef __SANITIZE_THREAD__
/// oneTBB as Debian ships it is not instrumented, so ThreadSanitizer cannot see that a task starts after it was spawned
/// and ends before it is waited for. This tells it, and nothing more: any other order between tasks has to be real.
class TaskOrder {
 public:
  void before() { edge_.fetch_add(1, std::memory_order_release); }
  void after() { (void)edge_.load(std::memory_order_acquire); }
  template <typename Function>
  void task(Function&& function) {
    after();
    function();
    before();
  }

 private:
  std::atomic<unsigned> edge_{0};
};
#else
class TaskOrder {
 public:
  void before() {}
  void after() {}
  template <typename Function>
  void task(Function&& function) {
    function();
  }
};
#endif

/// Calls body(begin, end) for [0, size) cut into pieces of exactly `grain` (the last one may be shorter), in
/// parallel when there is more than one.
template <typename Body>
void for_each_block(std::size_t size, std::size_t grain, const Body& body) {
  const std::size_t blocks = (size + grain - 1) / grain;
  if (blocks <= 1) {
    if (size != 0) body(std::size_t{0}, size);
    return;
  }
  TaskOrder order;
  order.before();
  tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
    const std::size_t begin = block * grain;
    order.task([&] { body(begin, begin + grain < size ? begin + grain : size); });
  });
  order.after();
}

/// Runs the functions side by side when `worthwhile`, one after the other when not.
template <typename... Functions>
void run_together(bool worthwhile, Functions&&... functions) {
  if (worthwhile) {
    TaskOrder order;
    order.before();
    tbb::parallel_invoke([&] { order.task(functions); }...);
    order.after();
  } else {
    (functions(), ...);
  }
}

/// Runs `function` with at most `threads` threads (0: as many as the machine has) and returns what it returns.
template <typename Function>
auto with_threads(int threads, Function&& function) {
  if (threads <= 0) return function();
  tbb::task_arena arena(threads);
  return arena.execute(std::forward<Function>(function));
}

}  // namespace lober

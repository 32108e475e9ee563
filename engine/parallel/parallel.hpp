// The one place where threads come from: a thin cover of oneTBB.
//
// Nothing in the engine may depend on the number of threads, so work is cut into pieces of a size that the *data*
// decides, never the machine, and whatever a piece produces is joined in the order of the pieces.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <utility>

#include "engine/parallel/cancellation.hpp"

#ifdef __SANITIZE_THREAD__
#include <array>
#include <functional>

#include "engine/parallel/plain_threads.hpp"
#endif

namespace lober {

namespace detail {
/// An exception in a loop around this one makes oneTBB leave out the pieces that have not begun, here too, and return
/// as if nothing were missing. What is missing must not be used.
inline void require_complete(tbb::task_group_context& context) {
  if (context.is_group_execution_cancelled()) throw_cancelled();
}
}  // namespace detail

/// Calls body(begin, end) for [0, size) cut into pieces of exactly `grain` (the last one may be shorter), in
/// parallel when there is more than one. Throws Cancelled between pieces (cancellation.hpp), and what a piece throws.
template <typename Body>
void for_each_block(std::size_t size, std::size_t grain, const Body& body) {
  const std::size_t blocks = (size + grain - 1) / grain;
  if (blocks <= 1) {
    if (size == 0) return;
    throw_if_cancelled();
    return body(std::size_t{0}, size);
  }
  const CancellationScope* const scope = CancellationScope::current();
  const auto piece = [&](std::size_t block) {
    const detail::InheritedCancellation inherited(scope);
    throw_if_cancelled();
    const std::size_t begin = block * grain;
    body(begin, begin + grain < size ? begin + grain : size);
  };
#ifdef __SANITIZE_THREAD__
  on_plain_threads(blocks, piece);
#else
  tbb::task_group_context context;
  tbb::parallel_for(std::size_t{0}, blocks, piece, context);
  detail::require_complete(context);
#endif
}

/// Runs the functions side by side when `worthwhile`, one after the other when not. They ask what the caller asks
/// whether they are cancelled.
template <typename... Functions>
void run_together(bool worthwhile, Functions&&... functions) {
  if (worthwhile) {
    const CancellationScope* const scope = CancellationScope::current();
    const auto inheriting = [scope](auto& function) {
      return [scope, &function] {
        const detail::InheritedCancellation inherited(scope);
        function();
      };
    };
#ifdef __SANITIZE_THREAD__
    const std::array<std::function<void()>, sizeof...(functions)> tasks{inheriting(functions)...};
    on_plain_threads(tasks.size(), [&](std::size_t k) { tasks[k](); });
#else
    tbb::task_group_context context;
    tbb::parallel_invoke(inheriting(functions)..., context);
    detail::require_complete(context);
#endif
  } else {
    (functions(), ...);
  }
}

/// Runs `function` with at most `threads` threads (0: as many as the machine has) and returns what it returns.
template <typename Function>
auto with_threads(int threads, Function&& function) {
  if (threads <= 0) return function();
  tbb::task_arena arena(threads);
  const CancellationScope* const scope = CancellationScope::current();
  return arena.execute([&] {
    const detail::InheritedCancellation inherited(scope);
    return function();
  });
}

}  // namespace lober

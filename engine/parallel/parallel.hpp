// The one place where threads come from: a thin cover of oneTBB.
//
// Nothing in the engine may depend on the number of threads, so work is cut into pieces of a size that the *data*
// decides, never the machine, and whatever a piece produces is joined in the order of the pieces.
#pragma once

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <optional>
#include <utility>

#include "engine/parallel/handover.hpp"

namespace lober {

/// Calls body(begin, end) for [0, size) cut into pieces of exactly `grain` (the last one may be shorter), in
/// parallel when there is more than one.
template <typename Body>
void for_each_block(std::size_t size, std::size_t grain, const Body& body) {
  const std::size_t blocks = (size + grain - 1) / grain;
  if (blocks <= 1) {
    if (size != 0) body(std::size_t{0}, size);
    return;
  }
  HandedOver work;
  tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) LOBER_UNSEEN {
    const HandedOver::Part part(work);
    const std::size_t begin = block * grain;
    body(begin, begin + grain < size ? begin + grain : size);
  });
}

/// Runs the functions side by side when `worthwhile`, one after the other when not.
template <typename... Functions>
void run_together(bool worthwhile, Functions&&... functions) {
  if (worthwhile) {
    HandedOver work;
    tbb::parallel_invoke([&]() LOBER_UNSEEN {
      const HandedOver::Part part(work);
      functions();
    }...);
  } else {
    (functions(), ...);
  }
}

/// Runs `function` with at most `threads` threads, also more than the machine has cores (0: one for each), and returns
/// what it returns.
template <typename Function>
auto with_threads(int threads, Function&& function) {
  if (threads <= 0) return function();
  // An arena has as many places as it is asked for, but oneTBB makes no more workers than there are cores until a limit
  // that is higher allows it. Of several limits the lowest holds, so none is set that would hold others back.
  std::optional<tbb::global_control> limit;
  if (threads > tbb::info::default_concurrency()) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }
  tbb::task_arena arena(threads);
  HandedOver work;
  return arena.execute([&]() LOBER_UNSEEN {
    const HandedOver::Part part(work);
    return function();
  });
}

}  // namespace lober

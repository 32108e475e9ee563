// Work on a long sequence of blocks in parallel and take the results in the order of the blocks.
#pragma once

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <vector>

#include "engine/parallel/parallel.hpp"

namespace lober {

/// Until `next(slot)` returns false: `next(slot)` takes the next block (one call at a time), `work(slot)`
/// handles it (in parallel), `deliver(slot)` uses the result (one call at a time, in the order of `next`). A
/// slot is used again after it was delivered, so its buffers stay warm in the cache. What `deliver` throws is
/// what the caller sees: with errors reported there and nowhere else, the first one in the order of the
/// blocks wins on every machine. Throws Cancelled between blocks.
template <typename Slot, typename Next, typename Work, typename Deliver>
void ordered_pipeline(const Next& next, const Work& work, const Deliver& deliver) {
  // Enough to keep every thread busy while one block is late.
  const std::size_t in_flight = 3 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  std::vector<Slot> slots(in_flight);
#ifdef __SANITIZE_THREAD__
  for (bool more = true; more;) {  // the same round by round (plain_threads.hpp)
    std::size_t taken = 0;
    throw_if_cancelled();
    while (taken < in_flight && (more = next(slots[taken]))) ++taken;
    for_each_block(taken, 1, [&](std::size_t k, std::size_t) { work(slots[k]); });
    for (std::size_t k = 0; k < taken; ++k) deliver(slots[k]);
  }
#else
  const CancellationScope* const scope = CancellationScope::current();
  // Slot k is free when block number k + in_flight starts: no more than `in_flight` blocks are under way, and
  // they end in order.
  std::size_t blocks = 0;
  tbb::task_group_context context;
  tbb::parallel_pipeline(
      in_flight,
      tbb::make_filter<void, Slot*>(tbb::filter_mode::serial_in_order,
                                    [&](tbb::flow_control& control) -> Slot* {
                                      const detail::InheritedCancellation inherited(scope);
                                      throw_if_cancelled();
                                      Slot* slot = &slots[blocks % in_flight];
                                      if (next(*slot)) {
                                        ++blocks;
                                        return slot;
                                      }
                                      control.stop();
                                      return nullptr;
                                    }) &
          tbb::make_filter<Slot*, Slot*>(tbb::filter_mode::parallel,
                                         [&](Slot* slot) {
                                           const detail::InheritedCancellation inherited(scope);
                                           work(*slot);
                                           return slot;
                                         }) &
          tbb::make_filter<Slot*, void>(tbb::filter_mode::serial_in_order, [&](Slot* slot) { deliver(*slot); }),
      context);
  detail::require_complete(context);
#endif
}

}  // namespace lober

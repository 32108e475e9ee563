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
  const CancellationScope* const scope = CancellationScope::current();
  // Slot k is free when block number k + in_flight starts: no more than `in_flight` blocks are under way, and
  // they end in order.
  std::size_t blocks = 0;
  std::vector<HandOver> handed_on(in_flight);  // of each slot, from step to step
  HandOver next_again, deliver_again;          // from one call to the next
  tbb::task_group_context context;
  HandedOver pipeline;
  const auto take = [&](tbb::flow_control& control) LOBER_UNSEEN -> Slot* {
    const HandedOver::Part part(pipeline);
    const detail::InheritedCancellation inherited(scope);
    throw_if_cancelled();
    next_again.acquire();
    Slot* slot = &slots[blocks % in_flight];
    HandOver& hand_over = handed_on[blocks % in_flight];
    hand_over.acquire();
    const bool taken = next(*slot);
    if (taken) ++blocks;
    hand_over.release();
    next_again.release();
    if (taken) return slot;
    control.stop();
    return nullptr;
  };
  const auto handle = [&](Slot* slot) LOBER_UNSEEN {
    const HandedOver::Part part(pipeline);
    const detail::InheritedCancellation inherited(scope);
    HandOver& hand_over = handed_on[static_cast<std::size_t>(slot - slots.data())];
    hand_over.acquire();
    work(*slot);
    hand_over.release();
    return slot;
  };
  const auto use = [&](Slot* slot) LOBER_UNSEEN {
    const HandedOver::Part part(pipeline);
    HandOver& hand_over = handed_on[static_cast<std::size_t>(slot - slots.data())];
    hand_over.acquire();
    deliver_again.acquire();
    deliver(*slot);
    deliver_again.release();
    hand_over.release();
  };
  tbb::parallel_pipeline(in_flight,
                         tbb::make_filter<void, Slot*>(tbb::filter_mode::serial_in_order, take) &
                             tbb::make_filter<Slot*, Slot*>(tbb::filter_mode::parallel, handle) &
                             tbb::make_filter<Slot*, void>(tbb::filter_mode::serial_in_order, use),
                         context);
  detail::require_complete(context);
}

}  // namespace lober

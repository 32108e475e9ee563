#include "engine/base/parallel/ordered_pipeline.hpp"

#include <tbb/parallel_pipeline.h>

#include "engine/base/parallel/complete.hpp"
#include "engine/base/parallel/handover.hpp"
#include "engine/base/parallel/parallel.hpp"

namespace lober::detail {

std::size_t pipeline_slots() {
  return 3 * static_cast<std::size_t>(concurrency());
}

void run_pipeline(std::size_t slots, std::size_t taken, FunctionRef<bool(std::size_t)> next,
                  FunctionRef<void(std::size_t)> work, FunctionRef<void(std::size_t)> deliver) {
  const CancellationScope* const scope = CancellationScope::current();
  // Slot k is free when block number k + slots starts: no more than `slots` blocks are under way, and they end in
  // order.
  std::size_t blocks = 0;
  std::vector<HandOver> handed_on(slots);  // hand-over of each slot, from step to step
  HandOver next_again, deliver_again;      // from one call to the next
  tbb::task_group_context context;
  HandedOver pipeline;
  const auto take = [&](tbb::flow_control& control) LOBER_UNSEEN -> std::size_t {
    const HandedOver::Part part(pipeline);
    const InheritedCancellation inherited(scope);
    throw_if_cancelled();
    next_again.acquire();
    const std::size_t slot = blocks % slots;
    HandOver& hand_over = handed_on[slot];
    hand_over.acquire();
    const bool is_taken = blocks < taken || next(slot);
    if (is_taken) ++blocks;
    hand_over.release();
    next_again.release();
    if (!is_taken) control.stop();
    return slot;
  };
  const auto handle = [&](std::size_t slot) LOBER_UNSEEN {
    const HandedOver::Part part(pipeline);
    const InheritedCancellation inherited(scope);
    HandOver& hand_over = handed_on[slot];
    hand_over.acquire();
    work(slot);
    hand_over.release();
    return slot;
  };
  const auto use = [&](std::size_t slot) LOBER_UNSEEN {
    const HandedOver::Part part(pipeline);
    HandOver& hand_over = handed_on[slot];
    hand_over.acquire();
    deliver_again.acquire();
    deliver(slot);
    deliver_again.release();
    hand_over.release();
  };
  tbb::parallel_pipeline(slots,
                         tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, take) &
                             tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel, handle) &
                             tbb::make_filter<std::size_t, void>(tbb::filter_mode::serial_in_order, use),
                         context);
  require_complete(context);
}

}  // namespace lober::detail

// Work on a long sequence of blocks in parallel and take the results in the order of the blocks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "engine/base/parallel/function_ref.hpp"
#include "lober/base/cancellation.hpp"

namespace lober::detail {

/// Slots that a pipeline has: enough to keep every thread busy while one block is late.
[[nodiscard]] std::size_t pipeline_slots();
/// The functions take the number of a slot. The first `taken` blocks are in their slots already.
void run_pipeline(std::size_t slots, std::size_t taken, FunctionRef<bool(std::size_t)> next,
                  FunctionRef<void(std::size_t)> work, FunctionRef<void(std::size_t)> deliver);

/// Until `next(slot)` returns false: `next(slot)` takes the next block (one call at a time), `work(slot)`
/// handles it (in parallel), `deliver(slot)` uses the result (one call at a time, in the order of `next`). A
/// slot is used again after it was delivered, so its buffers stay warm in the cache. What `deliver` throws is
/// what the caller sees: with errors reported there and nowhere else, the first one in the order of the
/// blocks wins on every machine. Throws Cancelled between blocks.
///
/// A single block is handled by the calling thread: on small files a program would spend more time on starting threads
/// than on all else.
template <typename Slot, typename Next, typename Work, typename Deliver>
void ordered_pipeline(const Next& next, const Work& work, const Deliver& deliver) {
  std::vector<Slot> slots(2);
  throw_if_cancelled();
  if (!next(slots[0])) return;
  if (!next(slots[1])) {
    work(slots[0]);
    return deliver(slots[0]);
  }
  slots.resize(std::max(slots.size(), pipeline_slots()));
  run_pipeline(
      slots.size(), 2, [&](std::size_t k) -> bool { return next(slots[k]); }, [&](std::size_t k) { work(slots[k]); },
      [&](std::size_t k) { deliver(slots[k]); });
}

}  // namespace lober::detail

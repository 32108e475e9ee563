#include "engine/base/parallel/parallel.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "engine/base/parallel/complete.hpp"
#include "engine/base/parallel/handover.hpp"
#include "engine/base/parallel/isolated.hpp"
#include "engine/base/thread_limit.hpp"

namespace lober::detail {

void for_each_block(std::size_t size, std::size_t grain, FunctionRef<void(std::size_t, std::size_t)> body) {
  const std::size_t blocks = (size + grain - 1) / grain;
  if (blocks <= 1) {
    if (size == 0) return;
    throw_if_cancelled();
    return body(std::size_t{0}, size);
  }
  const CancellationScope* const scope = CancellationScope::current();
  tbb::task_group_context context;
  HandedOver work;
  tbb::parallel_for(
      std::size_t{0}, blocks,
      [&](std::size_t block) LOBER_UNSEEN {
        const HandedOver::Part part(work);
        const InheritedCancellation inherited(scope);
        throw_if_cancelled();
        const std::size_t begin = block * grain;
        body(begin, begin + grain < size ? begin + grain : size);
      },
      context);
  require_complete(context);
}

void run_side_by_side(std::span<const FunctionRef<void()>> functions) {
  const CancellationScope* const scope = CancellationScope::current();
  tbb::task_group_context context;
  HandedOver work;
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, functions.size(), 1),
      [&](const tbb::blocked_range<std::size_t>& range) LOBER_UNSEEN {
        const HandedOver::Part part(work);
        const InheritedCancellation inherited(scope);
        for (std::size_t k = range.begin(); k < range.end(); ++k) functions[k]();
      },
      tbb::simple_partitioner(), context);
  require_complete(context);
}

void run_isolated(FunctionRef<void()> function) {
  tbb::this_task_arena::isolate([&] { function(); });
}

int concurrency() {
  return tbb::this_task_arena::max_concurrency();
}

void run_in_arena(int threads, FunctionRef<void()> function) {
  require_thread_count(threads);
  // An arena has as many slots as it is asked for, but oneTBB makes no more workers than there are cores until a limit
  // that is higher allows it. The lowest of several limits holds, so none is set that would hold others back.
  std::optional<tbb::global_control> limit;
  if (threads > tbb::info::default_concurrency()) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }
  tbb::task_arena arena(threads);
  const CancellationScope* const scope = CancellationScope::current();
  HandedOver work;
  arena.execute([&]() LOBER_UNSEEN {
    const HandedOver::Part part(work);
    const InheritedCancellation inherited(scope);
    function();
  });
}

}  // namespace lober::detail

#include "engine/base/parallel/parallel.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>

#include "lober/base/error.hpp"
#include "lober/base/threads.hpp"

namespace lober::detail {
namespace {

// Every piece waits until `threads` threads are in one at the same time; false when they never are.
bool meet_at_once(std::size_t threads) {
  std::mutex mutex;
  std::condition_variable all_here;
  std::set<std::thread::id> present;
  bool met = true;
  for_each_block(threads, 1, [&](std::size_t, std::size_t) {
    std::unique_lock lock(mutex);
    present.insert(std::this_thread::get_id());
    all_here.notify_all();
    // As long as a very busy machine may take to start a thread.
    if (!all_here.wait_for(lock, std::chrono::seconds(60), [&] { return present.size() == threads; })) met = false;
  });
  return met;
}

TEST(Parallel, SoManyThreadsWorkAtOnceAlsoMoreThanTheMachineHas) {
  for (const int threads : {2, 3, 7}) {
    EXPECT_TRUE(with_threads(threads, [&] { return meet_at_once(static_cast<std::size_t>(threads)); }))
        << threads << " threads";
  }
}

TEST(Parallel, ThreadsThatNoMachineGivesAreRefused) {
  for (const int threads : {-1, max_threads + 1, 100'000, 1'000'000'000}) {
    bool ran = false;
    EXPECT_THROW(run_with_threads(threads, [&] { ran = true; }), UsageError) << threads << " threads";
    EXPECT_FALSE(ran);
  }
  EXPECT_THROW(with_threads(max_threads + 1, [] {}), UsageError);
  for (const int threads : {0, 1, max_threads}) {
    bool ran = false;
    run_with_threads(threads, [&] { ran = true; });
    EXPECT_TRUE(ran) << threads << " threads";
  }
}

TEST(Parallel, FewerThreadsWithinMore) {
  EXPECT_TRUE(with_threads(7, [] { return with_threads(3, [] { return meet_at_once(3); }); }));
}

}  // namespace
}  // namespace lober::detail

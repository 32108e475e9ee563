#include "lober/base/cancellation.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numeric>
#include <thread>
#include <vector>

#include "engine/base/parallel/ordered_pipeline.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober::detail {
namespace {

TEST(Cancellation, ThrowsWhereTheFlagIsSet) {
  std::atomic<bool> flag{false};
  EXPECT_FALSE(is_cancelled());
  {
    const CancellationScope scope(flag);
    EXPECT_NO_THROW(throw_if_cancelled());
    flag = true;
    EXPECT_TRUE(is_cancelled());
    EXPECT_THROW(throw_if_cancelled(), Cancelled);
    EXPECT_THROW(for_each_block(1, 1, [](std::size_t, std::size_t) { FAIL(); }), Cancelled);
    EXPECT_THROW(for_each_block(100, 1, [](std::size_t, std::size_t) { FAIL(); }), Cancelled);
  }
  EXPECT_FALSE(is_cancelled());
}

TEST(Cancellation, ScopesAskThoseAroundThemButForAShield) {
  std::atomic<bool> outer{true}, inner{false};
  const CancellationScope around(outer);
  {
    const CancellationScope scope(inner);
    EXPECT_TRUE(is_cancelled());
  }
  const CancellationScope shield(CancellationScope::Shield{});
  EXPECT_FALSE(is_cancelled());
  const CancellationScope scope(inner);
  EXPECT_FALSE(is_cancelled());
  inner = true;
  EXPECT_TRUE(is_cancelled());
}

// Cancelled from outside while pieces of pieces are at work, on whatever threads they are.
TEST(Cancellation, ReachesPiecesOfPieces) {
  for (int round = 0; round < 20; ++round) {
    std::atomic<bool> flag{false};
    std::atomic<int> pieces{0};
    std::thread canceller([&] {
      while (pieces < 5) std::this_thread::yield();
      flag = true;
    });
    const CancellationScope scope(flag);
    const auto endless = [&] {
      with_threads(3, [&] {
        parallel_if(
            true, [] {},
            [&] {
              for_each_block(4, 1, [&](std::size_t, std::size_t) {
                for (;;) for_each_block(8, 1, [&](std::size_t, std::size_t) { ++pieces; });
              });
            });
      });
    };
    EXPECT_THROW(endless(), Cancelled);
    canceller.join();
  }
}

// An exception in one piece must not make the loops inside the others return as if they had done everything.
TEST(Cancellation, NoLoopReturnsWithPiecesMissing) {
  std::atomic<int> incomplete{0}, rounds{0};
  for (int round = 0; round < 200; ++round) {
    std::atomic<bool> begun{false};
    const auto outer = [&] {
      with_threads(4, [&] {
        for_each_block(2, 1, [&](std::size_t k, std::size_t) {
          if (k == 0) {
            // Both pieces may be on one thread, this one first.
            for (int wait = 0; wait < 100000 && !begun; ++wait) std::this_thread::yield();
            throw DataError("on purpose");
          }
          std::vector<char> done(2000, 0);
          begun = true;
          for_each_block(done.size(), 1, [&](std::size_t i, std::size_t) {
            volatile double work = 1;
            for (int j = 0; j < 200; ++j) work = work * 1.0000001;
            done[i] = 1;
          });
          ++rounds;
          if (std::accumulate(done.begin(), done.end(), 0) != static_cast<int>(done.size())) ++incomplete;
        });
      });
    };
    EXPECT_THROW(outer(), Error);
  }
  EXPECT_EQ(incomplete, 0) << "of " << rounds;
}

TEST(Cancellation, ReachesPipelines) {
  std::atomic<bool> flag{false};
  const CancellationScope scope(flag);
  int taken = 0;
  const auto endless = [&] {
    ordered_pipeline<int>(
        [&](int& slot) {
          slot = ++taken;
          return true;
        },
        [](int&) {}, [&](int& slot) { flag = slot > 10; });
  };
  EXPECT_THROW(endless(), Cancelled);
}

// One trajectory, with no loop around it.
TEST(Cancellation, ReachesTheIntegrator) {
  const System system = make_system("duffing");
  std::atomic<bool> flag{false};
  const CancellationScope scope(flag);
  std::thread canceller([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    flag = true;
  });
  Point point{0.3, 0.1};
  EXPECT_THROW(system.map->iterate({&point, 1}, 2'000'000'000), Cancelled);
  canceller.join();
}

}  // namespace
}  // namespace lober::detail

#include "engine/base/parallel/ordered_pipeline.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <stdexcept>
#include <thread>
#include <vector>

#include "engine/base/parallel/parallel.hpp"

namespace lober::detail {
namespace {

struct Slot {
  std::size_t number = 0, square = 0;
  std::thread::id worked_by;
};

// The results of a pipeline with this number of blocks, in the order in which they are delivered.
std::vector<Slot> delivered(std::size_t blocks) {
  std::size_t next = 0;
  std::vector<Slot> all;
  ordered_pipeline<Slot>(
      [&](Slot& slot) {
        if (next == blocks) return false;
        slot.number = next++;
        return true;
      },
      [](Slot& slot) {
        slot.square = slot.number * slot.number;
        slot.worked_by = std::this_thread::get_id();
      },
      [&](const Slot& slot) { all.push_back(slot); });
  return all;
}

TEST(OrderedPipeline, DeliversEachBlockOnceInOrder) {
  for (const int threads : {1, 3}) {
    with_threads(threads, [] {
      for (const std::size_t blocks :
           {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{500}}) {
        const std::vector<Slot> all = delivered(blocks);
        ASSERT_EQ(all.size(), blocks);
        for (std::size_t k = 0; k < blocks; ++k) {
          EXPECT_EQ(all[k].number, k);
          EXPECT_EQ(all[k].square, k * k);
        }
      }
    });
  }
}

TEST(OrderedPipeline, HandlesASingleBlockOnTheCallingThread) {
  EXPECT_EQ(delivered(1)[0].worked_by, std::this_thread::get_id());
}

TEST(OrderedPipeline, PassesOnWhatDeliveryThrowsFirst) {
  for (const std::size_t bad : {std::size_t{0}, std::size_t{1}, std::size_t{70}}) {
    std::size_t next = 0;
    const auto run = [&] {
      ordered_pipeline<Slot>(
          [&](Slot& slot) {
            slot.number = next;
            return next++ < bad + 1;
          },
          [](Slot&) {},
          [&](const Slot& slot) {
            if (slot.number == bad) throw std::runtime_error("block");
          });
    };
    EXPECT_THROW(run(), std::runtime_error);
  }
}

}  // namespace
}  // namespace lober::detail

#include "lober/base/buffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <thread>
#include <vector>

#include "engine/base/parallel/sanitizers.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t megabyte = std::size_t{1} << 20;

constexpr bool memory_is_kept = !LOBER_ADDRESS_SANITIZER && !LOBER_THREAD_SANITIZER;

TEST(BulkMemory, FreedBlockServesTheNextArrayOfAboutItsSize) {
  if (!memory_is_kept) GTEST_SKIP() << "nothing is kept under a sanitizer";
  release_bulk_memory();
  void* const first = allocate_bulk(24 * megabyte);
  free_bulk(first, 24 * megabyte);
  void* const smaller = allocate_bulk(20 * megabyte);
  EXPECT_EQ(smaller, first);
  free_bulk(smaller, 20 * megabyte);
  void* const larger = allocate_bulk(64 * megabyte);
  EXPECT_NE(larger, first);
  free_bulk(larger, 64 * megabyte);
  release_bulk_memory();
}

TEST(BulkMemory, AlignedForCacheLinesAndWritableToTheEnd) {
  for (const std::size_t bytes :
       {std::size_t{1}, std::size_t{4096}, 2 * megabyte - 1, 2 * megabyte, 5 * megabyte + 3}) {
    auto* const memory = static_cast<unsigned char*>(allocate_bulk(bytes));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(memory) % 64, 0U);
    std::memset(memory, 0xa5, bytes);
    EXPECT_EQ(memory[bytes - 1], 0xa5);
    free_bulk(memory, bytes);
  }
}

TEST(BulkMemory, ArraysInUseNeverShareMemory) {
  const auto work = [](unsigned char mark, bool& intact) {
    for (std::size_t round = 0; round < 40; ++round) {
      std::vector<Buffer<unsigned char>> held;
      for (std::size_t k = 0; k < 4; ++k) {
        held.emplace_back((2 + (round + k) % 5) * megabyte);
        for (std::size_t at = 0; at < held.back().size(); at += 4096) held.back()[at] = mark;
      }
      for (const Buffer<unsigned char>& buffer : held) {
        for (std::size_t at = 0; at < buffer.size(); at += 4096) intact = intact && buffer[at] == mark;
      }
    }
  };
  bool intact[4] = {true, true, true, true};
  std::vector<std::thread> threads;
  for (unsigned char k = 0; k < 4; ++k) threads.emplace_back(work, k, std::ref(intact[k]));
  for (std::thread& thread : threads) thread.join();
  EXPECT_TRUE(std::all_of(std::begin(intact), std::end(intact), [](bool ok) { return ok; }));
}

}  // namespace
}  // namespace lober::detail

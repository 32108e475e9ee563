#include "lober/base/buffer.hpp"

#include <tbb/scalable_allocator.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <mutex>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include "engine/base/parallel/sanitizers.hpp"

namespace lober {

#if LOBER_THREAD_SANITIZER || LOBER_ADDRESS_SANITIZER  // which must see when memory changes hands

void* allocate_bulk(std::size_t bytes) {
  constexpr std::size_t alignment = 64;
  void* memory = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void free_bulk(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void release_bulk_memory() noexcept {}

#else

namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;
constexpr std::size_t max_kept = std::size_t{512} << 20;

struct Block {
  void* at;
  std::size_t bytes;
};

std::size_t total(const std::vector<Block>& blocks) {
  std::size_t sum = 0;
  for (const Block& block : blocks) sum += block.bytes;
  return sum;
}

// Large blocks, those in use and those kept. There are a few dozen at a time.
class LargeBlocks {
 public:
  [[gnu::noinline]] void* take(std::size_t bytes) {  // apart from small arrays, which save no registers then
    const std::lock_guard lock(mutex_);
    reserve_lists();
    // The smallest that is large enough; one more than half as large again is left for a larger array.
    auto best = kept_.end();
    for (auto block = kept_.begin(); block != kept_.end(); ++block) {
      const bool fits = block->bytes >= bytes && block->bytes <= bytes + bytes / 2;
      if (fits && (best == kept_.end() || block->bytes < best->bytes)) best = block;
    }
    Block block{};
    if (best != kept_.end()) {
      block = *best;
      kept_.erase(best);
    } else {
      block = fresh(bytes);
    }
    used_.push_back(block);
    const std::size_t in_use = total(used_);
    max_used_ = std::max(max_used_, in_use);
    drop_oldest_until(std::min(max_kept, max_used_ - in_use));
    return block.at;
  }

  [[gnu::noinline]] void give(void* memory) noexcept {
    const std::lock_guard lock(mutex_);
    const auto block = std::find_if(used_.begin(), used_.end(), [&](const Block& used) { return used.at == memory; });
#ifdef MADV_FREE
    madvise(block->at, block->bytes, MADV_FREE);
#endif
    kept_.push_back(*block);  // there is capacity: reserve_lists()
    used_.erase(block);
    drop_oldest_until(max_kept);
  }

  void release() noexcept {
    const std::lock_guard lock(mutex_);
    drop_oldest_until(0);
    max_used_ = total(used_);
  }

 private:
  // give() must not throw, so the lists never grow there.
  void reserve_lists() {
    used_.reserve(used_.size() + 1);
    kept_.reserve(kept_.size() + used_.size() + 1);
  }

  Block fresh(std::size_t bytes) {
    const std::size_t whole = (bytes + huge_page - 1) / huge_page * huge_page;
    void* memory = scalable_aligned_malloc(whole, huge_page);
    if (memory == nullptr) {  // perhaps there is enough if nothing is kept
      drop_oldest_until(0);
      memory = scalable_aligned_malloc(whole, huge_page);
    }
    if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    madvise(memory, whole, MADV_HUGEPAGE);  // advice only: failure costs speed, no more
#endif
    return {memory, whole};
  }

  void drop_oldest_until(std::size_t most) noexcept {
    while (total(kept_) > most) {
      scalable_aligned_free(kept_.front().at);
      kept_.erase(kept_.begin());
    }
  }

  std::mutex mutex_;
  std::vector<Block> used_, kept_;  // kept: the one freed last at the end
  std::size_t max_used_ = 0;
};

LargeBlocks& large_blocks() {
  static auto* const blocks = new LargeBlocks;  // never destroyed: threads may outlive static objects
  return *blocks;
}

// Small arrays: an overlay of two short curves makes some forty, and each costs as much as a few of its segment pairs
// where an allocator has to find out sizes and owners. Each thread keeps those it freed last, by powers of two: as many
// as such an overlay gives back at once, of the larger ones as many as make 64 KiB.
constexpr std::size_t alignment = 64, smallest = 64, classes = 8, max_kept_small = 64,
                      kept_bytes = std::size_t{64} << 10;
constexpr std::size_t largest_small = smallest << (classes - 1);

std::size_t class_of(std::size_t bytes) {
  return static_cast<std::size_t>(std::bit_width((bytes - 1) / smallest));
}

// Without a constructor or destructor, so that an access is a plain one: a thread may free arrays while it starts and
// while it ends. `room` is how many more are kept: none of a thread that has not begun to keep any, or has ended.
struct SmallBlocks {
  std::array<std::uint8_t, classes> count, room;
  bool begun;
  std::array<std::array<void*, max_kept_small>, classes> kept;
};
constinit thread_local SmallBlocks small_blocks{};

// Frees what the thread keeps when it ends.
struct SmallBlocksEnd {
  SmallBlocksEnd() {
    for (std::size_t c = 0; c < classes; ++c) {
      small_blocks.room[c] = static_cast<std::uint8_t>(std::min(max_kept_small, kept_bytes / (smallest << c)));
    }
  }
  ~SmallBlocksEnd() {
    small_blocks.room = {};
    for (std::size_t c = 0; c < classes; ++c) {
      for (std::size_t k = 0; k < small_blocks.count[c]; ++k) scalable_aligned_free(small_blocks.kept[c][k]);
      small_blocks.count[c] = 0;
    }
  }
  SmallBlocksEnd(const SmallBlocksEnd&) = delete;
  SmallBlocksEnd& operator=(const SmallBlocksEnd&) = delete;
};

bool kept(void* memory, std::size_t size_class) noexcept {
  std::uint8_t& room = small_blocks.room[size_class];
  if (room == 0) return false;
  --room;
  small_blocks.kept[size_class][small_blocks.count[size_class]++] = memory;
  return true;
}

// Whether the thread begins to keep arrays now.
bool begins_to_keep() noexcept {
  if (small_blocks.begun) return false;
  small_blocks.begun = true;
  thread_local const SmallBlocksEnd end;
  (void)end;
  return true;
}

}  // namespace

void* allocate_bulk(std::size_t bytes) {
  if (bytes >= huge_page) return large_blocks().take(bytes);
  std::size_t whole = bytes;
  if (bytes <= largest_small) {
    const std::size_t c = class_of(std::max(bytes, smallest));
    if (small_blocks.count[c] > 0) {
      ++small_blocks.room[c];
      return small_blocks.kept[c][--small_blocks.count[c]];
    }
    whole = smallest << c;
  }
  void* memory = scalable_aligned_malloc(whole, alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void free_bulk(void* memory, std::size_t bytes) noexcept {
  if (bytes >= huge_page) return large_blocks().give(memory);
  if (bytes <= largest_small && memory != nullptr) {
    const std::size_t c = class_of(std::max(bytes, smallest));
    if (kept(memory, c) || (begins_to_keep() && kept(memory, c))) return;
  }
  scalable_aligned_free(memory);
}

void release_bulk_memory() noexcept {
  large_blocks().release();
}

#endif

}  // namespace lober

// Arrays for millions of elements. They are not filled with zeros first, lie on huge pages where the system offers
// them, and their memory is kept for the next ones (oneTBB's allocator): at these sizes the first touch of a fresh 4
// KiB page costs as much as the work done on it.
#pragma once

#include <tbb/scalable_allocator.h>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace lober {

template <typename T>
class BulkAllocator {
 public:
  using value_type = T;
  BulkAllocator() = default;
  template <typename U>
  BulkAllocator(const BulkAllocator<U>&) {}  // NOLINT(google-explicit-constructor)

  T* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
    const std::size_t alignment = count * sizeof(T) >= huge_page ? huge_page : 64;
    const std::size_t bytes = count * sizeof(T);
#ifdef __SANITIZE_THREAD__
    void* memory = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
#else
    void* memory = scalable_aligned_malloc(bytes, alignment);
#endif
    if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    if (alignment == huge_page) madvise(memory, bytes, MADV_HUGEPAGE);  // advice only: failure costs speed, no more
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) {
#ifdef __SANITIZE_THREAD__  // which must see when memory changes hands
    std::free(memory);
#else
    scalable_aligned_free(memory);
#endif
  }

  /// Leaves plain values uninitialised.
  template <typename U, typename... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    if constexpr (sizeof...(Arguments) == 0 && std::is_trivially_destructible_v<U>) {
      ::new (static_cast<void*>(at)) U;
    } else {
      ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
    }
  }
  friend bool operator==(const BulkAllocator&, const BulkAllocator&) {
    return true;
  }

 private:
  static constexpr std::size_t huge_page = std::size_t{2} << 20;
};

template <typename T>
using Buffer = std::vector<T, BulkAllocator<T>>;

}  // namespace lober

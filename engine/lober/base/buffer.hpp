// Arrays for millions of elements. They are not filled with zeros first, lie on huge pages where the system offers
// them, and their memory is kept for the next ones: at these sizes the first touch of a fresh page costs as much as
// the work done on it.
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/curve/point.hpp"

namespace lober {

/// Memory for a large array, aligned to a cache line at least. Throws std::bad_alloc. Thread-safe.
///
/// Freed blocks of 2 MiB and more are kept for the next large array that needs at least two thirds of one: at most 512
/// MiB, and never more than brings the total of blocks to the most that was in use at one time. The system may take
/// their pages back whenever it is short of memory (MADV_FREE). Each thread keeps the last few blocks of up to 8 KiB.
/// Under AddressSanitizer and ThreadSanitizer nothing is kept and all memory comes from the instrumented allocator.
[[nodiscard]] LOBER_API void* allocate_bulk(std::size_t bytes);
/// Gives back memory of allocate_bulk.
LOBER_API void free_bulk(void* memory, std::size_t bytes) noexcept;

/// Gives all memory that is only kept for the next array back to the system: for a program that goes on after its work
/// on large curves.
LOBER_API void release_bulk_memory() noexcept;

/// Types whose arrays stay uninitialised, although their default constructor would fill them: points, and those with a
/// member type LeftUnfilled. At a thousand million points that took most of a minute, on one thread, and nothing could
/// interrupt it.
template <typename T>
inline constexpr bool left_unfilled = std::is_same_v<T, Point> || requires {
  typename T::LeftUnfilled;
};

/// An allocator for large arrays, which keeps blocks for the next one and leaves points and the like uninitialised.
template <typename T>
class BulkAllocator {
 public:
  using value_type = T;  ///< the elements
  BulkAllocator() = default;
  /// An allocator for other elements: all of them are alike.
  template <typename U>
  BulkAllocator(const BulkAllocator<U>&) {}  // NOLINT(google-explicit-constructor)

  /// Uninitialised memory for `count` elements. Throws std::bad_alloc.
  T* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(allocate_bulk(count * sizeof(T)));
  }
  /// Gives back memory of `allocate`.
  void deallocate(T* memory, std::size_t count) { free_bulk(memory, count * sizeof(T)); }

  /// Leaves plain values uninitialised.
  template <typename U, typename... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    if constexpr (sizeof...(Arguments) == 0 && left_unfilled<U>) {
      static_assert(std::is_trivially_copyable_v<U> && std::is_aggregate_v<U>);  // so its lifetime begins by itself
    } else if constexpr (sizeof...(Arguments) == 0 && std::is_trivially_destructible_v<U>) {
      ::new (static_cast<void*>(at)) U;
    } else {
      ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
    }
  }
  /// All allocators are alike.
  friend bool operator==(const BulkAllocator&, const BulkAllocator&) { return true; }
};

template <typename T>
/// An array of numbers or points that stays uninitialised until it is written.
using Buffer = std::vector<T, BulkAllocator<T>>;

}  // namespace lober

// Room for values that are written before they are read.
#pragma once

#include <cstddef>
#include <type_traits>

namespace lober::detail {

/// An array of `size` elements that is not filled when it is made, also where the constructor of T would: kilobytes of
/// zeros cost as much as the overlay of two short curves spends on finding their crossings.
template <typename T, std::size_t size>
class Unfilled {
  static_assert(std::is_trivially_copyable_v<T> && std::is_aggregate_v<T>);  // so lifetimes begin by themselves

 public:
  [[nodiscard]] T* data() { return reinterpret_cast<T*>(bytes_); }
  [[nodiscard]] T& operator[](std::size_t k) { return data()[k]; }

 private:
  alignas(T) std::byte bytes_[size * sizeof(T)];
};

}  // namespace lober::detail

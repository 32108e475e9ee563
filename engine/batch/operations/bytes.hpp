// Arrays of numbers as bytes in native order, and back: for the byte strings of CBOR (private to the batch).
#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "lober/base/error.hpp"

namespace lober::detail {

template <typename T>
std::vector<std::uint8_t> bytes_of(const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}
/// Throws DataError for bytes that are not those of whole values.
template <typename T>
std::vector<T> values_of(const std::vector<std::uint8_t>& bytes) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (bytes.size() % sizeof(T) != 0) throw DataError("the stored bytes end too early");
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

}  // namespace lober::detail

// Values as bytes in native order, one after the other, and back (private to jobs/).
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "lober/error.hpp"

namespace lober {

class ByteWriter {
 public:
  template <typename T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }
  template <typename T>
  void put_all(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    put(static_cast<std::uint64_t>(values.size()));
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  void put_flag(bool flag) { put(static_cast<std::uint8_t>(flag ? 1 : 0)); }
  void put_text(std::string_view text) {
    put(static_cast<std::uint64_t>(text.size()));
    bytes_ += text;
  }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Throws DataError when there is less than is asked for.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  /// Not for bool and enumerations: not every byte is one of theirs.
  template <typename T>
  T get() {
    static_assert(std::is_trivially_copyable_v<T> && !std::is_same_v<T, bool> && !std::is_enum_v<T>);
    T value;
    std::memcpy(&value, take(sizeof(T)), sizeof(T));
    return value;
  }
  template <typename T>
  std::vector<T> get_all() {
    const auto count = get<std::uint64_t>();
    if (count > bytes_.size() / sizeof(T)) fail();
    std::vector<T> values(count);
    if (count != 0) std::memcpy(values.data(), take(count * sizeof(T)), count * sizeof(T));
    return values;
  }
  /// Throws DataError for a number that is not below `end`.
  template <typename T>
  T get_below(T end) {
    const T value = get<T>();
    if (!(value < end)) throw DataError("a stored number is out of its range");
    return value;
  }
  bool get_flag() { return get_below<std::uint8_t>(2) != 0; }
  /// How many things follow, each of at least one byte: no more than bytes are left.
  std::size_t get_count() {
    const auto count = get<std::uint64_t>();
    if (count > bytes_.size()) fail();
    return count;
  }
  std::string get_text() {
    const auto size = get<std::uint64_t>();
    if (size > bytes_.size()) fail();
    return {take(size), size};
  }
  [[nodiscard]] bool at_end() const { return bytes_.empty(); }

 private:
  [[noreturn]] static void fail() { throw DataError("the stored bytes end too early"); }
  const char* take(std::size_t size) {
    if (size > bytes_.size()) fail();
    const char* const at = bytes_.data();
    bytes_.remove_prefix(size);
    return at;
  }
  std::string_view bytes_;
};

}  // namespace lober

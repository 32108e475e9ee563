// Checksums against damage of stored data, not against forgery.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string_view>

namespace lober::detail {

/// Every step is a one-to-one function of the state and of the word, so that no change within one word goes unseen.
class Checksum {
 public:
  Checksum& add(std::uint64_t word) {
    sum_ = mixed(sum_, word);
    return *this;
  }
  Checksum& add(double value) { return add(bits_of(value)); }
  /// In several lanes, which do not wait for each other.
  Checksum& add(std::span<const double> values) {
    std::array<std::uint64_t, 4> lanes{1, 2, 3, 4};
    for (std::size_t k = 0; k < values.size(); ++k) lanes[k % 4] = mixed(lanes[k % 4], bits_of(values[k]));
    for (const std::uint64_t lane : lanes) add(lane);
    return add(std::uint64_t{values.size()});
  }
  Checksum& add(std::string_view bytes) {
    add(std::uint64_t{bytes.size()});
    while (!bytes.empty()) {
      std::uint64_t word = 0;
      const std::size_t size = std::min(bytes.size(), sizeof(word));
      std::memcpy(&word, bytes.data(), size);
      bytes.remove_prefix(size);
      add(word);
    }
    return *this;
  }
  [[nodiscard]] std::int64_t sum() const { return std::bit_cast<std::int64_t>(sum_); }

 private:
  // NaN is NaN: SQLite keeps only that.
  static std::uint64_t bits_of(double value) {
    return std::bit_cast<std::uint64_t>(value == value ? value : std::numeric_limits<double>::quiet_NaN());
  }
  static std::uint64_t mixed(std::uint64_t sum, std::uint64_t word) {
    sum = (sum ^ word) * 0xd6e8feb86659fd93;
    return sum ^ sum >> 32;
  }
  std::uint64_t sum_ = 0x9e3779b97f4a7c15;
};

}  // namespace lober::detail

// Against damage of what is stored, not against forgery.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string_view>

namespace lober {

/// Every step is a one-to-one function of the state and of the word, so that no change within one word goes unseen.
class Checksum {
 public:
  Checksum& add(std::uint64_t word) {
    sum_ = (sum_ ^ word) * 0xd6e8feb86659fd93;
    sum_ ^= sum_ >> 32;
    return *this;
  }
  /// NaN is NaN: SQLite keeps only that.
  Checksum& add(double value) {
    return add(std::bit_cast<std::uint64_t>(std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value));
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
  std::uint64_t sum_ = 0x9e3779b97f4a7c15;
};

}  // namespace lober

// Doubles as whole numbers, and numbers as bits, for series in pages.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace lober::viewer {

/// The number of a double in their order, from -NaN over -infinity, -0 and 0 to NaN; and the double again.
[[nodiscard]] inline std::uint64_t order_of(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return bits >> 63 != 0 ? ~bits : bits | 1ull << 63;
}

[[nodiscard]] inline double of_order(std::uint64_t order) {
  return std::bit_cast<double>(order >> 63 != 0 ? order & ~(1ull << 63) : ~order);
}

/// A number n >= 0, in two's complement, as 2 n, and n < 0 as -2 n - 1; and the number again.
[[nodiscard]] inline std::uint64_t zigzag(std::uint64_t difference) {
  return difference << 1 ^ (difference >> 63 != 0 ? ~std::uint64_t{0} : 0);
}

[[nodiscard]] inline std::uint64_t unzigzag(std::uint64_t number) {
  return number >> 1 ^ ((number & 1) != 0 ? ~std::uint64_t{0} : 0);
}

/// Writes numbers of any count of bits one behind the other, the least significant bit first.
class BitWriter {
 public:
  void add(std::uint64_t number, int count) {
    for (; count > 0; --count, number >>= 1) {
      if (used_ == 8) {
        bytes_ += '\0';
        used_ = 0;
      }
      bytes_.back() = static_cast<char>(static_cast<unsigned char>(bytes_.back()) | (number & 1) << used_++);
    }
  }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  int used_ = 8;  // bits of the last byte
};

/// Reads them again. Throws std::out_of_range at the end.
class BitReader {
 public:
  explicit BitReader(std::string_view bytes) : bytes_(bytes) {}

  std::uint64_t number(int count) {
    std::uint64_t value = 0;
    for (int k = 0; k < count; ++k, ++at_) {
      value |= std::uint64_t{static_cast<unsigned char>(bytes_.at(at_ / 8)) >> at_ % 8 & 1u} << k;
    }
    return value;
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace lober::viewer

#include "viewer/series.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <stdexcept>

namespace lober::viewer {
namespace {

constexpr int max_order = 4;
constexpr double max_multiple = 0x1p50;           // of q: differences of all orders are then exact in double
constexpr std::uint64_t max_zigzag = 1ull << 53;  // the page computes in double

struct EncodedBlock {
  int order = 0, width = 8, exponent = 0;
  std::vector<double> heads;
  std::vector<std::uint64_t> numbers;  // zigzag; of order 0 the bits of the values
};

std::uint64_t zigzag(std::int64_t number) {
  return (static_cast<std::uint64_t>(number) << 1) ^ static_cast<std::uint64_t>(number >> 63);
}

// The exponent of the lowest bit that is set in any of the values; 0 if all of them are zero.
int lowest_bit(std::span<const double> values) {
  std::optional<int> lowest;
  for (const double value : values) {
    if (value == 0) continue;
    int exponent = 0;
    const auto mantissa = static_cast<std::uint64_t>(std::fabs(std::frexp(value, &exponent)) * 0x1p53);
    const int bit = exponent - 53 + std::countr_zero(mantissa);
    lowest = lowest ? std::min(*lowest, bit) : bit;
  }
  return lowest.value_or(0);
}

// The multiples of 2^exponent from the first value on; nothing where they are too large or, with `exact`, are not the
// values.
std::optional<std::vector<std::int64_t>> multiples(std::span<const double> values, int exponent, bool exact) {
  std::vector<std::int64_t> found;
  found.reserve(values.size());
  const double first = values.front();
  for (const double value : values) {
    const double multiple = std::nearbyint(std::ldexp(value - first, -exponent));
    if (!(std::fabs(multiple) < max_multiple)) return std::nullopt;
    const double again = multiple == 0 ? first : first + std::ldexp(multiple, exponent);
    if (exact && std::bit_cast<std::uint64_t>(again) != std::bit_cast<std::uint64_t>(value)) return std::nullopt;
    found.push_back(static_cast<std::int64_t>(multiple));
  }
  return found;
}

EncodedBlock plain_block(std::span<const double> values) {
  EncodedBlock block;
  for (const double value : values) block.numbers.push_back(std::bit_cast<std::uint64_t>(value));
  return block;
}

EncodedBlock encode_block(std::span<const double> values, double step) {
  if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); })) {
    return plain_block(values);
  }
  const int lowest = lowest_bit(values), coarse = step > 0 ? std::ilogb(step) : lowest;
  auto differences = multiples(values, std::max(lowest, coarse), coarse <= lowest);
  if (!differences) return plain_block(values);
  EncodedBlock best;
  double fewest = HUGE_VAL;
  std::vector<double> heads{values.front()};
  for (int order = 1; order <= max_order && static_cast<std::size_t>(order) <= values.size(); ++order) {
    const auto begin = static_cast<std::size_t>(order);
    for (std::size_t k = values.size(); k-- > begin;) (*differences)[k] -= (*differences)[k - 1];
    double bits = 64 * order;
    std::uint64_t all = 0;
    std::vector<std::uint64_t> numbers;
    numbers.reserve(values.size() - begin);
    for (std::size_t k = begin; k < values.size(); ++k) {
      numbers.push_back(zigzag((*differences)[k]));
      all |= numbers.back();
      bits += static_cast<double>(std::bit_width(numbers.back()));
    }
    if (all < max_zigzag && bits < fewest) {
      fewest = bits;
      best = {order, std::max(1, (static_cast<int>(std::bit_width(all)) + 7) / 8), std::max(lowest, coarse), heads,
              std::move(numbers)};
    }
    if (begin < values.size()) heads.push_back(static_cast<double>((*differences)[begin]));
  }
  return best.order == 0 ? plain_block(values) : best;
}

void append_bytes(std::string& bytes, std::uint64_t number, int count) {
  for (int k = 0; k < count; ++k) bytes += static_cast<char>(number >> (8 * k) & 0xff);
}

// Reads numbers of some bytes, the least significant one first.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}
  std::uint64_t number(int count) {
    std::uint64_t value = 0;
    for (int k = 0; k < count; ++k) value |= std::uint64_t{static_cast<unsigned char>(bytes_.at(at_++))} << (8 * k);
    return value;
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace

std::string encode_series(std::span<const double> values, double step, std::span<const std::uint32_t> exact) {
  std::vector<EncodedBlock> blocks;
  for (std::size_t begin = 0; begin < values.size(); begin += series_block) {
    const std::size_t size = std::min(series_block, values.size() - begin);
    const auto within = std::lower_bound(exact.begin(), exact.end(), begin);
    const bool rounds = within == exact.end() || *within >= begin + size;
    blocks.push_back(encode_block(values.subspan(begin, size), rounds ? step : 0));
  }
  std::string bytes;
  for (const EncodedBlock& block : blocks) {
    append_bytes(bytes, static_cast<std::uint64_t>(block.order), 1);
    append_bytes(bytes, static_cast<std::uint64_t>(block.width), 1);
    append_bytes(bytes, static_cast<std::uint64_t>(block.exponent), 2);
  }
  for (const EncodedBlock& block : blocks) {
    for (const double head : block.heads) append_bytes(bytes, std::bit_cast<std::uint64_t>(head), 8);
  }
  for (const EncodedBlock& block : blocks) {
    for (int k = 0; k < block.width; ++k) {
      for (const std::uint64_t number : block.numbers) bytes += static_cast<char>(number >> (8 * k) & 0xff);
    }
  }
  return bytes;
}

std::vector<double> decode_series(std::string_view bytes, std::size_t count) {
  struct Head {
    int order, width, exponent;
    std::array<double, max_order> heads;
  };
  std::vector<Head> blocks((count + series_block - 1) / series_block);
  ByteReader reader(bytes);
  for (Head& block : blocks) {
    block.order = static_cast<int>(reader.number(1));
    block.width = static_cast<int>(reader.number(1));
    block.exponent = static_cast<std::int16_t>(reader.number(2));
  }
  for (Head& block : blocks) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(block.order); ++k) {
      block.heads.at(k) = std::bit_cast<double>(reader.number(8));
    }
  }
  std::vector<double> values;
  values.reserve(count);
  for (const Head& block : blocks) {
    const std::size_t size = std::min(series_block, count - values.size()),
                      order = static_cast<std::size_t>(block.order);
    std::vector<std::uint64_t> numbers(size - order);
    for (int k = 0; k < block.width; ++k) {
      for (std::uint64_t& number : numbers) number |= reader.number(1) << (8 * k);
    }
    if (order == 0) {
      for (const std::uint64_t bits : numbers) values.push_back(std::bit_cast<double>(bits));
      continue;
    }
    std::vector<double> differences(size);
    for (std::size_t k = 1; k < order; ++k) differences[k] = block.heads[k];
    for (std::size_t k = order; k < size; ++k) {
      const std::uint64_t number = numbers[k - order];
      differences[k] = (number & 1) != 0 ? -static_cast<double>(number / 2) - 1 : static_cast<double>(number / 2);
    }
    for (std::size_t begin = order; begin-- > 0;) {
      for (std::size_t k = begin + 1; k < size; ++k) differences[k] += differences[k - 1];
    }
    for (const double multiple : differences) {
      // A value that is rounded once, as it was when it was written; -0 + 0 would lose its sign.
      values.push_back(multiple == 0 ? block.heads[0] : block.heads[0] + std::ldexp(multiple, block.exponent));
    }
  }
  return values;
}

}  // namespace lober::viewer

#include "engine/files/formats/npy_numbers.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/base/parallel/parallel.hpp"
#include "engine/files/byte_order.hpp"
#include "engine/files/formats/arrays.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

double half_number(std::uint16_t bits) {
  const int exponent = (bits >> 10) & 31, fraction = bits & 1023;
  const double value = exponent == 31  ? (fraction != 0 ? std::numeric_limits<double>::quiet_NaN()
                                                        : std::numeric_limits<double>::infinity())
                       : exponent == 0 ? std::ldexp(fraction, -24)
                                       : std::ldexp(1024 + fraction, exponent - 25);
  return (bits >> 15) != 0 ? -value : value;
}

double load_half(const std::byte* from, bool swap) {
  std::uint16_t bits = 0;
  std::memcpy(&bits, from, sizeof bits);
  return half_number(swap ? reversed_bytes(bits) : bits);
}

using Load = double (*)(const std::byte*, bool);

// How an element is read, and its size; null for elements that are not numbers.
struct Element {
  Load load = nullptr;
  std::size_t size = 1;  // bytes of a number, of which a complex one has two
  bool swap = false;
  bool is_complex = false;
};

Element element_of(const NpyHeader& header) {
  struct Known {
    std::string_view type;
    Load load;
    std::size_t size;
  };
  static constexpr Known known[] = {{"f8", load_number<double, std::uint64_t>, 8},
                                    {"f4", load_number<float, std::uint32_t>, 4},
                                    {"c8", load_number<float, std::uint32_t>, 4},
                                    {"c16", load_number<double, std::uint64_t>, 8},
                                    {"f2", load_half, 2},
                                    {"i8", load_number<std::int64_t, std::uint64_t>, 8},
                                    {"i4", load_number<std::int32_t, std::uint32_t>, 4},
                                    {"i2", load_number<std::int16_t, std::uint16_t>, 2},
                                    {"i1", load_number<std::int8_t, std::uint8_t>, 1},
                                    {"u8", load_number<std::uint64_t, std::uint64_t>, 8},
                                    {"u4", load_number<std::uint32_t, std::uint32_t>, 4},
                                    {"u2", load_number<std::uint16_t, std::uint16_t>, 2},
                                    {"u1", load_number<std::uint8_t, std::uint8_t>, 1},
                                    {"b1", load_number<std::uint8_t, std::uint8_t>, 1}};
  if (header.type.size() < 3) return {};
  constexpr bool little = std::endian::native == std::endian::little;
  const char order = header.type.front();
  for (const Known& one : known) {
    if (header.type.substr(1) == one.type) {
      return {one.load, one.size, order == (little ? '>' : '<'), one.type.front() == 'c'};
    }
  }
  return {};
}

void append_utf8(std::string& text, std::uint32_t code) {
  const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) return put(code);
  if (code < 0x800) return put(0xC0 | code >> 6), put(0x80 | (code & 0x3F));
  if (code < 0x10000) return put(0xE0 | code >> 12), put(0x80 | (code >> 6 & 0x3F)), put(0x80 | (code & 0x3F));
  put(0xF0 | (code >> 18 & 7)), put(0x80 | (code >> 12 & 0x3F)), put(0x80 | (code >> 6 & 0x3F));
  put(0x80 | (code & 0x3F));
}

}  // namespace

bool holds_numbers(const NpyHeader& header) {
  return element_of(header).load != nullptr;
}

bool holds_complex_numbers(const NpyHeader& header) {
  return element_of(header).is_complex;
}

Buffer<double> npy_numbers(const NpyHeader& header, std::span<const std::byte> data, const std::string& path) {
  const Element element = element_of(header);
  if (element.load == nullptr) throw DataError(path + ": elements of type " + header.type + " are not numbers");
  const std::size_t parts = element.is_complex ? 2 : 1, size = parts * element.size;
  const std::size_t count = ArrayInfo{{}, header.shape}.size();
  if (data.size() % size != 0 || data.size() / size != count) {
    throw DataError(path + ": the NPY header promises " + std::to_string(count) + " numbers of " +
                    std::to_string(size) + " bytes, there are " + std::to_string(data.size()) + " bytes");
  }
  const auto loaded = [&](std::size_t first, std::size_t step, std::size_t numbers) {
    Buffer<double> result(numbers);
    for_each_block(numbers, std::size_t{1} << 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        result[k] = element.load(data.data() + (first + k * step) * element.size, element.swap);
      }
    });
    return result;
  };
  if (!header.fortran_order) return loaded(0, 1, parts * count);
  if (!element.is_complex) return last_axis_fastest(loaded(0, 1, count), header.shape);
  return interleaved(last_axis_fastest(loaded(0, 2, count), header.shape),
                     last_axis_fastest(loaded(1, 2, count), header.shape));
}

std::vector<std::string> npy_texts(const NpyHeader& header, std::span<const std::byte> data) {
  constexpr std::size_t of_code = 4;
  const std::string_view type = header.type;
  if (type.size() < 3 || (type[1] != 'U' && type[1] != 'S')) return {};
  const std::size_t width = std::strtoull(header.type.c_str() + 2, nullptr, 10);
  const std::size_t size = type[1] == 'U' ? of_code * width : width, count = ArrayInfo{{}, header.shape}.size();
  if (size == 0 || size / of_code > data.size() || data.size() / size != count) return {};
  std::vector<std::string> texts(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::span<const std::byte> one = data.subspan(k * size, size);
    if (type[1] == 'S') {
      for (const std::byte byte : one) texts[k] += static_cast<char>(byte);
      while (!texts[k].empty() && texts[k].back() == '\0') texts[k].pop_back();
      continue;
    }
    for (std::size_t at = 0; at < size; at += of_code) {
      std::uint32_t code = 0;
      std::memcpy(&code, one.data() + at, of_code);
      if (type.front() == '>') code = reversed_bytes(code);
      if (code != 0) append_utf8(texts[k], code);
    }
  }
  return texts;
}

}  // namespace lober::detail

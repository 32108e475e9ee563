#include "engine/files/plausible.hpp"
#include "kernels/elementary.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace lober::detail {
namespace {

constexpr std::string_view insisting = ".f64";
constexpr std::size_t looked_at = 4096;  // points

using Column = std::vector<double>;

/// The first points as pairs of another type: x and y.
template <typename Unsigned, typename Decode>
std::array<Column, 2> columns(std::span<const std::byte> bytes, const Decode& decode) {
  std::array<Column, 2> xy;
  const std::size_t points = std::min(bytes.size() / (2 * sizeof(Unsigned)), looked_at);
  for (std::size_t k = 0; k < 2 * points; ++k) {
    Unsigned bits = 0;
    std::memcpy(&bits, bytes.data() + k * sizeof bits, sizeof bits);
    xy[k % 2].push_back(decode(bits));
  }
  return xy;
}

std::array<Column, 2> as_float32(std::span<const std::byte> bytes) {
  return columns<std::uint32_t>(bytes, [](std::uint32_t bits) { return double{std::bit_cast<float>(bits)}; });
}
std::array<Column, 2> as_float64(std::span<const std::byte> bytes) {
  return columns<std::uint64_t>(bytes, [](std::uint64_t bits) { return std::bit_cast<double>(bits); });
}
std::array<Column, 2> as_swapped_float64(std::span<const std::byte> bytes) {
  return columns<std::uint64_t>(bytes, [](std::uint64_t bits) {
    std::uint64_t swapped = 0;
    for (int k = 0; k < 8; ++k, bits >>= 8) swapped = swapped << 8 | (bits & 0xFF);
    return std::bit_cast<double>(swapped);
  });
}

/// Decades of the coordinates that are finite and not zero: the tenth part, half, and nine tenths of them lie below
/// these. A few tiny numbers beside ordinary ones are those of a curve that crosses an axis.
struct Decades {
  double low = 0, middle = 0, high = 0;
  [[nodiscard]] double spread() const { return high - low; }
};

Decades decades_of(const Column& column) {
  std::vector<double> decades;
  for (const double value : column) {
    if (value != 0 && std::isfinite(value)) decades.push_back(elementary::log10(std::fabs(value)));
  }
  if (decades.empty()) return {};
  std::sort(decades.begin(), decades.end());
  const std::size_t last = decades.size() - 1;
  return {decades[last / 10], decades[last / 2], decades[last - last / 10]};
}

bool all_finite(const Column& column) {
  return std::all_of(column.begin(), column.end(), [](double value) { return std::isfinite(value); });
}

/// Mean step along the column over its extent: 1/3 for noise, small for a curve. Infinite where nothing varies.
double roughness(const Column& column) {
  double steps = 0;
  for (std::size_t k = 1; k < column.size(); ++k) steps += std::fabs(column[k] - column[k - 1]);
  const auto [low, high] = std::minmax_element(column.begin(), column.end());
  return steps / (*high - *low) / static_cast<double>(column.size());
}

/// A smooth curve of ordinary numbers.
bool is_smooth_curve(const std::array<Column, 2>& xy) {
  constexpr std::size_t fewest = 32;
  constexpr double smooth = 0.1, max_decades = 12, largest = 15;
  return std::all_of(xy.begin(), xy.end(), [](const Column& column) {
    if (column.size() < fewest || !all_finite(column)) return false;
    const Decades decades = decades_of(column);
    return decades.spread() < max_decades && std::fabs(decades.middle) < largest && roughness(column) < smooth;
  });
}

/// Whether pairs of float32 are likelier than float64. The second half of a float64, which is the first number of a
/// pair here, is noise or zero, so that as float32 such halves spread over all decades, or are the same: fewer than one
/// in 10^8 float64 files of random numbers has eight of them within six decades, and all different. As float64, the
/// decades of float32 numbers are eight times as many.
bool are_floats(const std::array<Column, 2>& floats, const std::array<Column, 2>& doubles) {
  constexpr std::size_t fewest = 8;
  constexpr double max_decades = 6, farthest = 15;
  if (floats[0].size() < fewest) return false;
  for (const Column& column : floats) {
    const Decades decades = decades_of(column);
    if (!all_finite(column) || decades.spread() > max_decades || std::fabs(decades.middle) > farthest) return false;
  }
  Column halves = floats[std::endian::native == std::endian::little ? 0 : 1];
  std::sort(halves.begin(), halves.end());
  const auto others = static_cast<std::size_t>(std::unique(halves.begin(), halves.end()) - halves.begin());
  if (others < halves.size() - halves.size() / 4) return false;
  const double spread = std::max(decades_of(floats[0]).spread(), decades_of(floats[1]).spread());
  return std::max(decades_of(doubles[0]).spread(), decades_of(doubles[1]).spread()) > spread;
}

bool is_ordinary(const std::array<Column, 2>& xy) {
  constexpr double max_spread = 100, farthest = 150;
  return std::all_of(xy.begin(), xy.end(), [](const Column& column) {
    const Decades decades = decades_of(column);
    return decades.spread() < max_spread && std::fabs(decades.middle) < farthest;
  });
}

std::string npy_command(const std::string& path, std::string_view type) {
  return "make an NPY file of it: python3 -c \"import numpy as n; n.save('points.npy', n.fromfile('" + path + "', '" +
         std::string(type) + "').reshape(-1, 2))\"";
}

}  // namespace

bool insists_on_raw(const std::string& path) {
  return path.ends_with(insisting);
}

std::string implausible_raw(const std::string& path, std::span<const std::byte> bytes) {
  const std::string or_insist = "; it is read as raw float64 pairs if its name ends in " + std::string(insisting);
  const std::array<Column, 2> xy = as_float64(bytes), floats = as_float32(bytes);
  if (is_smooth_curve(floats) || are_floats(floats, xy)) {
    return "looks like raw float32 pairs, but only float64 pairs are read: " + npy_command(path, "f4") + or_insist;
  }
  const auto is_usual = [](const std::array<Column, 2>& pair) {
    return all_finite(pair[0]) && all_finite(pair[1]) && is_ordinary(pair);
  };
  if (is_usual(xy)) return {};
  if (is_usual(as_swapped_float64(bytes))) {
    const std::string_view other = std::endian::native == std::endian::little ? ">f8" : "<f8";
    return "looks like raw float64 pairs of the other byte order: " + npy_command(path, other) + or_insist;
  }
  if (is_ordinary(xy)) return {};  // the reader of the points reports which of them is not finite
  const Decades x = decades_of(xy[0]), y = decades_of(xy[1]);
  const auto decade = [](double value) { return "1e" + std::to_string(std::lround(value)); };
  return "neither text nor NPY, and as raw float64 pairs most coordinates lie between " +
         decade(std::min(x.low, y.low)) + " and " + decade(std::max(x.high, y.high)) +
         ", so they are something else; write them as NPY or text" + or_insist;
}

}  // namespace lober::detail

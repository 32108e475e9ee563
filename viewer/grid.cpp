#include "viewer/grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace lober::viewer {
namespace {

constexpr int max_decimals = 15, power_code = 2000;
constexpr double middle = 0x1.8p52;      // doubles about it are whole numbers
constexpr double max_multiple = 0x1p51;  // up to which they are

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

std::optional<Grid> powers_grid(int exponent, double largest) {
  const double offset = std::ldexp(middle, exponent);
  if (!(largest < std::ldexp(max_multiple, exponent)) || !std::isfinite(offset)) return std::nullopt;
  return grid_of(static_cast<std::int16_t>(power_code + exponent));
}

bool is_exact(const Grid& grid, std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [&](double value) {
    return std::bit_cast<std::uint64_t>(grid.value(grid.mapped(value))) == std::bit_cast<std::uint64_t>(value);
  });
}

}  // namespace

Grid grid_of(std::int16_t code) {
  if (code == 0) return {};
  if (code > max_decimals + 1) return {code, 1, std::ldexp(middle, code - power_code)};
  double scale = 1;
  for (int k = 1; k < code; ++k) scale *= 10;
  return {code, scale, middle};
}

Grid grid_for(std::span<const double> values, double step) {
  double largest = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) return {};
    largest = std::max(largest, std::fabs(value));
  }
  if (const auto grid = powers_grid(lowest_bit(values), largest); grid && is_exact(*grid, values)) return *grid;
  for (std::int16_t decimals = 0; decimals <= max_decimals; ++decimals) {
    const Grid grid = grid_of(static_cast<std::int16_t>(1 + decimals));
    if (!(largest * grid.scale < max_multiple)) break;
    if (is_exact(grid, values)) return grid;
  }
  if (step > 0) {
    if (const auto grid = powers_grid(std::ilogb(step), largest)) return *grid;
  }
  return {};
}

}  // namespace lober::viewer

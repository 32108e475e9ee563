// Numbers that values of a block are multiples of, for series in pages.
#pragma once

#include <cstdint>
#include <span>

namespace lober::viewer {

/// Maps values such that neighbours on the grid are neighbouring doubles. Codes, as they stand in pages:
/// 0: no grid; 1 + d, d = 0 ... 15: numbers with d decimals; 2000 + e: multiples of 2^e.
struct Grid {
  std::int16_t code = 0;
  double scale = 1, offset = 0;

  [[nodiscard]] double mapped(double value) const { return code == 0 ? value : value * scale + offset; }
  [[nodiscard]] double value(double mapped) const { return code == 0 ? mapped : (mapped - offset) / scale; }
};

[[nodiscard]] Grid grid_of(std::int16_t code);

/// The grid on which all values lie, bit for bit; else that of multiples of `step`, if it is not 0 and large enough for
/// them; else none. O(N).
[[nodiscard]] Grid grid_for(std::span<const double> values, double step);

}  // namespace lober::viewer

// Ticks of an axis at round numbers, with texts that tell them apart whatever the range.
#pragma once

#include <string>
#include <vector>

namespace lober::cli {

struct Tick {
  double fraction;  ///< position on the axis, from 0 at its lower end to 1
  std::string text;
};

/// Texts stand for (value - offset) / 10^power.
struct Ticks {
  std::vector<Tick> list;
  std::string offset;  ///< with its sign, as in "x - 1000000": "\u2212 1000000"; empty: 0
  int power = 0;
};

/// At most `max_count` + 1 ticks for low < high, a step of 1, 2 or 5 times a power of ten apart. Where six digits do
/// not tell them apart, a round offset is taken from all; powers of ten are split off beyond 1e5 and below 1e-4.
[[nodiscard]] Ticks ticks_between(double low, double high, int max_count, bool whole_numbers = false);

}  // namespace lober::cli

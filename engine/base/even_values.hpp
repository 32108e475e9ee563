// Values with a step between them, as "0.5:1.5:0.005" stands for them.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

namespace lober::detail {

inline constexpr double max_even_values = 100'000;

/// first, first + step, ... up to `last`, which is among them if a whole number of steps leads there, to rounding.
/// Each has 14 digits, as a person would write it. None for a step that does not lead from `first` to `last`, or that
/// makes more than `max_even_values`.
[[nodiscard]] inline std::optional<std::vector<double>> even_values(double first, double last, double step) {
  const double steps = (last - first) / step;
  if (step == 0 || !(steps >= 0) || !(steps < max_even_values)) return std::nullopt;
  std::vector<double> values;
  const auto count = static_cast<std::size_t>(std::floor(steps * (1 + 1e-12) + 1e-9)) + 1;
  for (std::size_t k = 0; k < count; ++k) {
    double value = first + static_cast<double>(k) * step;
    std::array<char, 32> text{};
    char* const end = text.data() + text.size();
    const char* const written = std::to_chars(text.data(), end, value, std::chars_format::general, 14).ptr;
    std::from_chars(text.data(), written, value);
    values.push_back(value);
  }
  return values;
}

}  // namespace lober::detail

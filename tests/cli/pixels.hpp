// Pictures as pixels, and whether two of them show the same: tests compare what a reader sees.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace lober::cli {

/// A picture row by row from above, without transparency.
struct Pixels {
  std::size_t width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 3>> colours{};  ///< red, green, blue

  [[nodiscard]] const std::array<std::uint8_t, 3>& at(std::size_t x, std::size_t y) const {
    return colours[y * width + x];
  }
};

/// Reads and writes PNG by cairo (cli/picture/conversion.hpp says whether it is there). Written colours
/// have sixteen values, so that references stay small.
[[nodiscard]] Pixels pixels_of_png(const std::string& bytes);
[[nodiscard]] std::string small_png_of(const Pixels& pixels);

/// The number of squares of 8 pixels, 4 apart, in which some mean colour differs by more than 11 of 255.
/// Edges that are smoothed in another way, and colours rounded to sixteen values, stay below that; a letter, a tick or
/// a line that is missing does not. All of them where the sizes differ.
[[nodiscard]] std::size_t differing_squares(const Pixels& a, const Pixels& b);
/// The number of pixels that differ by more than 64 of 255.
[[nodiscard]] std::size_t differing_pixels(const Pixels& a, const Pixels& b);

}  // namespace lober::cli

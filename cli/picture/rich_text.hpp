// Text of a picture: subscripts and superscripts, and how wide it will be.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lober::cli {

/// The smallest text that can be read in print.
inline constexpr double min_text_size = 6;

/// The text of an element, with entities for the characters that have a meaning in SVG.
[[nodiscard]] std::string escaped(std::string_view text);

/// Width of a text with `_{...}` and `^{...}` at a font size, for the widest of the fonts that may be there.
[[nodiscard]] double text_width(std::string_view text, double size);

/// The text in at most `max_lines` lines that are not wider than `width`, parted at blanks, and within words that are
/// wider. Where that is not enough, the last line ends with an ellipsis.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, double size, double width, std::size_t max_lines);

/// `text` where `lines`, which `wrapped` has made of it, leave a part of it out, for TextStyle::whole; else empty.
[[nodiscard]] std::string_view whole_of_cut(const std::vector<std::string>& lines, std::string_view text);

/// Where a text stands, and how.
struct TextStyle {
  double size = 7;
  const char* anchor = "start";  ///< start, middle or end
  const char* colour = "#222222";
  bool halo = false;         ///< white round the letters, so that they can be read above lines
  bool upward = false;       ///< turned by a quarter
  std::string_view whole{};  ///< what the text is a part of, for readers that point at it; empty: it is whole
};

/// An element with its baseline at (x, y).
void add_text(std::string& svg, double x, double y, std::string_view text, const TextStyle& style);

/// A coordinate with two decimals.
[[nodiscard]] double hundredth(double value);

}  // namespace lober::cli

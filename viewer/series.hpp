// Series of doubles, or of points, as few bytes, for pages: exact, or rounded where that is asked for.
// viewer/page/series.js reads them.
//
// Points of a curve are predicted from those before them, and what is written is how many doubles lie between a
// coordinate and its prediction: few along smooth curves, at any scale, and any double can be written. The coordinate
// that changes faster comes first; as it tells how far along the curve the point is, the other one is predicted from
// there, and deviates across the curve only. Where the distance of points changes abruptly, a break, the distances that
// follow are predicted from the new one.
//
// In a block whose coordinates are multiples of a power of two, or decimal numbers with few digits, doubles between
// such numbers are not counted.
//
// A part of a series is
//
//   for each block of 512    u8 way of prediction, and for each axis i16 grid (grid.hpp)
//   for each axis in turn    u8 symbol of each value
//   all else                 bits of numbers, least significant first, in the order of the values
//
// of the faster coordinates first, wherever they are x or y. A number n >= 0 is 2 n, and n < 0 is -2 n - 1. Symbols
// below 64 are these numbers; 64 + b is a number of b bits, whose highest one is set and whose others follow; 129 + b
// is the same, and a break. Symbols of smooth curves are few and alike, and deflate gives them few bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lober::viewer {

inline constexpr std::size_t series_block = 512;  ///< values of a block

/// The bytes of a series. `step`: a positive power of two, to half of which values may be rounded; 0: none is.
/// `exact`: ascending numbers of values in whose blocks nothing is rounded all the same. O(N).
[[nodiscard]] std::string encode_series(std::span<const double> values, double step = 0,
                                        std::span<const std::uint32_t> exact = {});

/// The bytes of points, given by their coordinates, equally many of each.
[[nodiscard]] std::string encode_points(std::span<const double> x, std::span<const double> y, double step = 0,
                                        std::span<const std::uint32_t> exact = {});

/// The values again, `count` of them. Throws std::out_of_range for bytes that are cut off. O(N).
[[nodiscard]] std::vector<double> decode_series(std::string_view bytes, std::size_t count);

/// The coordinates x and y again, `count` of each.
[[nodiscard]] std::array<std::vector<double>, 2> decode_points(std::string_view bytes, std::size_t count);

}  // namespace lober::viewer

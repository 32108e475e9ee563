// Series of doubles as few bytes, for pages: exact, or in fixed point where that is enough. viewer/page/series.js reads
// them.
//
// A series is parted into blocks of 512 values. A block is a first value b and whole numbers k, such that each value is
// b + k q, q a power of two; of the k, differences of order 1 to 4 are kept, whichever order gives the fewest bits, as
// zigzag numbers, the lowest bytes of all of them first, then the next bytes, and so on. What cannot be written in this
// way, such as NaN, is kept as it is, its bytes in the same order. Differences of smooth curves are small, so most
// bytes are alike and deflate makes little of them.
//
//   for each block    u8 order (0: values as they are), u8 bytes of a number, i16 exponent of q
//   for each block    the heads: b and the first difference of each lower order, f64
//   for each block    the bytes of all other numbers, least significant first
#pragma once

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

/// The values again, `count` of them. Throws std::out_of_range for bytes that are cut off. O(N).
[[nodiscard]] std::vector<double> decode_series(std::string_view bytes, std::size_t count);

}  // namespace lober::viewer

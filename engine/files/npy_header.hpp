// The header of an NPY file.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lober::detail {

inline constexpr std::string_view npy_magic = "\x93NUMPY";

struct NpyHeader {
  std::string type;  ///< such as "<f8"
  bool fortran_order = false;
  std::vector<std::size_t> shape;
  std::size_t size = 0;  ///< bytes before the numbers
};

/// The header of `bytes`, which begin with the magic string, of versions 1.0 to 3.0. Throws DataError "path: ...", also
/// where it goes on behind them.
[[nodiscard]] NpyHeader read_npy_header(std::span<const std::byte> bytes, const std::string& path);

/// The head of an NPY file in C order, which its numbers follow: native float64 numbers, or those of another type of
/// NumPy ("i8", "U12"). No axes: a single element.
[[nodiscard]] std::string npy_head(std::span<const std::size_t> shape, std::string_view type = "f8");

}  // namespace lober::detail

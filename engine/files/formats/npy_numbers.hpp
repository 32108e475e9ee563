// The numbers and texts of any NPY array, as NPZ archives hold them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engine/files/npy_header.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

/// Whether the elements are numbers that are read: integers, floats of two to eight bytes, complex numbers of two
/// floats of four or eight bytes, true and false.
[[nodiscard]] bool holds_numbers(const NpyHeader& header);
[[nodiscard]] bool holds_complex_numbers(const NpyHeader& header);

/// The numbers behind the header, the last axis fastest; of a complex one real and imaginary part. Throws DataError
/// "path: ..." where they are fewer or more than the header promises.
[[nodiscard]] Buffer<double> npy_numbers(const NpyHeader& header, std::span<const std::byte> data,
                                         const std::string& path);

/// The texts behind the header, in UTF-8; empty where the elements are not texts.
[[nodiscard]] std::vector<std::string> npy_texts(const NpyHeader& header, std::span<const std::byte> data);

}  // namespace lober::detail

// The names of the files that jobs write.
#pragma once

#include <string>
#include <string_view>

#include "engine/batch/operations/options.hpp"

namespace lober::detail {

/// "folder/{name}_{max_length}.npy" with its holes filled in: {name} and {second} with the name of the first and of the
/// second curve, without its folder, {KEY} with the value of that option. Other braces stay as they are. Names lose the
/// ending of a format that is not NPY where more follows, and a name that ends with the value of an option gains .npy.
[[nodiscard]] std::string output_name(std::string_view pattern, const Options& options, std::string_view first,
                                      std::string_view second);

/// The ending of a name that stands for another format than NPY; empty where it does not.
[[nodiscard]] std::string_view other_ending(std::string_view name);

}  // namespace lober::detail

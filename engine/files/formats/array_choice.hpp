// Which arrays of a file are curves: as asked for, or as their names and shapes say.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/files/formats/arrays.hpp"

namespace lober::detail {

/// Arrays by their positions in the file.
struct ChosenArrays {
  std::vector<std::size_t> coordinates;  ///< x and y, or one array of points
  std::optional<std::size_t> group, offsets, counts;
};

/// The arrays that a choice names (read_arrays), or those that are meant where it is empty. Throws DataError "path:
/// ...", which names the arrays that are there.
[[nodiscard]] ChosenArrays choose_arrays(const std::vector<ArrayInfo>& arrays, std::string_view choice,
                                         const std::string& path);

/// "x (10 x 2)", "z (10, complex)"
[[nodiscard]] std::string described(const ArrayInfo& array);
/// The name behind the last '/'.
[[nodiscard]] std::string last_part(const std::string& name);
/// Whether the array alone is points: N x 2 or 2 x N real numbers, or complex ones.
[[nodiscard]] bool holds_points(const ArrayInfo& array);
/// Whether two names are the same in any case.
[[nodiscard]] bool same_in_any_case(std::string_view a, std::string_view b);

}  // namespace lober::detail

// The largest number of anything: numbers of points, contacts and half-edges have 32 bits, some of them one to
// spare.
#pragma once

#include <cstddef>
#include <string_view>

namespace lober::detail {

inline constexpr std::size_t max_count = (std::size_t{1} << 31) - 1;

/// Throws DataError "COUNT WHAT, the limit is 2147483647" when there are more.
void require_countable(std::size_t count, std::string_view what);

}  // namespace lober::detail

// The primary crossings, and between which of them the others lie (private to tangle/).
#pragma once

#include <cstdint>
#include <vector>

#include "lober/base/buffer.hpp"
#include "lober/overlay/crossings.hpp"

namespace lober::detail {

/// Node numbers of the pips in order along U. One sweep: records of nearness along S. O(nodes). With `turn_u`,
/// `turn_s`, what they would be if that curve ran the other way.
[[nodiscard]] std::vector<std::uint32_t> find_pips(const Crossings& nodes, bool turn_u = false, bool turn_s = false);

}  // namespace lober::detail

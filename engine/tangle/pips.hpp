// Which crossings are primary, and between which of them the others lie (private to tangle/).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/crossings/crossings.hpp"
#include "engine/memory.hpp"

namespace lober {

/// Node numbers of the pips in order along U. One sweep: records of nearness along S. O(nodes).
[[nodiscard]] std::vector<std::uint32_t> find_pips(const Crossings& nodes);

}  // namespace lober

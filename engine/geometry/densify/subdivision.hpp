// Writing the points of a subdivided curve (private to densify/).
#pragma once

#include <cstdint>

#include "engine/geometry/densify/interpolant.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

/// The points of the curve with segment k cut into parts[k] equal parts (of its parameter). `begin` receives the index
/// of each vertex given in the result, and the size of the result as its last element. Parallel by blocks of the
/// result.
[[nodiscard]] Buffer<Point> subdivided(const Interpolant& interpolant, const Buffer<std::uint32_t>& parts,
                                       Buffer<std::uint64_t>& begin);

}  // namespace lober::detail

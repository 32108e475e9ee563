// Many points located at once: vertices of one curve with respect to another.
//
// Rays from vertices that are near each other meet the same nodes of the other tree, mostly. So the walk goes down the
// tree of the vertices and carries along the nodes that rays from there may have to look into, as searches for pairs do
// (tree_walk.hpp), with a number for what all of these rays cross alike.
#pragma once

#include <cstdint>
#include <span>

#include "engine/geometry/index/box_tree.hpp"
#include "engine/geometry/index/ray_crossings.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

/// ray_crossings(other, vertex) of each of these vertices of the curve of `own`, given by their numbers in ascending
/// order. Exact, parallel. Takes about as long as a search for pairs if most leaves have one; few vertices are located
/// one by one.
[[nodiscard]] Buffer<RayCrossings> vertex_rays(const BoxTree& own, const BoxTree& other,
                                               std::span<const std::uint32_t> vertices);

}  // namespace lober::detail

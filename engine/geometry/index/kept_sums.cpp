#include "engine/geometry/index/kept_sums.hpp"

#include <algorithm>

#include "engine/geometry/index/box_tree.hpp"
#include "kernels/shoelace.hpp"

namespace lober::detail {

KeptSums::KeptSums(const BoxTree& tree) {
  const Point origin = tree.leaf_begin(0);
  segments_.resize(tree.segments());
  LeafPrefixes leaves, prefixes;
  for (std::size_t chunk = 0; chunk < tree.chunk_sums().size(); ++chunk) {
    const std::size_t first = chunk * leaf_size, last = std::min(first + leaf_size, tree.leaves());
    shoelace_prefixes(tree.chunk_points(chunk), origin, total_, tree.leaf_sums() + first, leaves);
    for (std::size_t leaf = first; leaf < last; ++leaf) {
      shoelace_prefixes(tree.leaf_points(leaf), origin, leaves.before(leaf - first), nullptr, prefixes);
      const std::size_t begin = leaf * leaf_size, end = std::min(begin + leaf_size, tree.segments());
      for (std::size_t k = begin; k < end; ++k) segments_[k] = {prefixes.before(k - begin), prefixes.term(k - begin)};
    }
    total_ += tree.chunk_sums()[chunk];
    total_ += shoelace(*tree.chunk_points(chunk), *tree.chunk_points(chunk + 1), origin);
  }
}

}  // namespace lober::detail

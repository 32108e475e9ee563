// The three searches behind find_pairs (private to this folder).
#pragma once

#include "engine/geometry/index/index.hpp"

namespace lober::detail {

SearchCounts find_pairs_by_tree(const IndexedCurve& first, const IndexedCurve& second, PairConsumer& consumer);
SearchCounts find_pairs_by_grid(const IndexedCurve& first, const IndexedCurve& second, PairConsumer& consumer);
SearchCounts find_pairs_by_kd(const IndexedCurve& first, const IndexedCurve& second, PairConsumer& consumer);

}  // namespace lober::detail

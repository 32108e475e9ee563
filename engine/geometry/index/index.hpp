// Spatial indexes: which pairs of segments can meet.
//
// Three indexes answer the same question and are interchangeable: the curve-order box tree (the default: built in
// one streaming pass, because the points of a curve come in order), the uniform grid, and the k-d tree (nanoflann).
// They differ in the candidates that they propose; every candidate is then decided by exact predicates, so
// the crossings that come out are the same bits for each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "engine/geometry/index/box_tree.hpp"
#include "kernels/segment_boxes.hpp"
#include "lober/overlay/counts.hpp"
#include "lober/overlay/index.hpp"

namespace lober::detail {

/// Segments of the first curve that one task handles together: the pairs of a block arrive one after another, in any
/// order, and different blocks at the same time. The cut depends on the curve only.
inline constexpr std::uint32_t block_segments = 64 * leaf_size;

/// Takes the candidate pairs of a search.
class PairConsumer {
 public:
  PairConsumer() = default;
  PairConsumer(const PairConsumer&) = delete;
  PairConsumer& operator=(const PairConsumer&) = delete;
  virtual ~PairConsumer() = default;

  /// Some pairs of block `block`. Over all calls every pair of segments with a common point comes exactly once; pairs
  /// without may come too, at most once. Called from one thread at a time per block; runs of leaf_size segments of
  /// the first curve come in ascending order. Returns the number of the first segment of the first curve that is of
  /// interest from now on: the part before (a shared arc that is already known) may be skipped.
  virtual std::uint32_t consume(std::uint32_t block, std::span<const SegmentPair> pairs) = 0;

  /// False when the pairs of a block are of no interest any more: a search of a curve with itself may leave it out.
  [[nodiscard]] virtual bool wants(std::uint32_t /*block*/) const { return true; }

  /// No more pairs of this block.
  virtual void finish(std::uint32_t block) = 0;
};

/// Hands every pair of segments (one of `first`, one of `second`) that have a point in common to the consumer, in
/// parallel, and none whose boxes do not meet. Segments of no length may be left out. `kind` must not be `automatic`
/// (see choose_index). Grid and k-d tree are built over `second`, then thrown away.
SearchCounts find_pairs(const IndexedCurve& first, const IndexedCurve& second, IndexKind kind, PairConsumer& consumer);

/// Hands all pairs i < j of segments of one curve that meet in more than a common end to the consumer, and only such
/// whose boxes meet. Pairs inside a monotone run, and neighbours that turn by less than a right angle, do not come.
SearchCounts find_self_pairs(const IndexedCurve& curve, PairConsumer& consumer);

/// The index with the smallest expected cost for this pair of curves; the tree unless segments are so long and slanted
/// that their boxes say little. Looks at a sample of a few hundred leaves.
[[nodiscard]] IndexKind choose_index(const IndexedCurve& first, const IndexedCurve& second);

}  // namespace lober::detail

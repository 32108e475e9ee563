#include "engine/geometry/index/box_tree.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/curve/countable.hpp"
#include "engine/geometry/index/node_frames.hpp"

namespace lober::detail {
namespace {
constexpr std::uint32_t block_levels = 10;        // a task builds the subtree over 2^10 leaves, which fits the L2 cache
constexpr std::uint32_t uses_before_keeping = 6;  // two for each overlay: keeping takes as long as some overlays
}  // namespace

BoxTree::BoxTree(CurveView curve) : curve_(curve) {
  const std::size_t segment_count = curve_.segments();
  if (segment_count == 0) throw DataError("a curve without segments has no index");
  require_countable(segment_count, "segments to index");
  const auto leaf_count = static_cast<std::uint32_t>((segment_count + leaf_size - 1) / leaf_size);
  std::uint32_t total = 0;
  for (std::uint32_t size = leaf_count;; size = (size + 1) / 2) {
    level_size_[levels_] = size;
    level_begin_[levels_] = total;
    total += size;
    ++levels_;
    if (size == 1) break;
  }
  boxes_.resize(total + nodes_at_once - 1);  // a pyramid is read by fours
  std::fill(boxes_.begin() + total, boxes_.end(), Box{});
  flags_.resize(total);
  chunk_sums_.resize((leaf_count + leaf_size - 1) / leaf_size);
  sums_.resize(chunk_sums_.size() * leaf_size);
  starts_.resize(chunk_sums_.size() * leaf_size + 1);

  const std::size_t tail_begin = std::size_t{leaf_count - 1} * leaf_size;
  for (std::size_t i = 0; i <= leaf_size; ++i) {
    const std::size_t vertex = std::min(tail_begin + i, segment_count);
    tail_[i] = curve_.points[vertex == curve_.points.size() ? 0 : vertex];
  }

  std::atomic<bool> stalls{false};
  for_each_block(leaf_count, std::size_t{1} << block_levels, [&](std::size_t begin, std::size_t end) {
    const std::size_t whole = std::min<std::size_t>(end, leaf_count - 1);
    if (whole > begin) {
      summarise_leaves(curve_.points.data(), begin, whole - begin, boxes_.data(), sums_.data(), flags_.data());
    }
    if (end == leaf_count) {
      const std::size_t last = leaf_count - 1;
      summarise_leaves(tail_.data(), 0, 1, &boxes_[last], &sums_[last], &flags_[last]);
    }
    sum_chunks(begin, end);
    for (std::uint32_t level = 1; level <= block_levels && level < levels_; ++level) {
      build_upper(level, begin >> level, ((end - 1) >> level) + 1);
    }
    if (stalls_between(begin, end)) stalls.store(true, std::memory_order_relaxed);
  });
  stalls_ = stalls;
  for (std::uint32_t level = block_levels + 1; level < levels_; ++level) build_upper(level, 0, level_size_[level]);
}

BoxTree::~BoxTree() {
  delete kept_sums_.load(std::memory_order_relaxed);
  delete frames_.load(std::memory_order_relaxed);
}

namespace {
// Puts what was made where nobody has put any yet, and gives what is there.
template <typename T>
const T* keep_first(std::atomic<const T*>& place, std::unique_ptr<const T> made) {
  const T* present = nullptr;  // another thread may have been as fast
  if (!place.compare_exchange_strong(present, made.get(), std::memory_order_acq_rel)) return present;
  return made.release();
}
}  // namespace

const NodeFrames& BoxTree::make_frames() const {
  if (const NodeFrames* const made = frames()) return *made;
  return *keep_first(frames_, std::make_unique<const NodeFrames>(*this));
}

const KeptSums* BoxTree::kept_sums() const {
  if (segments() > KeptSums::max_segments) return nullptr;
  if (const KeptSums* const kept = kept_sums_.load(std::memory_order_acquire)) return kept;
  if (uses_.fetch_add(1, std::memory_order_relaxed) < uses_before_keeping) return nullptr;
  return keep_first(kept_sums_, std::make_unique<const KeptSums>(*this));
}

// The shoelace sum of a chunk is that of its leaves plus that of the polygon of leaf beginnings, for which the kernel
// that sums leaves serves once more.
void BoxTree::sum_chunks(std::size_t begin, std::size_t end) {
  std::array<Box, (std::size_t{1} << block_levels) / leaf_size> boxes;
  std::array<std::uint8_t, boxes.size()> flags;
  const std::size_t chunks = (end - begin + leaf_size - 1) / leaf_size;
  const std::size_t padded_end = begin + chunks * leaf_size;
  for (std::size_t k = begin; k < end; ++k) starts_[k] = curve_.points[k * leaf_size];
  for (std::size_t k = end; k < padded_end; ++k) {
    starts_[k] = tail_[leaf_size];
    sums_[k] = {};
  }
  // The point behind the last chunk belongs to the block that follows, if any.
  std::array<Point, leaf_size + 1> last;
  std::copy_n(&starts_[padded_end - leaf_size], leaf_size, last.begin());
  last[leaf_size] = end < leaves() ? curve_.points[end * leaf_size] : tail_[leaf_size];
  if (end == leaves()) starts_[padded_end] = last[leaf_size];
  DD* sums = &chunk_sums_[begin / leaf_size];
  summarise_leaves(&starts_[begin], 0, chunks - 1, boxes.data(), sums, flags.data());
  summarise_leaves(last.data(), 0, 1, boxes.data(), sums + (chunks - 1), flags.data());
  for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
    const std::size_t first = begin + chunk * leaf_size;
    double high = 0, low = 0;
    for (std::size_t leaf = first; leaf < std::min(end, first + leaf_size); ++leaf) {
      const DD sum = two_sum(high, sums_[leaf].hi);
      high = sum.hi;
      low += sum.lo + sums_[leaf].lo;
    }
    sums[chunk] += fast_two_sum(high, low);
  }
}

void BoxTree::build_upper(std::uint32_t level, std::size_t begin, std::size_t end) {
  const Box* below = &boxes_[level_begin_[level - 1]];
  const std::uint8_t* flags_below = &flags_[level_begin_[level - 1]];
  Box* here = &boxes_[level_begin_[level]];
  std::uint8_t* flags_here = &flags_[level_begin_[level]];
  const std::size_t pairs = std::min<std::size_t>(end, level_size_[level - 1] / 2);
  for (std::size_t k = begin; k < pairs; ++k) {
    here[k] = union_of(below[2 * k], below[2 * k + 1]);
    flags_here[k] = flags_below[2 * k] & flags_below[2 * k + 1];
  }
  if (pairs < end) {  // an odd last node has one child
    here[pairs] = below[2 * pairs];
    flags_here[pairs] = flags_below[2 * pairs];
  }
}

// A run of points that fills a node of level 2. Shorter ones do no harm.
bool BoxTree::stalls_between(std::size_t begin, std::size_t end) const {
  constexpr std::uint32_t level = 2;
  if (levels_ <= level) return false;
  const Box* const boxes = &boxes_[level_begin_[level]];
  return std::any_of(boxes + (begin >> level), boxes + ((end - 1) >> level) + 1, is_point);
}

bool BoxTree::sums_finite() const {
  return std::all_of(chunk_sums_.begin(), chunk_sums_.end(),
                     [](const DD& sum) { return std::isfinite(sum.hi + sum.lo); });
}

std::size_t BoxTree::memory() const {
  return boxes_.capacity() * sizeof(Box) + flags_.capacity() +
         (sums_.capacity() + chunk_sums_.capacity()) * sizeof(DD) + starts_.capacity() * sizeof(Point) +
         (segments() <= KeptSums::max_segments ? KeptSums::memory(segments()) : NodeFrames::memory(*this));
}

}  // namespace lober::detail

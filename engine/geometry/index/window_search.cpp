// Where a curve is folded upon itself many times, the pieces of it that lie in a window are folds side by side, and
// in the order of the curve each is next to its neighbour. So a binary tree over them, of whatever lies in the window,
// has nodes that are bundles of folds, which strips (kernels/strip.hpp) tell from other bundles. In a window that is
// too large for that, folds turn away from any strip; it is split.

#include "engine/geometry/index/window_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/strip.hpp"

namespace lober::detail {
namespace {

// A window in which bundles meet more others than these, each on average, is split. Where that does not help either,
// many leaves lie across each other, and those that meet are not worth listing from the second number on.
constexpr std::size_t max_met = 16, max_listed = 256;
// In windows of as few leaves everything is compared.
constexpr std::size_t smallest = 64;

struct LeafPair {
  std::uint32_t first, second;
};

Box clipped(const Box& box, const Box& window) {
  Box result;
  for (std::size_t k = 0; k < 4; ++k) result.lane[k] = std::max(box.lane[k], window.lane[k]);
  return result;
}

// The leaves that a window has to do with, and the bundles of them.
class Window {
 public:
  Window(const BoxTree& tree, const Buffer<Strip>& leaf_strips, const Box& window, std::vector<std::uint32_t> leaves)
      : tree_(tree), leaf_strips_(leaf_strips), window_(window), leaves_(std::move(leaves)) {}

  // All pairs of leaves that may meet in the window, which is split as long as that helps; none where they are too
  // many.
  std::optional<std::vector<LeafPair>> search(SearchCounts& counts) {
    if (leaves_.empty()) return std::vector<LeafPair>{};
    const bool is_small = leaves_.size() <= smallest;
    if (is_small || !is_bent()) {
      bundle();
      if (auto found = meet_by_levels(is_small ? smallest : max_met, counts)) return found;
    }
    std::optional<std::array<Window, 2>> halves = split();
    if (!halves) {
      if (boxes_.empty()) bundle();
      return meet_by_levels(max_listed, counts);
    }
    boxes_ = {};
    strips_ = {};
    bundles_ = {};
    std::array<std::optional<std::vector<LeafPair>>, 2> found;
    std::array<SearchCounts, 2> half_counts;
    for_each_block(2, 1, [&](std::size_t k, std::size_t) { found[k] = (*halves)[k].search(half_counts[k]); });
    for (const SearchCounts& half : half_counts) counts += half;
    if (!found[0] || !found[1]) return std::nullopt;
    found[0]->insert(found[0]->end(), found[1]->begin(), found[1]->end());
    return std::move(found[0]);
  }

 private:
  // Whether arcs turn too much across the window for strips to follow them.
  [[nodiscard]] bool is_bent() const {
    constexpr std::size_t samples = 255;
    constexpr double most = 0.3;
    std::vector<double> bends;
    const std::size_t step = std::max<std::size_t>(1, leaves_.size() / samples);
    for (std::size_t k = step / 2; k < leaves_.size(); k += step)
      bends.push_back(std::fabs(leaf_strips_[leaves_[k]].bend));
    const auto middle = bends.begin() + static_cast<std::ptrdiff_t>(bends.size() / 2);
    std::nth_element(bends.begin(), middle, bends.end());
    return *middle * std::max(window_.width(), window_.height()) > most;
  }

  // Boxes, strips, flags and ends of all bundles.
  void bundle() {
    const std::size_t count = leaves_.size();
    std::size_t total = 0;
    levels_ = 0;
    for (std::size_t size = count;; size = (size + 1) / 2) {
      begin_[levels_] = static_cast<std::uint32_t>(total);
      size_[levels_++] = static_cast<std::uint32_t>(size);
      total += size;
      if (size == 1) break;
    }
    boxes_.resize(total);
    strips_.resize(total);
    bundles_.resize(total);
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint32_t leaf = leaves_[k];
      boxes_[k] = tree_.leaf_boxes()[leaf];
      strips_[k] = leaf_strips_[leaf];
      bundles_[k] = {leaf, leaf, tree_.flags({0, leaf})};
    }
    for (std::uint32_t level = 1; level < levels_; ++level) {
      const std::size_t below = begin_[level - 1], here = begin_[level], pairs = size_[level - 1] / 2;
      join_strips(&strips_[below], pairs, &strips_[here]);
      for (std::size_t k = 0; k < pairs; ++k) {
        const std::size_t first = below + 2 * k;
        boxes_[here + k] = union_of(boxes_[first], boxes_[first + 1]);
        const Bundle &one = bundles_[first], &other = bundles_[first + 1];
        const bool together = one.last + 1 == other.first;
        bundles_[here + k] = {one.first, other.last, static_cast<std::uint8_t>(together ? one.flags & other.flags : 0)};
      }
      if (size_[level] == pairs) continue;
      boxes_[here + pairs] = boxes_[below + 2 * pairs];
      strips_[here + pairs] = strips_[below + 2 * pairs];
      bundles_[here + pairs] = bundles_[below + 2 * pairs];
    }
  }

  // Level by level the bundles that may meet each; none when they are more than `most` on average.
  [[nodiscard]] std::optional<std::vector<LeafPair>> meet_by_levels(std::size_t most, SearchCounts& counts) const {
    std::vector<std::uint32_t> met{0}, met_end{1}, met_below, met_end_below;
    std::vector<TreeNode> list;
    for (std::uint32_t level = levels_ - 1; level-- > 0;) {
      met_below.clear();
      met_end_below.resize(size_[level]);
      for (std::uint32_t k = 0; k < size_[level]; ++k) {
        const std::size_t from = k < 2 ? 0 : met_end[k / 2 - 1], to = met_end[k / 2];
        list.resize(2 * (to - from));
        const BoxQuery query(clipped(boxes_[begin_[level] + k], window_));
        std::size_t count = 0;
        for (std::size_t i = from; i < to; ++i) {
          const std::uint32_t first = 2 * met[i], last = std::min(first + 1, size_[level] - 1);
          for (std::uint32_t other = std::max(first, k); other <= last; ++other) {
            list[count] = {level, other};
            count += static_cast<std::size_t>(meet(query, boxes_[begin_[level] + other]) && !apart(level, k, other));
          }
        }
        counts.boxes_tested += 2 * (to - from) + count;
        count = keep_near(strips_[begin_[level] + k], {strips_.data(), begin_.data()}, list.data(), count);
        for (std::size_t i = 0; i < count; ++i) met_below.push_back(list[i].index);
        met_end_below[k] = static_cast<std::uint32_t>(met_below.size());
      }
      if (met_below.size() > most * size_[level]) return std::nullopt;
      met.swap(met_below);
      met_end.swap(met_end_below);
    }
    std::vector<LeafPair> found;
    found.reserve(met.size());
    for (std::uint32_t k = 0, i = 0; k < size_[0]; ++k) {
      for (; i < met_end[k]; ++i) found.push_back({leaves_[k], leaves_[met[i]]});
    }
    return found;
  }

  // Nothing to find between the two: they are one monotone run.
  [[nodiscard]] bool apart(std::uint32_t level, std::uint32_t one, std::uint32_t other) const {
    const Bundle &a = bundles_[begin_[level] + one], &b = bundles_[begin_[level] + other];
    if ((a.flags & b.flags) == 0) return false;
    const bool wraps = a.first == 0 && b.last + 1 == tree_.leaves() && tree_.curve().closed;
    return one == other || a.last + 1 == b.first || wraps;
  }

  // In the middle of its leaves, where the fewest are cut; none if that does not part them.
  [[nodiscard]] std::optional<std::array<Window, 2>> split() const {
    constexpr std::size_t samples = 255;
    std::optional<std::array<Window, 2>> best;
    std::size_t best_size = leaves_.size() + leaves_.size() / 4;  // as many may be in both
    for (std::size_t axis = 0; axis < 2; ++axis) {
      std::vector<double> centres;
      const std::size_t step = std::max<std::size_t>(1, leaves_.size() / samples);
      for (std::size_t k = step / 2; k < leaves_.size(); k += step) {
        const Box box = clipped(tree_.leaf_boxes()[leaves_[k]], window_);
        centres.push_back(0.5 * box.lane[axis] - 0.5 * box.lane[axis + 2]);
      }
      const auto middle = centres.begin() + static_cast<std::ptrdiff_t>(centres.size() / 2);
      std::nth_element(centres.begin(), middle, centres.end());
      std::array<Box, 2> windows{window_, window_};
      windows[0].lane[axis + 2] = -*middle;
      windows[1].lane[axis] = *middle;
      std::array<std::vector<std::uint32_t>, 2> in;
      for (std::size_t k = 0; k < 2; ++k) {
        in[k].reserve(leaves_.size());
        const BoxQuery query(windows[k]);
        for (const std::uint32_t leaf : leaves_) {
          if (meet(query, tree_.leaf_boxes()[leaf])) in[k].push_back(leaf);
        }
      }
      const std::size_t size = in[0].size() + in[1].size();
      if (std::max(in[0].size(), in[1].size()) > leaves_.size() * 4 / 5 || size >= best_size) continue;
      best_size = size;
      best.emplace(std::array<Window, 2>{Window(tree_, leaf_strips_, windows[0], std::move(in[0])),
                                         Window(tree_, leaf_strips_, windows[1], std::move(in[1]))});
    }
    return best;
  }

  struct Bundle {
    std::uint32_t first, last;  // leaf
    std::uint8_t flags;         // MonotoneFlags, if it is one piece
  };
  const BoxTree& tree_;
  const Buffer<Strip>& leaf_strips_;
  Box window_;
  std::vector<std::uint32_t> leaves_;  // ascending
  std::uint32_t levels_ = 0;
  std::array<std::uint32_t, 32> begin_{}, size_{};
  Buffer<Box> boxes_;
  Buffer<Strip> strips_;
  std::vector<Bundle> bundles_;
};

}  // namespace

NearLeaves::NearLeaves(const BoxTree& tree, SearchCounts& counts) {
  Buffer<Strip> strips(tree.leaves());
  for_each_block(tree.leaves(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t leaf = begin; leaf < end; ++leaf) leaf_strip(tree.leaf_points(leaf), strips[leaf]);
  });
  std::vector<std::uint32_t> leaves;
  leaves.reserve(tree.leaves());
  for (std::uint32_t k = 0; k < tree.leaves(); ++k) {
    if (!is_point(tree.leaf_boxes()[k])) leaves.push_back(k);
  }
  const std::optional<std::vector<LeafPair>> pairs = Window(tree, strips, tree.box(), std::move(leaves)).search(counts);
  is_complete_ = pairs.has_value();
  if (!is_complete_) return;
  begin_.resize(tree.leaves() + 1);
  for (const LeafPair& pair : *pairs) ++begin_[pair.first + 1];
  for (std::size_t k = 0; k < tree.leaves(); ++k) begin_[k + 1] += begin_[k];
  end_.assign(begin_.begin(), begin_.end() - 1);
  others_.resize(pairs->size());
  for (const LeafPair& pair : *pairs) others_[end_[pair.first]++] = {0, pair.second};
  // Windows beside each other find some twice.
  for (std::size_t k = 0; k < tree.leaves(); ++k) {
    const auto first = others_.begin() + begin_[k], last = others_.begin() + end_[k];
    std::sort(first, last, [](TreeNode a, TreeNode b) { return a.index < b.index; });
    end_[k] = static_cast<std::uint32_t>(std::unique(first, last) - others_.begin());
  }
}

}  // namespace lober::detail

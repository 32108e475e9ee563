// The choice of an index for a pair of curves.
//
// The tree is right nearly always. It fails where boxes say little: long slanted segments, whose boxes
// overlap most others though the segments are apart. Whether that is so is seen by walking a few leaves of
// the first curve through the tree of the second, which costs next to nothing when the answer is no. If it is
// yes, both costs are estimated on samples.

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "engine/geometry/index/block_search.hpp"
#include "engine/geometry/index/raster.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t leaves_glanced_at = 32;
constexpr std::size_t tree_leaves_sampled = 256;
constexpr std::size_t leaves_met_at_most = 512;  // per leaf walked through the tree; more are extrapolated
constexpr std::size_t leaf_pairs_looked_into = 256;
constexpr std::size_t segments_drawn = 1 << 12;
constexpr std::size_t cells_visited_at_most = 1 << 15;
constexpr double moderate = 64;        // candidates per segment: below this the tree is not questioned
constexpr double worth_asking = 20e6;  // nanoseconds: what takes the tree less takes the grid as much to be built
constexpr double clearly = 3;          // how many times cheaper the grid must be

// Rough costs in nanoseconds; what matters is that all are right within a factor of two or so.
constexpr double cost_of_leaf_pair = 120;
constexpr double cost_of_candidate = 12;   // to propose and to decide
constexpr double cost_of_grid_entry = 15;  // to enter, sort and look up
constexpr double cost_of_grid_comparison = 2;

// Findings of walking leaves of the first curve through the tree of the second.
struct TreeSample {
  double leaf_pairs = 0;  // per leaf of the first curve
  double candidates = 0;  // per leaf pair
};

// The leaves of `tree` that meet `box`, from the left, the first leaves_met_at_most of them; returns the
// number expected in all.
double leaves_meeting(const BoxTree& tree, const Box& box, Buffer<std::uint32_t>& met) {
  std::array<TreeNode, 64> stack;
  std::size_t size = 0;
  stack[size++] = tree.root();
  met.clear();
  while (size > 0) {
    const TreeNode node = stack[--size];
    if (!meet(tree.box(node), box)) continue;
    if (node.level == 0) {
      met.push_back(node.index);
      if (met.size() < leaves_met_at_most) continue;
      const double walked = static_cast<double>(node.index + 1) / static_cast<double>(tree.leaves());
      return static_cast<double>(met.size()) / walked;
    }
    const TreeNode left{node.level - 1, 2 * node.index};
    if (left.index + 1 < tree.nodes(left.level)) stack[size++] = {left.level, left.index + 1};
    stack[size++] = left;
  }
  return static_cast<double>(met.size());
}

TreeSample sample_tree(const BoxTree& first, const BoxTree& second, std::size_t leaves) {
  const std::size_t looked_at = std::min(first.leaves(), leaves);
  TreeSample sample;
  Buffer<std::uint32_t> met;
  std::array<SegmentPair, leaf_size * leaf_size> pairs;
  double looked_into = 0, candidates = 0;
  for (std::size_t k = 0; k < looked_at; ++k) {
    const auto leaf = static_cast<std::uint32_t>(k * first.leaves() / looked_at);
    sample.leaf_pairs += leaves_meeting(second, first.leaf_boxes()[leaf], met);
    if (met.size() * leaf_size < static_cast<std::size_t>(moderate)) continue;
    SegmentBoxes boxes;
    segment_boxes(first.leaf_points(leaf), boxes);
    const std::size_t step = std::max<std::size_t>(met.size() * looked_at / leaf_pairs_looked_into, 1);
    for (std::size_t m = k % step; m < met.size(); m += step) {
      candidates += static_cast<double>(
          meeting_segments(boxes, 0, second.leaf_points(met[m]), second.leaf_boxes()[met[m]], 0, pairs.data()));
      looked_into += 1;
    }
  }
  sample.leaf_pairs /= static_cast<double>(looked_at);
  if (looked_into > 0) sample.candidates = candidates / looked_into;
  return sample;
}

// Cells that randomly drawn segments of a curve pass through, and how many times as many the whole curve
// would.
struct CellSample {
  std::vector<std::size_t> cells;
  double factor = 1;
};

// Draws are independent of each other and of those of the other curve: evenly spaced ones would fall into
// step.
CellSample sample_cells(const BoxTree& tree, const Raster& raster, std::uint64_t state) {
  const CurveView& curve = tree.curve();
  CellSample sample;
  std::size_t drawn = 0;
  for (; drawn < segments_drawn && sample.cells.size() < cells_visited_at_most; ++drawn) {
    state = state * 6364136223846793005U + 1442695040888963407U;  // Knuth's MMIX generator
    const auto segment = static_cast<std::uint32_t>((state >> 32U) * curve.segments() >> 32U);
    const Segment ends = curve.segment(segment);
    raster.for_each_cell(ends.a, ends.b, [&](std::size_t cell) { sample.cells.push_back(cell); });
  }
  sample.factor = static_cast<double>(curve.segments()) / static_cast<double>(drawn);
  return sample;
}

// The cost of a grid over the second curve, by entering a sample of it and looking up a sample of the first. Many
// points in one cell show as many comparisons, wherever they come from.
double grid_cost(const BoxTree& first, const BoxTree& second) {
  const Raster raster = Raster::fitted(second, intersection(first.box(), second.box()),
                                       max_grid_entries(first.segments() + second.segments()), tree_leaves_sampled);
  const CellSample entered = sample_cells(second, raster, 1), visited = sample_cells(first, raster, 2);
  std::unordered_map<std::size_t, std::uint32_t> occupancy;
  for (const std::size_t cell : entered.cells) ++occupancy[cell];
  double compared = 0;
  for (const std::size_t cell : visited.cells) {
    const auto found = occupancy.find(cell);
    if (found != occupancy.end()) compared += found->second;
  }
  return cost_of_grid_entry * (static_cast<double>(entered.cells.size()) * entered.factor +
                               static_cast<double>(visited.cells.size()) * visited.factor) +
         cost_of_grid_comparison * compared * entered.factor * visited.factor;
}

}  // namespace

IndexKind choose_index(const IndexedCurve& first, const IndexedCurve& second) {
  if (!meet(first.tree().box(), second.tree().box())) return IndexKind::tree;
  // The tree at its worst, every leaf meeting every other one. For short curves this is all there is to know, and many
  // jobs of a batch are pairs of such.
  const double worst = static_cast<double>(first.tree().leaves()) * static_cast<double>(second.tree().leaves()) *
                       (cost_of_leaf_pair + cost_of_candidate * leaf_size * leaf_size);
  if (worst < worth_asking) return IndexKind::tree;
  // A glance settles the ordinary case.
  const TreeSample glance = sample_tree(first.tree(), second.tree(), leaves_glanced_at);
  if (8 * glance.leaf_pairs * glance.candidates < moderate * leaf_size) return IndexKind::tree;
  const TreeSample sample = sample_tree(first.tree(), second.tree(), tree_leaves_sampled);
  if (sample.leaf_pairs * sample.candidates < moderate * leaf_size) return IndexKind::tree;
  const double tree_cost = static_cast<double>(first.tree().leaves()) * sample.leaf_pairs *
                           (cost_of_leaf_pair + cost_of_candidate * sample.candidates);
  if (tree_cost < worth_asking) return IndexKind::tree;
  return clearly * grid_cost(first.tree(), second.tree()) < tree_cost ? IndexKind::grid : IndexKind::tree;
}

}  // namespace lober::detail

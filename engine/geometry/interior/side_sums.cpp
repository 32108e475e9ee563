#include "engine/geometry/interior/side_sums.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/shoelace.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t leaves_per_block = 32, points_a_block = leaves_per_block * leaf_size;

// The three sums of one block.
class Collector {
 public:
  void add(Side side, DD term) {
    sums_[static_cast<std::size_t>(side)].add(term);
    ++terms_;
  }
  void add_leaf(Side side, DD sum) {
    sums_[static_cast<std::size_t>(side)].add(sum);
    terms_ += leaf_size;
  }
  // A term is wrong by less than 2^-102 |a - o| |b - a|, each addition by less than 2^-106 of the largest partial sum.
  [[nodiscard]] SideSums result(double length, double extent) const {
    const auto sum = [&](Side side) { return sums_[static_cast<std::size_t>(side)].value(); };
    const double error = (0x1p-101 + static_cast<double>(terms_) * 0x1p-105) * length * extent;
    return {sum(Side::outside), sum(Side::on), sum(Side::inside), error};
  }

 private:
  std::array<RunningSum, 3> sums_;
  std::size_t terms_ = 0;
};

// Adds up blocks in their order. `length` is that of the whole curve: each addition may lose 2^-104 of what came
// before.
SideSums joined(const std::vector<SideSums>& blocks, double length, double extent) {
  SideSums total;
  for (const SideSums& block : blocks) {
    total.outside += block.outside;
    total.on += block.on;
    total.inside += block.inside;
    total.error += block.error;
  }
  total.error += static_cast<double>(blocks.size()) * 0x1p-104 * length * extent;
  return total;
}

// Bound on the length of a leaf in the sum norm.
double length_of_leaf(const BoxTree& tree, std::size_t leaf) {
  const TreeNode node{0, static_cast<std::uint32_t>(leaf)};
  const unsigned flags = tree.flags(node);
  const bool monotone = (flags & (rises_in_x | falls_in_x)) != 0 && (flags & (rises_in_y | falls_in_y)) != 0;
  return tree.box(node).extent() * (monotone ? 1 : leaf_size);
}

}  // namespace

SideSums sum_by_arcs(const BoxTree& tree, Point origin, double extent, const ContactsAlong& contacts,
                     const Buffer<Side>& after, Side whole) {
  const std::size_t leaves = tree.leaves(), count = contacts.size();
  std::vector<SideSums> blocks((leaves + leaves_per_block - 1) / leaves_per_block);
  std::vector<double> lengths(blocks.size());
  for_each_block(leaves, leaves_per_block, [&](std::size_t first, std::size_t last) {
    Collector collector;
    double length = 0;
    LeafPrefixes prefixes;
    std::size_t next = contacts.first_from(first * leaf_size);
    Side side = count == 0 ? whole : after[next == 0 ? count - 1 : next - 1];
    for (std::size_t leaf = first; leaf < last; ++leaf) {
      length += length_of_leaf(tree, leaf);
      if (next == count || contacts.segment(next) >= (leaf + 1) * leaf_size) {
        collector.add_leaf(side, shoelace_of_leaf(tree.leaf_points(leaf), origin));
        continue;
      }
      shoelace_prefixes(tree.leaf_points(leaf), origin, {}, nullptr, prefixes);
      for (std::size_t i = 0; i < leaf_size; ++i) {
        const std::size_t segment = leaf * leaf_size + i;
        const DD term = prefixes.term(i);
        DD from;
        for (; next < count && contacts.segment(next) == segment; ++next) {
          const DD to = contacts[next].t;
          collector.add(side, (to - from) * term);
          side = after[next];
          from = to;
        }
        collector.add(side, from.hi == 0 ? term : (DD{1, 0} - from) * term);
      }
    }
    blocks[first / leaves_per_block] = collector.result(length, extent);
    lengths[first / leaves_per_block] = length;
  });
  double length = 0;
  for (const double part : lengths) length += part;
  return joined(blocks, length, extent);
}

SideSums sum_by_ends(std::span<const Point> points, std::span<const Side> labels, Point origin, double extent) {
  const std::size_t size = points.size();
  std::vector<SideSums> blocks((size + points_a_block - 1) / points_a_block);
  std::vector<double> lengths(blocks.size());
  for_each_block(size, points_a_block, [&](std::size_t begin, std::size_t end) {
    Collector collector;
    double length = 0;
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t next = k + 1 == size ? 0 : k + 1;
      const DD term = shoelace(points[k], points[next], origin);
      const DD half{0.5 * term.hi, 0.5 * term.lo};
      collector.add(labels[k], half);
      collector.add(labels[next], half);
      length += std::fabs(points[next].x - points[k].x) + std::fabs(points[next].y - points[k].y);
    }
    blocks[begin / points_a_block] = collector.result(length, extent);
    lengths[begin / points_a_block] = length;
  });
  double length = 0;
  for (const double part : lengths) length += part;
  return joined(blocks, length, extent);
}

}  // namespace lober::detail

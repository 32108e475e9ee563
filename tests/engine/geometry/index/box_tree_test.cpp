// The box tree against what it says of itself, node by node.
#include "engine/geometry/index/box_tree.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>
#include <memory>
#include <string>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/box.hpp"
#include "tests/engine/geometry/index/scenes.hpp"
#include "tests/engine/geometry/index/search_testing.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

constexpr std::size_t tree_sizes[] = {3, 31, 32, 33, 64, 65, 1000, 1024, 1025, 32768, 33000, 70001};

Curve random_walk(Random& random, std::size_t size, bool closed) {
  Curve curve = scene::walks(random, size).first;
  for (std::size_t k = 0; k < size / 2; ++k) curve.points[k] = {static_cast<double>(k), 0.5 * static_cast<double>(k)};
  curve.closed = closed;
  return curve;
}

struct ExpectedNode {
  Box box;
  unsigned flags = 15;
};

// The node of segments [begin, end), which may reach beyond the curve.
ExpectedNode brute_force(const CurveView& curve, std::size_t begin, std::size_t end) {
  ExpectedNode expected;
  if (end > curve.segments()) expected.flags = 0;  // filled up with segments of no length
  for (std::size_t k = begin; k < std::min(end, curve.segments()); ++k) {
    const auto [a, b] = ends_of(curve, k);
    expected.box = union_of(expected.box, Box::of(a, b));
    if (!(b.x > a.x)) expected.flags &= ~static_cast<unsigned>(rises_in_x);
    if (!(b.y > a.y)) expected.flags &= ~static_cast<unsigned>(rises_in_y);
    if (!(b.x < a.x)) expected.flags &= ~static_cast<unsigned>(falls_in_x);
    if (!(b.y < a.y)) expected.flags &= ~static_cast<unsigned>(falls_in_y);
  }
  return expected;
}

// Shoelace sum of segments [begin, end) about the first point, in integers of the walk's exact rationals.
mpq_class exact_sum(const CurveView& curve, std::size_t begin, std::size_t end) {
  const Point o = ends_of(curve, begin).a;
  mpq_class total(0), x1(0), y1(0);
  for (std::size_t k = begin; k < std::min(end, curve.segments()); ++k) {
    const Point b = ends_of(curve, k).b;
    const mpq_class x2 = mpq_class(b.x) - mpq_class(o.x), y2 = mpq_class(b.y) - mpq_class(o.y);
    total += x1 * y2 - x2 * y1;
    x1 = x2;
    y1 = y2;
  }
  return total;
}

TEST(BoxTree, BoxesAndFlagsAreThoseOfTheirSegments) {
  Random random(seed());
  for (const std::size_t size : tree_sizes) {
    for (const bool closed : {true, false}) {
      SCOPED_TRACE(::testing::Message() << size << (closed ? " closed" : " open"));
      const Curve curve = random_walk(random, size, closed);
      const BoxTree tree(curve);
      ASSERT_EQ(tree.segments(), closed ? size : size - 1);
      ASSERT_EQ(tree.leaves(), (tree.segments() + leaf_size - 1) / leaf_size);
      ASSERT_EQ(tree.nodes(tree.levels() - 1), 1U);
      for (std::uint32_t level = 0; level < tree.levels(); ++level) {
        ASSERT_EQ(tree.nodes(level), (tree.leaves() + (std::size_t{1} << level) - 1) >> level);
        for (std::uint32_t index = 0; index < tree.nodes(level); ++index) {
          const std::size_t begin = std::size_t{index} * leaf_size << level;
          const ExpectedNode expected = brute_force(curve, begin, begin + (leaf_size << level));
          const Box& box = tree.box({level, index});
          for (std::size_t lane = 0; lane < 4; ++lane) ASSERT_EQ(box.lane[lane], expected.box.lane[lane]);
          const unsigned flags = tree.flags({level, index});
          // A node whose last leaves are not there is judged by those that are.
          const bool complete = begin + (leaf_size << level) <= tree.leaves() * leaf_size;
          if (complete) {
            ASSERT_EQ(flags, expected.flags) << level << ' ' << index;
          } else {
            ASSERT_EQ(flags & ~brute_force(curve, begin, tree.segments()).flags, 0U) << level << ' ' << index;
          }
        }
      }
      EXPECT_GT(tree.memory(), tree.leaves() * (sizeof(Box) + sizeof(DD)));
    }
  }
}

TEST(BoxTree, PadsTheLastLeafWithItsLastPoint) {
  Random random(seed());
  for (const std::size_t size : tree_sizes) {
    for (const bool closed : {true, false}) {
      const Curve curve = random_walk(random, size, closed);
      const BoxTree tree(curve);
      for (std::size_t leaf = 0; leaf < tree.leaves(); ++leaf) {
        for (std::size_t k = 0; k <= leaf_size; ++k) {
          const std::size_t vertex = std::min(leaf * leaf_size + k, tree.segments());
          ASSERT_EQ(tree.leaf_points(leaf)[k], curve.points[vertex == size ? 0 : vertex]);
        }
        ASSERT_EQ(tree.leaf_begin(leaf), curve.points[leaf * leaf_size]);
      }
      ASSERT_EQ(tree.leaf_begin(tree.leaves()), closed ? curve.points.front() : curve.points.back());
    }
  }
}

TEST(BoxTree, SumsAreExactToTheirBounds) {
  Random random(seed());
  for (const std::size_t size : {3U, 33U, 1024U, 1025U, 33000U}) {
    const Curve curve = random_walk(random, size, true);
    const BoxTree tree(curve);
    const auto expect_sum = [&](DD sum, std::size_t begin, std::size_t end, int bound) {
      const Box box = brute_force(curve, begin, end).box;
      const mpq_class diameter = mpq_class(box.width()) + mpq_class(box.height());
      const mpq_class value = mpq_class(sum.hi) + mpq_class(sum.lo);
      EXPECT_TRUE(within(value, exact_sum(curve, begin, end), bound, diameter * diameter)) << size << ' ' << begin;
    };
    for (std::size_t leaf = 0; leaf < tree.leaves(); ++leaf) {
      expect_sum(tree.leaf_sums()[leaf], leaf * leaf_size, (leaf + 1) * leaf_size, -96);
    }
    constexpr std::size_t chunk = leaf_size * leaf_size;
    ASSERT_EQ(tree.chunk_sums().size(), (size + chunk - 1) / chunk);
    for (std::size_t k = 0; k < tree.chunk_sums().size(); ++k) {
      expect_sum(tree.chunk_sums()[k], k * chunk, (k + 1) * chunk, -94);
    }
  }
}

TEST(BoxTree, IsTheSameForAnyNumberOfThreads) {
  const tbb::global_control at_most(tbb::global_control::max_allowed_parallelism, 7);
  Random random(seed());
  const Curve curve = random_walk(random, 70001, true);
  const auto made_by = [&](int threads) {
    return with_threads(threads, [&] { return std::make_unique<const BoxTree>(curve); });
  };
  const auto one = made_by(1);
  const BoxTree& expected = *one;
  for (const int threads : {2, 7}) {
    const auto made = made_by(threads);
    const BoxTree& tree = *made;
    EXPECT_EQ(std::memcmp(tree.leaf_boxes(), expected.leaf_boxes(), tree.leaves() * sizeof(Box)), 0);
    EXPECT_EQ(std::memcmp(tree.leaf_sums(), expected.leaf_sums(), tree.leaves() * sizeof(DD)), 0);
    EXPECT_EQ(
        std::memcmp(tree.chunk_sums().data(), expected.chunk_sums().data(), tree.chunk_sums().size() * sizeof(DD)), 0);
  }
}

TEST(BoxTree, RefusesCurvesWithoutSegments) {
  EXPECT_THROW(BoxTree(CurveView{}), DataError);
  const Curve point{{{1, 1}}, false, ""};
  EXPECT_THROW(BoxTree{CurveView(point)}, DataError);
}

}  // namespace
}  // namespace lober::test

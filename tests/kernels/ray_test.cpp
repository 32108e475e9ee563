// A ray through a tree and past a leaf: all compiled copies against the definition.
#include "kernels/ray.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "kernels/cpu.hpp"
#include "kernels/kernel_table.hpp"
#include "tests/kernels/random_doubles.hpp"

namespace lober::test {
using namespace detail;
namespace {

// +1 for a way from below to above, -1 for the way back; a vertex at the height counts as below.
int rise(Point a, Point b, double height) {
  return static_cast<int>(b.y > height) - static_cast<int>(a.y > height);
}

// Coordinates on a grid, so that equal ones are frequent, or any.
Point some_point(Random& random, bool grid) {
  if (grid) return {static_cast<double>(random.integer(0, 6)), static_cast<double>(random.integer(0, 6))};
  return {random.uniform(0, 6), random.uniform(0, 6)};
}

void check_leaf(const KernelTable& kernels) {
  Random random(seed());
  for (int attempt = 0; attempt < 2000; ++attempt) {
    const bool grid = random.chance(0.7);
    std::array<Point, leaf_size + 1> points;
    for (Point& point : points) point = some_point(random, grid);
    const Point at = random.chance(0.2) ? points[leaf_size] : some_point(random, grid);
    HeightCrossings expected;
    for (std::size_t k = 0; k < leaf_size; ++k) {
      const Point a = points[k], b = points[k + 1];
      const std::uint64_t bit = std::uint64_t{2} << 2 * k;
      const int direction = rise(a, b, at.y);
      if (direction == 0 && (a.y == at.y || b.y == at.y)) expected.level |= bit;
      if (direction == 0 || (a.x < at.x && b.x < at.x)) continue;
      if (a.x > at.x && b.x > at.x) {
        expected.number += direction;
      } else {
        (direction > 0 ? expected.up : expected.down) |= bit;
      }
    }
    const HeightCrossings found = kernels.crossings_of_height(points.data(), at);
    ASSERT_EQ(found.number, expected.number) << "try " << attempt;
    ASSERT_EQ(found.up, expected.up) << "try " << attempt;
    ASSERT_EQ(found.down, expected.down) << "try " << attempt;
    ASSERT_EQ(found.level, expected.level) << "try " << attempt;
  }
}

// A tree over boxes that hold the ends of their leaves and some more.
struct Tree {
  Tree(Random& random, bool grid) {
    const auto leaves =
        static_cast<std::uint32_t>(random.chance(0.2) ? random.integer(200, 900) : random.integer(1, 60));
    for (std::uint32_t k = 0; k <= leaves; ++k) begins.push_back(some_point(random, grid));
    for (std::uint32_t k = 0; k < leaves; ++k) {
      const Point beyond = some_point(random, grid);
      boxes.push_back(union_of(Box::of(begins[k], begins[k + 1]), Box::of(beyond, beyond)));
    }
    begin.push_back(0);
    size.push_back(leaves);
    while (size.back() > 1) {
      const std::uint32_t from = begin.back(), count = size.back();
      begin.push_back(static_cast<std::uint32_t>(boxes.size()));
      size.push_back((count + 1) / 2);
      for (std::uint32_t k = 0; k < count; k += 2) {
        boxes.push_back(k + 1 < count ? union_of(boxes[from + k], boxes[from + k + 1]) : boxes[from + k]);
      }
    }
    boxes.resize(boxes.size() + nodes_at_once - 1);
  }
  [[nodiscard]] RayTree view() const { return {{boxes.data(), begin.data(), size.data()}, begins.data(), size[0]}; }

  std::vector<Box> boxes;
  std::vector<std::uint32_t> begin, size;
  std::vector<Point> begins;
};

// From some nodes down to the leaves; lists that are too long in parts.
void follow(const KernelTable& kernels, const RayTree& tree, Point at, std::uint32_t level,
            std::vector<std::uint32_t> nodes, std::vector<std::uint32_t>& leaves, int& number) {
  for (std::size_t from = 0; from < nodes.size(); from += ray_nodes) {
    std::vector<std::uint32_t> list(ray_room);
    const std::size_t count = std::min(ray_nodes, nodes.size() - from);
    std::copy_n(nodes.begin() + static_cast<std::ptrdiff_t>(from), count, list.begin());
    const RayProgress reached = kernels.follow_ray(at, tree, level, list.data(), count);
    number += reached.number;
    list.resize(reached.count);
    if (reached.level > 0) {
      ASSERT_TRUE(reached.count == 0 || reached.count > ray_nodes);
      follow(kernels, tree, at, reached.level, list, leaves, number);
    } else {
      leaves.insert(leaves.end(), list.begin(), list.end());
    }
  }
}

void check_tree(const KernelTable& kernels) {
  Random random(seed());
  std::size_t in_parts = 0;
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const bool grid = random.chance(0.7);
    const Tree tree(random, grid);
    const Point at = random.chance(0.2) ? tree.begins[0] : some_point(random, grid);
    std::vector<std::uint32_t> expected, leaves;
    int expected_number = 0, number = 0;
    for (std::uint32_t k = 0; k < tree.size[0]; ++k) {
      const Box& box = tree.boxes[k];
      if (box.min_x() > at.x) expected_number += rise(tree.begins[k], tree.begins[k + 1], at.y);
      const bool met = box.min_y() <= at.y && box.max_y() >= at.y && box.max_x() >= at.x;
      if (met && box.min_x() <= at.x) expected.push_back(k);
    }
    const auto root = static_cast<std::uint32_t>(tree.size.size() - 1);
    follow(kernels, tree.view(), at, root, {0}, leaves, number);
    // The root itself is not tested; where it is the only node, it is left.
    if (root == 0) expected = {0}, expected_number = 0;
    ASSERT_EQ(number, expected_number) << "try " << attempt;
    ASSERT_EQ(leaves, expected) << "try " << attempt;
    in_parts += static_cast<std::size_t>(leaves.size() > ray_room);
  }
  EXPECT_GT(in_parts, 10U);
}

TEST(Ray, PassesALeaf) {
  check_leaf(baseline_kernels);
}
TEST(Ray, GoesDownATree) {
  check_tree(baseline_kernels);
}
TEST(Ray, TheOtherCopiesToo) {
  if (!has_avx2()) GTEST_SKIP() << "this processor has no AVX2 and FMA: only one copy can run";
  check_leaf(avx2_kernels);
  check_tree(avx2_kernels);
  if (!has_avx512()) GTEST_SKIP() << "this processor has no AVX-512: two of three copies ran";
  check_leaf(avx512_kernels);
  check_tree(avx512_kernels);
}

}  // namespace
}  // namespace lober::test

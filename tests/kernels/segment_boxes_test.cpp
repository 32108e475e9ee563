// Which segments of two leaves have boxes that meet: against exact brute force, and both compiled copies.
#include "kernels/segment_boxes.hpp"
#include "kernels/kernel_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

#include "kernels/box.hpp"
#include "kernels/cpu.hpp"
#include "kernels/predicates.hpp"
#include "kernels/simd.hpp"
#include "tests/kernels/random_doubles.hpp"
#include "tests/kernels/vector_copies.hpp"
#include "tests/shapes.hpp"

namespace lober::test {
namespace {

Points random_leaf_points(Random& random) {
  Points points(leaf_size + 1);
  const bool coarse = random.chance(0.5);  // touching boxes, points and repeated vertices
  const double size = random.log_uniform(0.01, 1), x = random.unit(), y = random.unit();
  for (Point& point : points) {
    point = coarse ? Point{static_cast<double>(random.integer(0, 9)), static_cast<double>(random.integer(0, 9))}
                   : Point{x + size * random.unit(), y + size * random.unit()};
  }
  return points;
}

// Two segments whose boxes meet have a common point iff neither lies on one side of the other.
bool segments_meet(Point a, Point b, Point c, Point d) {
  PredicateCounts counts;
  return orient2d(a, b, c, counts) * orient2d(a, b, d, counts) <= 0 &&
         orient2d(c, d, a, counts) * orient2d(c, d, b, counts) <= 0;
}

TEST(MeetingSegments, HoldAllThatHaveACommonPointInOrder) {
  Random random(seed());
  std::size_t met = 0, missing = 0;
  for (int k = 0; k < 3000; ++k) {
    const Points a = random_leaf_points(random), b = random_leaf_points(random);
    SegmentBoxes boxes;
    segment_boxes(a.data(), boxes);
    std::vector<SegmentPair> pairs(leaf_size * leaf_size);
    pairs.resize(meeting_segments(boxes, 100, b.data(), box_of(b), 7000, pairs.data()));
    std::size_t next = 0;
    for (std::uint32_t j = 0; j < leaf_size; ++j) {
      for (std::uint32_t i = 0; i < leaf_size; ++i) {
        const bool found = next < pairs.size() && pairs[next] == SegmentPair{100 + i, 7000 + j};
        next += found;
        const bool near = meet(Box::of(a[i], a[i + 1]), Box::of(b[j], b[j + 1]));
        const bool has_length = !(b[j] == b[j + 1]);
        ASSERT_FALSE(found && !(near && has_length)) << "try " << k;
        ASSERT_FALSE(!found && near && has_length && segments_meet(a[i], a[i + 1], b[j], b[j + 1])) << "try " << k;
        missing += near && !found;
      }
    }
    ASSERT_EQ(next, pairs.size()) << "in order, try " << k;
    met += pairs.size();
  }
  EXPECT_GT(met, 10000U);
  EXPECT_GT(missing, 100U) << "the slabs exclude something";
}

// A thin slanted leaf, as those of folded curves are, and points on and just off its ends and middle.
Points thin_leaf(Random& random, double size, double thickness) {
  const double angle = random.uniform(0, 7), offset = random.uniform(-1, 1) * thickness * size;
  const Point along{std::cos(angle), std::sin(angle)};
  Points points(leaf_size + 1);
  for (std::size_t k = 0; k <= leaf_size; ++k) {
    const double s = size * (static_cast<double>(k) / leaf_size - 0.5), h = offset + random.unit() * thickness * size;
    points[k] = {s * along.x - h * along.y, s * along.y + h * along.x};
  }
  return points;
}

TEST(MeetingSegments, SlabsOfThinLeavesLoseNothing) {
  Random random(seed());
  std::size_t common = 0;
  for (int k = 0; k < 3000; ++k) {
    const double size = random.chance(0.2) ? with_exponent(random, -500, 500) : 1;
    const double thickness = random.log_uniform(1e-17, 1e-2);
    Points a = thin_leaf(random, size, thickness), b = thin_leaf(random, size, thickness);
    if (random.chance(0.5)) b = a;  // side by side up to rounding
    for (Point& point : b) {
      if (random.chance(0.5)) point = neighbour(random, point, 2);
    }
    SegmentBoxes boxes;
    segment_boxes(a.data(), boxes);
    std::vector<SegmentPair> pairs(leaf_size * leaf_size);
    pairs.resize(meeting_segments(boxes, 0, b.data(), box_of(b), 0, pairs.data()));
    for (std::uint32_t j = 0; j < leaf_size; ++j) {
      for (std::uint32_t i = 0; i < leaf_size; ++i) {
        if (!meet(Box::of(a[i], a[i + 1]), Box::of(b[j], b[j + 1]))) continue;
        if (!segments_meet(a[i], a[i + 1], b[j], b[j + 1])) continue;
        ++common;
        ASSERT_NE(std::find(pairs.begin(), pairs.end(), SegmentPair{i, j}), pairs.end()) << "try " << k;
      }
    }
  }
  EXPECT_GT(common, 10000U);
}

TEST(MeetingSegments, AllCopiesGiveTheSame) {
  if (vector_copies().empty()) GTEST_SKIP() << "this processor has no AVX2 and FMA: only one copy can run";
  Random random(seed());
  for (int k = 0; k < 3000; ++k) {
    const Points a = random_leaf_points(random), b = random_leaf_points(random);
    SegmentBoxes plain, wide;
    baseline_kernels.segment_boxes(a.data(), plain);
    std::vector<SegmentPair> from_plain(leaf_size * leaf_size);
    from_plain.resize(
        baseline_kernels.meeting_segments(plain, 3, b.data(), box_of(b), 5, from_plain.data(), all_segments));
    for (const KernelTable* copy : vector_copies()) {
      copy->segment_boxes(a.data(), wide);
      ASSERT_EQ(std::memcmp(&plain, &wide, offsetof(SegmentBoxes, slab) + sizeof plain.slab), 0);  // padding differs
      std::vector<SegmentPair> from_wide(leaf_size * leaf_size);
      from_wide.resize(copy->meeting_segments(wide, 3, b.data(), box_of(b), 5, from_wide.data(), all_segments));
      ASSERT_EQ(from_plain, from_wide) << "try " << k;
    }
  }
}

TEST(Box, MeetsExactlyWhenClosedRectanglesDo) {
  const Box box = Box::of({0, 0}, {1, 1});
  EXPECT_TRUE(meet(BoxQuery(box), Box::of({1, 1}, {2, 2}))) << "a common corner";
  EXPECT_FALSE(meet(BoxQuery(box), Box::of({neighbour(1.0, 1), 0}, {2, 1}))) << "an ulp away";
  EXPECT_FALSE(meet(BoxQuery(box), Box::of({0, -2}, {1, neighbour(0.0, -1)}))) << "below";
  EXPECT_TRUE(meet(box, Box::of({1, 1}, {2, 2}))) << "a common corner";
  EXPECT_TRUE(meet(box, Box::of({-1, 0.5}, {2, 0.5}))) << "a segment through";
  EXPECT_FALSE(meet(box, Box::of({neighbour(1.0, 1), 0}, {2, 1}))) << "an ulp away";
  EXPECT_FALSE(meet(box, Box())) << "the empty box";
}

}  // namespace
}  // namespace lober::test

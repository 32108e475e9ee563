// Which segments of two leaves have boxes that meet: both compiled copies against brute force.
#include "kernels/segment_boxes.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "kernels/cpu.hpp"
#include "kernels/segment_boxes.inl"
#include "kernels/simd.hpp"
#include "tests/kernels/random_doubles.hpp"

namespace lober {
void segment_boxes_avx2(const Point* points, SegmentBoxes& boxes);
std::size_t meeting_segments_avx2(const SegmentBoxes& a, std::uint32_t a_begin, const Point* b, const Box& b_box,
                                  std::uint32_t b_begin, SegmentPair* pairs);
}  // namespace lober

namespace lober::testing {
namespace {

using Points = std::vector<Point>;

Points random_leaf(Random& random) {
  Points points(leaf_size + 1);
  const bool coarse = random.chance(0.5);  // touching boxes, points and repeated vertices
  const double size = random.log_uniform(0.01, 1), x = random.unit(), y = random.unit();
  for (Point& point : points) {
    point = coarse ? Point{static_cast<double>(random.integer(0, 9)), static_cast<double>(random.integer(0, 9))}
                   : Point{x + size * random.unit(), y + size * random.unit()};
  }
  return points;
}

Box box_of(const Points& points) {
  Box box;
  for (const Point& point : points) box = unite(box, Box::of(point, point));
  return box;
}

TEST(MeetingSegments, EqualsBruteForceInOrder) {
  Random random(seed());
  std::size_t met = 0;
  for (int k = 0; k < 3000; ++k) {
    const Points a = random_leaf(random), b = random_leaf(random);
    std::vector<SegmentPair> expected;
    for (std::uint32_t j = 0; j < leaf_size; ++j) {
      for (std::uint32_t i = 0; i < leaf_size; ++i) {
        if (meet(Box::of(a[i], a[i + 1]), Box::of(b[j], b[j + 1]))) expected.push_back({100 + i, 7000 + j});
      }
    }
    SegmentBoxes boxes;
    segment_boxes(a.data(), boxes);
    std::vector<SegmentPair> pairs(leaf_size * leaf_size);
    pairs.resize(meeting_segments(boxes, 100, b.data(), box_of(b), 7000, pairs.data()));
    ASSERT_EQ(pairs, expected) << "try " << k;
    met += pairs.size();
  }
  EXPECT_GT(met, 10000U);
}

TEST(MeetingSegments, BothCopiesGiveTheSame) {
  if (!has_avx2()) GTEST_SKIP() << "this processor has no AVX2 and FMA: only one copy can run";
  Random random(seed());
  for (int k = 0; k < 3000; ++k) {
    const Points a = random_leaf(random), b = random_leaf(random);
    SegmentBoxes plain, wide;
    boxes_of(a.data(), plain);
    group_boxes(plain);
    group_boxes(plain);
    segment_boxes_avx2(a.data(), wide);
    ASSERT_EQ(std::memcmp(&plain, &wide, sizeof plain), 0);
    std::vector<SegmentPair> from_plain(leaf_size * leaf_size), from_wide(leaf_size * leaf_size);
    from_plain.resize(find_meeting(plain, 3, b.data(), box_of(b), 5, from_plain.data()));
    from_wide.resize(meeting_segments_avx2(wide, 3, b.data(), box_of(b), 5, from_wide.data()));
    ASSERT_EQ(from_plain, from_wide) << "try " << k;
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
  EXPECT_TRUE(contains(box, {1, 0}));
  EXPECT_FALSE(contains(box, {1, neighbour(0.0, -1)}));
}

}  // namespace
}  // namespace lober::testing

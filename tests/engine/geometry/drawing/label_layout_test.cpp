// Places of labels: none overlaps another one, in the frame, off the lines where there is room.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lober/curve/drawing.hpp"

namespace lober {
namespace {

bool overlap(const Rectangle& a, const Rectangle& b) {
  return a.min_x < b.max_x && b.min_x < a.max_x && a.min_y < b.max_y && b.min_y < a.max_y;
}

TEST(LabelLayout, NeverPutsLabelsOnEachOther) {
  LabelLayout layout(600, 400);
  std::vector<Rectangle> placed;
  std::size_t asked = 0;
  for (int k = 0; k < 400; ++k) {
    // Crowded on purpose: dots on a spiral, then no room for all.
    const double t = 0.15 * k;
    const Point at{300 + 4 * t * std::cos(t), 200 + 3 * t * std::sin(t)};
    const auto box = k % 2 == 0 ? layout.put_beside(at, 4, 40, 16) : layout.put_about(at, 40, 16);
    ++asked;
    if (!box) continue;
    EXPECT_GE(box->min_x, 0);
    EXPECT_GE(box->min_y, 0);
    EXPECT_LE(box->max_x, 600);
    EXPECT_LE(box->max_y, 400);
    EXPECT_NEAR(box->width(), 40, 1e-9);
    for (const Rectangle& other : placed) EXPECT_FALSE(overlap(*box, other)) << k;
    placed.push_back(*box);
  }
  EXPECT_GT(placed.size(), 100U);
  EXPECT_LT(placed.size(), asked);
}

TEST(LabelLayout, KeepsClearOfLines) {
  LabelLayout layout(600, 400);
  // Lines to the right of the dot and above it: the best places are taken.
  for (double y = 120; y <= 200; y += 3) layout.add_line({300, y}, {420, y});
  const auto box = layout.put_beside({300, 200}, 4, 40, 16);
  ASSERT_TRUE(box);
  EXPECT_TRUE(box->max_x <= 303 || box->min_y >= 200) << box->min_x << " " << box->min_y;
  const LabelLayout empty(600, 400);
  LabelLayout free = empty;
  const auto first = free.put_beside({300, 200}, 4, 40, 16);
  ASSERT_TRUE(first);
  EXPECT_GT(first->min_x, 300);
  EXPECT_LT(first->max_y, 200);
}

TEST(LabelLayout, FindsTheRoomiestPlace) {
  LabelLayout layout(600, 400);
  const std::vector<Point> square{{100, 100}, {300, 100}, {300, 300}, {100, 300}};
  const auto all = layout.roomiest(square);
  ASSERT_TRUE(all);
  EXPECT_NEAR(all->at.x, 200, 6);
  EXPECT_NEAR(all->at.y, 200, 6);
  EXPECT_NEAR(all->distance, 100, 9);
  // A line parts it: the larger part has more room.
  layout.add_line({160, 50}, {160, 350});
  const auto part = layout.roomiest(square);
  ASSERT_TRUE(part);
  EXPECT_NEAR(part->at.x, 230, 6);
  // A label in the larger part leaves less.
  layout.block({170, 110, 290, 290});
  const auto rest = layout.roomiest(square);
  ASSERT_TRUE(rest);
  EXPECT_LT(rest->at.x, 160);
  EXPECT_FALSE(layout.roomiest(std::vector<Point>{{1000, 1000}, {1100, 1000}, {1100, 1100}}));
}

}  // namespace
}  // namespace lober

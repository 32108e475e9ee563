// Regions whose areas and pieces are known, and what must not change them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "lober/overlay/regions.hpp"
#include "tests/shapes.hpp"
#include "tests/views.hpp"

namespace lober::detail {
namespace {

using test::reversed;

using Polygon = std::vector<Point>;

struct Entry {
  int w1, w2;
  double area;
  friend bool operator==(const Entry&, const Entry&) = default;
};
std::ostream& operator<<(std::ostream& stream, const Entry& entry) {
  return stream << "(" << entry.w1 << ", " << entry.w2 << "): " << entry.area;
}

std::vector<Entry> table(const Regions& result) {
  std::vector<Entry> entries;
  for (const WindingArea& entry : result.table()) entries.push_back({entry.w1, entry.w2, entry.area});
  return entries;
}

Regions of(const Polygon& polygon) {
  return regions(CurveView{polygon});
}
Regions of(const Polygon& first, const Polygon& second) {
  return regions(CurveView{first}, CurveView{second});
}

const Polygon square_of_side_4{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

Polygon moved(Polygon polygon, double dx, double dy) {
  for (Point& p : polygon) p = {p.x + dx, p.y + dy};
  return polygon;
}

Polygon star_polygon(int corners, int step) {
  Polygon polygon;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k * step / corners;
    polygon.push_back({std::cos(angle), std::sin(angle)});
  }
  return polygon;
}

TEST(KnownRegions, FigureEightHasALobeOfEitherSign) {
  const Polygon eight{{-2, -1}, {2, 1}, {2, -1}, {-2, 1}};  // clockwise on the right, counter-clockwise on the left
  const Regions result = of(eight);
  EXPECT_EQ(table(result), (std::vector<Entry>{{-1, 0, 2}, {1, 0, 2}}));
  EXPECT_EQ(result.counts().nodes, 1U);
  EXPECT_EQ(result.counts().edges, 2U);
  EXPECT_EQ(result.counts().faces, 3U);
  EXPECT_EQ(result.counts().self1, 1U);
  EXPECT_EQ(result.signed_areas()[0], 0);
  EXPECT_EQ(result.areas(FillRule::nonzero).c1, 4);
  EXPECT_EQ(result.areas(FillRule::positive).c1, 2);
  EXPECT_EQ(result.areas(FillRule::negative).c1, 2);
  EXPECT_EQ(result.pieces(FillRule::nonzero, Pairing::c1_minus_c2).size(), 2U) << "they meet in a vertex only";
  EXPECT_EQ(result.pieces(FillRule::positive, Pairing::c1_minus_c2).size(), 1U);
}

TEST(KnownRegions, PentagramWindsTwiceAboutItsPentagon) {
  const Polygon pentagram = star_polygon(5, 2);
  const Regions result = of(pentagram);
  const double pentagon_radius = (3 - std::sqrt(5.0)) / 2;  // circumradius, 1 for the points of the star
  const double pentagon = 2.5 * pentagon_radius * pentagon_radius * std::sin(2 * std::numbers::pi / 5);
  const double signed_area = 2.5 * std::sin(4 * std::numbers::pi / 5);
  ASSERT_EQ(result.table().size(), 2U);
  EXPECT_EQ(result.table()[0].w1, 1);
  EXPECT_EQ(result.table()[1].w1, 2);
  EXPECT_NEAR(result.table()[0].area, signed_area - 2 * pentagon, 1e-15);
  EXPECT_NEAR(result.table()[1].area, pentagon, 1e-15);
  EXPECT_NEAR(result.signed_areas()[0], signed_area, 1e-15);
  EXPECT_EQ(result.counts().nodes, 5U);
  EXPECT_EQ(result.counts().faces, 7U);
  const RegionPieces whole = result.pieces(FillRule::nonzero, Pairing::union_);
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0].holes, 0U);
  ASSERT_EQ(whole.outline(0).size(), 1U);
  EXPECT_EQ(whole.outline(0)[0].size(), 10U);
  const RegionPieces points = result.pieces(FillRule::evenodd, Pairing::union_);
  EXPECT_EQ(points.size(), 5U);
}

TEST(KnownRegions, SquareWoundTwice) {
  Polygon twice = square_of_side_4;
  twice.insert(twice.end(), square_of_side_4.begin(), square_of_side_4.end());
  EXPECT_EQ(table(of(twice)), (std::vector<Entry>{{2, 0, 16}}));
  EXPECT_EQ(table(of(reversed(twice))), (std::vector<Entry>{{-2, 0, 16}}));
  EXPECT_EQ(of(twice).areas(FillRule::evenodd).c1, 0);
  EXPECT_EQ(of(twice).areas(FillRule::nonzero).c1, 16);
  EXPECT_EQ(of(twice).counts().edges, 4U) << "each side counts once";
  Polygon back = square_of_side_4;
  const Polygon other_way = reversed(square_of_side_4);
  back.insert(back.end(), other_way.begin(), other_way.end());
  EXPECT_EQ(table(of(back)), std::vector<Entry>{}) << "there and back: nothing";
}

TEST(KnownRegions, CircleWoundTwiceWithASmallerLoop) {
  Polygon spiral;  // a limacon: r = 1 + 2 cos t has an inner loop wound twice
  constexpr int points = 100000;
  for (int k = 0; k < points; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.5) / points, r = 1 + 2 * std::cos(angle);
    spiral.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  const Regions result = of(spiral);
  const double inner = std::numbers::pi - 1.5 * std::sqrt(3.0), all = 3 * std::numbers::pi;
  ASSERT_EQ(result.table().size(), 2U);
  EXPECT_NEAR(result.table()[0].area, all - 2 * inner, 1e-7);
  EXPECT_NEAR(result.table()[1].area, inner, 1e-7);
  EXPECT_EQ(result.table()[1].w1, 2);
  EXPECT_EQ(result.counts().nodes, 1U);
  const RegionPieces odd = result.pieces(FillRule::evenodd, Pairing::union_);
  ASSERT_EQ(odd.size(), 1U);
  EXPECT_EQ(odd[0].holes, 1U) << "the inner loop touches the outer one in the node only";
  EXPECT_EQ(odd.outline(0).size(), 2U);
}

TEST(KnownRegions, SpikesHaveNoArea) {
  const Polygon spiked{{0, 0}, {4, 0}, {4, 4}, {9, 9}, {4, 4}, {0, 4}, {-3, 4}, {0, 4}, {2, 2}, {0, 4}};
  EXPECT_EQ(table(of(spiked)), (std::vector<Entry>{{1, 0, 16}}));
  EXPECT_EQ(of(spiked).counts().nodes, 5U) << "three roots of spikes, of which two are one, and three ends";
  EXPECT_EQ(of(spiked).pieces(FillRule::nonzero, Pairing::union_).size(), 1U);
  EXPECT_EQ(table(of({{0, 0}, {4, 0}, {2, 0}})), std::vector<Entry>{}) << "all of it a spike";
}

TEST(KnownRegions, ASpikeJoinsNothing) {
  // Two squares joined by a way there and back.
  const Polygon dumbbell{{0, 0}, {1, 0}, {1, 1}, {3, 1}, {3, 0}, {4, 0}, {4, 1}, {3, 1}, {1, 1}, {0, 1}};
  const Regions result = of(dumbbell);
  EXPECT_EQ(table(result), (std::vector<Entry>{{1, 0, 2}}));
  EXPECT_EQ(result.pieces(FillRule::nonzero, Pairing::union_).size(), 2U);
  EXPECT_EQ(result.counts().faces, 3U);
}

TEST(KnownRegions, CurvesThatDoNotMeetAreFoundInsideEachOther) {
  const Polygon eight{{-2, -1}, {2, 1}, {2, -1}, {-2, 1}};
  const Polygon small{{-1.75, -0.25}, {-1.5, -0.25}, {-1.5, 0.25}, {-1.75, 0.25}};
  const Regions result = of(eight, small);
  EXPECT_EQ(table(result), (std::vector<Entry>{{-1, 0, 2}, {1, 0, 1.875}, {1, 1, 0.125}}));
  const RegionPieces rest = result.pieces(FillRule::nonzero, Pairing::c1_minus_c2);
  ASSERT_EQ(rest.size(), 2U);
  EXPECT_EQ(rest[0].holes + rest[1].holes, 1U);
  EXPECT_EQ(table(of(small, eight)), (std::vector<Entry>{{0, -1, 2}, {0, 1, 1.875}, {1, 1, 0.125}}));
  EXPECT_EQ(table(of(eight, moved(small, 9, 0))), (std::vector<Entry>{{-1, 0, 2}, {0, 1, 0.125}, {1, 0, 2}}));
  EXPECT_EQ(table(of(eight, moved(small, -9, 0))), (std::vector<Entry>{{-1, 0, 2}, {0, 1, 0.125}, {1, 0, 2}}));
}

TEST(KnownRegions, ARayThroughANodeFindsTheRightFace) {
  // Seen from the greatest vertex of the small square, the first thing to the right is where the eight crosses itself.
  const Polygon eight{{-2, -1}, {2, 1}, {2, -1}, {-2, 1}};
  const Polygon small{{-1, 0}, {-1.25, 0.25}, {-1.5, 0}, {-1.25, -0.25}};
  EXPECT_EQ(table(of(eight, small)), (std::vector<Entry>{{-1, 0, 2}, {1, 0, 1.875}, {1, 1, 0.125}}));
  EXPECT_EQ(table(of(reversed(eight), small)), (std::vector<Entry>{{-1, 0, 1.875}, {-1, 1, 0.125}, {1, 0, 2}}));
}

TEST(KnownRegions, HolesThatTouchAreCountedApart) {
  const Polygon inner{{0, 2}, {2, 1}, {4, 2}, {2, 3}};  // touches the square on the left and on the right
  const Regions result = of(square_of_side_4, inner);
  EXPECT_EQ(result.pieces(FillRule::nonzero, Pairing::c1_minus_c2).size(), 2U);
  const Polygon once{{0, 2}, {2, 1}, {3, 2}, {2, 3}};
  const RegionPieces ring = of(square_of_side_4, once).pieces(FillRule::nonzero, Pairing::c1_minus_c2);
  ASSERT_EQ(ring.size(), 1U);
  EXPECT_EQ(ring[0].holes, 1U);
  const Polygon two_holes{{1, 2}, {2, 1}, {2, 2}, {3, 2}, {3, 3}, {2, 2}};  // two triangles with a common vertex
  const RegionPieces pierced = of(square_of_side_4, two_holes).pieces(FillRule::nonzero, Pairing::c1_minus_c2);
  ASSERT_EQ(pierced.size(), 1U);
  EXPECT_EQ(pierced[0].holes, 2U);
}

TEST(KnownRegions, OrientationIsThatOfTheInput) {
  const Polygon shifted = moved(square_of_side_4, 2, 0);
  EXPECT_EQ(table(of(square_of_side_4, shifted)), (std::vector<Entry>{{0, 1, 8}, {1, 0, 8}, {1, 1, 8}}));
  EXPECT_EQ(table(of(square_of_side_4, reversed(shifted))), (std::vector<Entry>{{0, -1, 8}, {1, -1, 8}, {1, 0, 8}}));
  EXPECT_EQ(of(square_of_side_4, reversed(shifted)).areas(FillRule::positive).c2, 0);
}

TEST(KnownRegions, TheSameCurveTwice) {
  EXPECT_EQ(table(of(square_of_side_4, square_of_side_4)), (std::vector<Entry>{{1, 1, 16}}));
  EXPECT_EQ(table(of(square_of_side_4, reversed(square_of_side_4))), (std::vector<Entry>{{1, -1, 16}}));
  EXPECT_EQ(of(square_of_side_4, square_of_side_4).pieces(FillRule::nonzero, Pairing::c1_minus_c2).size(), 0U);
}

TEST(KnownRegions, OneCurveCountsNothingOfTheOther) {
  const Regions result = of(square_of_side_4);
  EXPECT_EQ(result.counts().nodes, 0U);
  EXPECT_EQ(result.counts().edges, 1U);
  EXPECT_EQ(result.counts().faces, 2U);
  const Areas areas = result.areas(FillRule::nonzero);
  EXPECT_EQ(areas.c1, 16);
  EXPECT_EQ(areas.c1_minus_c2, 16);
  EXPECT_EQ(areas.c2, 0);
  EXPECT_EQ(result.pieces(FillRule::nonzero, Pairing::c1_minus_c2).outline(0).front().size(), 4U);
}

TEST(KnownRegions, EdgesCountOnceAround) {
  // C2 touches C1 in the vertex of C2 that is greatest, and nowhere else: one node, an edge round each curve.
  const Polygon inner{{0.5, 2}, {2, 1}, {4, 2}, {2, 3}};
  const RegionCounts counts = of(square_of_side_4, inner).counts();
  EXPECT_EQ(counts.nodes, 1U);
  EXPECT_EQ(counts.edges, 2U);
  EXPECT_EQ(counts.faces, 3U);
}

TEST(KnownRegions, BadCurvesAreRefused) {
  EXPECT_THROW(of({{0, 0}, {1, 1}, {0, 0}}), DataError);
  EXPECT_THROW(of(square_of_side_4, {{0, 0}, {1, 0}, {std::numeric_limits<double>::quiet_NaN(), 1}}), DataError);
  RegionOptions cancel;
  cancel.progress = [](double fraction) { return fraction < 0.6; };
  EXPECT_THROW((void)regions(CurveView{square_of_side_4}, cancel), Cancelled);
}

TEST(FillRules, SayWhatIsInside) {
  EXPECT_TRUE(inside(FillRule::nonzero, -2));
  EXPECT_FALSE(inside(FillRule::evenodd, -2));
  EXPECT_TRUE(inside(FillRule::evenodd, -3));
  EXPECT_FALSE(inside(FillRule::positive, -1));
  EXPECT_TRUE(inside(FillRule::negative, -1));
  for (const FillRule rule : all_fill_rules) EXPECT_FALSE(inside(rule, 0));
}

}  // namespace
}  // namespace lober::detail

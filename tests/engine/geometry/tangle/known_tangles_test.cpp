// Tangles drawn by hand, and unusual ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/base/parallel/parallel.hpp"
#include "lober/base/error.hpp"
#include "lober/tangle/tangle.hpp"
#include "tests/engine/geometry/tangle/tangle_scenes.hpp"
#include "tests/shapes.hpp"
#include "tests/views.hpp"

namespace lober::detail {
namespace {

using Polyline = std::vector<Point>;

// U zigzags from the left about the x axis, S runs along it from the right: pips at x = 1, 2, 3, 4, lobes of area 1/2.
const Polyline zigzag{{0.5, -1}, {1.5, 1}, {2.5, -1}, {3.5, 1}, {4.5, -1}};
const Polyline x_axis{{6, 0}, {-1, 0}};

std::vector<Point> pip_points(const Tangle& found) {
  std::vector<Point> points;
  for (const Pip& pip : found.pips) points.push_back(pip.at);
  return points;
}

TEST(KnownTangle, ZigzagOnALine) {
  const Tangle found = tangle(open(zigzag), open(x_axis));
  EXPECT_EQ(pip_points(found), (std::vector<Point>{{1, 0}, {2, 0}, {3, 0}, {4, 0}}));
  ASSERT_EQ(found.lobes.size(), 3U);
  EXPECT_EQ(found.lobes[0].area, -0.5);
  EXPECT_EQ(found.lobes[1].area, 0.5);
  EXPECT_EQ(found.lobes[2].area, -0.5);
  EXPECT_EQ(found.pips[0].rho, 1);
  EXPECT_EQ(found.pips[1].rho, -1);
  EXPECT_EQ(found.boundary->bip, 2U);
  EXPECT_TRUE(overlaps(found).empty());
  EXPECT_EQ(found.images.period, 2U);
  EXPECT_EQ(found.images.compared, 1U);
  EXPECT_EQ(found.images.area_change, 0);
  EXPECT_EQ(found.images.turnstile_sum, 0);
  EXPECT_EQ(found.images.turnstile_begin, 0U);
  EXPECT_EQ(found.images.turnstile_end, 2U);
  EXPECT_EQ(found.images.lobe_area12, 0.5);
  EXPECT_EQ(found.images.lobe_area21, 0.5);
  for (const Lobe& lobe : found.lobes) EXPECT_TRUE(lobe.simple);
}

// Neighbours of a segment beside a repeated vertex lie farther away.
TEST(KnownTangle, RepeatedVerticesDoNotMatter) {
  Polyline wave, repeated;
  for (int k = 0; k <= 200; ++k) wave.push_back({0.5 + 0.02 * k, std::sin(0.02 * k * 3.1)});
  for (const Point p : wave) repeated.insert(repeated.end(), {p, p, p});
  const Tangle found = tangle(open(wave), open(x_axis)), same = tangle(open(repeated), open(x_axis));
  const std::vector<LobeShape> shapes = lobe_shapes(found), same_shapes = lobe_shapes(same);
  ASSERT_EQ(shapes.size(), same_shapes.size());
  ASSERT_GT(shapes.size(), 1U);
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    EXPECT_GT(shapes[k].discretisation, 0);
    EXPECT_NEAR(same_shapes[k].discretisation, shapes[k].discretisation, 1e-12 * shapes[k].discretisation);
    EXPECT_NEAR(same_shapes[k].perimeter, shapes[k].perimeter, 1e-12);
  }
  EXPECT_GT(boundary_discretisation(found), 0);
  EXPECT_NEAR(boundary_discretisation(same), boundary_discretisation(found), 1e-12 * boundary_discretisation(found));
}

// The path that closes the boundary decides what is inside: below the axis, above it, or where it winds.
TEST(KnownTangle, ClosedByAPath) {
  struct Case {
    Polyline closure;
    double area;  // of what U up to (3, 0), the axis and the path enclose
    std::vector<double> inside;
    int first_from;  // region of lobe 0
    bool crosses;
  };
  const std::vector<Case> cases{{{{6, -3}, {0.5, -3}}, 16.25, {0.5, 0, 0}, 1, false},
                                {{{6, 3}, {0, 3}, {0, -1}}, 18.75, {0, 0.5, 0.5}, 2, false},
                                {{{6, -3}, {2.25, 3}, {0.5, -3}}, 0, {}, 0, true}};
  for (const Case& one : cases) {
    for (const double scale : {1.0, 0x1p-600}) {
      const auto scaled_line = [&](Polyline line) {
        for (Point& p : line) p = {p.x * scale, p.y * scale};
        return line;
      };
      const Polyline u = scaled_line(zigzag), s = scaled_line(x_axis);
      TangleOptions options;
      options.closure = scaled_line(one.closure);
      options.bip = 2;
      const Tangle found = tangle(open(u), open(s), options);
      const std::vector<Point> outline = scaled_line(boundary_outline(found));
      EXPECT_EQ(found.boundary->crosses_itself, one.crosses);
      if (one.crosses) continue;
      EXPECT_EQ(found.boundary->area, one.area * scale * scale);
      EXPECT_EQ(std::fabs(swept_area(found, 2).area), one.area * scale * scale);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(found.lobes[k].inside, one.inside[k] * scale * scale) << k;
      EXPECT_EQ(found.images.labels[0].from, one.first_from);
    }
  }
  TangleOptions infinite;
  infinite.closure = {{1, INFINITY}};
  EXPECT_THROW((void)tangle(open(zigzag), open(x_axis), infinite), DataError);
}

TEST(KnownTangle, SameBitsOfIndexedCurves) {
  for (const double scale : {1.0, 1e-200}) {
    ManifoldPair pair = leaning_fingers(5, 40, 0.6);
    for (std::vector<Point>* const curve : {&pair.u, &pair.s}) {
      for (Point& p : *curve) p = {p.x * scale, p.y * scale};
    }
    const IndexedCurve u(open(pair.u)), s(open(pair.s));
    const Tangle once = tangle(open(pair.u), open(pair.s)), again = tangle(u, s);
    ASSERT_EQ(once.lobes.size(), again.lobes.size());
    for (std::size_t k = 0; k < once.lobes.size(); ++k) {
      EXPECT_EQ(once.lobes[k].area, again.lobes[k].area);
      EXPECT_EQ(once.lobes[k].inside, again.lobes[k].inside);
    }
    EXPECT_EQ(overlaps(once).size(), overlaps(again).size());
    EXPECT_THROW((void)tangle(IndexedCurve(CurveView{pair.u}), s), UsageError);
  }
}

TEST(KnownTangle, LabelsFollowTheBip) {
  const Tangle found = tangle(open(leaning_fingers(9, 40, 0).u), open(leaning_fingers(9, 40, 0).s), {.bip = 5});
  ASSERT_EQ(found.lobes.size(), 9U);
  const auto label = [&](std::size_t k) { return found.images.labels[k]; };
  EXPECT_EQ(label(3).n, 1);
  EXPECT_EQ(label(4).n, 1);
  EXPECT_EQ(label(5).n, 0);
  EXPECT_EQ(label(2).n, 2);
  EXPECT_EQ(label(0).n, 3);
  EXPECT_EQ(label(8).n, -1);
  EXPECT_EQ(text(label(3)), text({label(3).from, label(3).to, 1}));
  EXPECT_NE(label(3).from, label(4).from);
  EXPECT_EQ(label(3).from, label(5).from);
  // Fluid that leaves has been inside so far: the turnstile lobe that lies inside the boundary.
  for (const std::size_t k : {std::size_t{3}, std::size_t{4}}) {
    EXPECT_EQ(found.lobes[k].inside > 0, label(k).from == 1);
  }
}

TEST(KnownTangle, ShapeOfATriangle) {
  const Tangle found = tangle(open(zigzag), open(x_axis));
  const std::vector<LobeShape> shapes = lobe_shapes(found);
  EXPECT_DOUBLE_EQ(shapes[0].centroid.x, 1.5);
  EXPECT_DOUBLE_EQ(shapes[0].centroid.y, 1.0 / 3);
  EXPECT_DOUBLE_EQ(shapes[0].perimeter, 1 + 2 * std::hypot(0.5, 1));
  EXPECT_DOUBLE_EQ(shapes[0].width, 1 / shapes[0].perimeter);
  EXPECT_EQ(lobe_outline(found, 0), (Polyline{{1, 0}, {1.5, 1}, {2, 0}}));
  EXPECT_EQ(boundary_outline(found), (Polyline{{0.5, -1}, {1.5, 1}, {2.5, -1}, {3, 0}, {6, 0}}));
}

TEST(KnownTangle, SecondaryIntersectionsHaveAGeneration) {
  const ManifoldPair pair = leaning_fingers(7, 60, 2.5);
  const Tangle found = tangle(open(pair.u), open(pair.s));
  const std::vector<ArcsAt> arcs = arcs_at_nodes(found);
  std::size_t sips = 0;
  for (std::size_t k = 0; k < arcs.size(); ++k) {
    const bool pip = std::any_of(found.pips.begin(), found.pips.end(), [&](const Pip& p) { return p.node == k; });
    EXPECT_EQ(arcs[k].generation() == 0, pip);
    EXPECT_GE(arcs[k].generation(), 0);
    sips += !pip;
  }
  EXPECT_GT(sips, 10U);
}

TEST(KnownTangle, SwappedManifoldsHaveTheSamePipsTheOtherWayRound) {
  const ManifoldPair pair = leaning_fingers(7, 60, 2.5);
  const Tangle found = tangle(open(pair.u), open(pair.s)), swapped = tangle(open(pair.s), open(pair.u));
  std::vector<Point> other = pip_points(swapped);
  std::reverse(other.begin(), other.end());
  ASSERT_EQ(found.pips.size(), other.size());
  for (std::size_t k = 0; k < other.size(); ++k) {
    EXPECT_NEAR(other[k].x, found.pips[k].at.x, 1e-15 * 8);
    EXPECT_NEAR(other[k].y, found.pips[k].at.y, 1e-15);
  }
  for (std::size_t k = 0; k < found.lobes.size(); ++k) {
    EXPECT_NEAR(swapped.lobes[found.lobes.size() - 1 - k].area, found.lobes[k].area, 1e-15);
  }
}

TEST(KnownTangle, NoCrossing) {
  const Polyline far{{0, 5}, {1, 5}};
  const Tangle found = tangle(open(x_axis), open(far));
  EXPECT_TRUE(found.pips.empty());
  EXPECT_TRUE(found.lobes.empty());
  EXPECT_FALSE(found.boundary);
  ASSERT_EQ(found.remarks.size(), 1U);
  EXPECT_NE(found.remarks[0].find("do not cross"), std::string::npos);
  EXPECT_THROW((void)tangle(open(x_axis), open(far), {.bip = 0}), UsageError);
}

TEST(KnownTangle, OnePip) {
  const Polyline up{{2, -1}, {2, 1}};
  const Tangle found = tangle(open(up), open(x_axis));
  EXPECT_EQ(pip_points(found), (std::vector<Point>{{2, 0}}));
  EXPECT_TRUE(found.lobes.empty());
  EXPECT_EQ(found.boundary->area, 2);  // (2,-1) (2,0) (6,0)
  EXPECT_EQ(found.images.period, 0U);
  EXPECT_EQ(found.images.reason, "no lobe");
}

TEST(KnownTangle, TwoLobesDoNotTellThePeriod) {
  const Tangle found = tangle(open(Polyline(zigzag.begin(), zigzag.end() - 1)), open(x_axis));
  EXPECT_EQ(found.lobes.size(), 2U);
  EXPECT_EQ(found.images.period, 0U);
  EXPECT_FALSE(found.images.reason.empty());
  const Tangle given = tangle(open(Polyline(zigzag.begin(), zigzag.end() - 1)), open(x_axis), {.bip = 2, .period = 2});
  EXPECT_EQ(given.images.period, 2U);
  EXPECT_TRUE(given.images.given);
  EXPECT_EQ(given.images.compared, 0U);
  EXPECT_EQ(given.images.lobe_area12 + given.images.lobe_area21, 1);
}

TEST(KnownTangle, BothBeginAtTheSameFixedPoint) {
  // Homoclinic: a loop out of the origin and back, U upwards, S from below; they cross three times.
  const Polyline u{{0, 0}, {4, 1}, {5, -1}, {6, 1}, {7, -1}}, s{{0, 0}, {0, -3}, {9, -3}, {9, 0}, {1, 0}};
  const Tangle found = tangle(open(u), open(s));
  EXPECT_EQ(found.nodes.touches(), 1U);  // the fixed point itself
  EXPECT_EQ(pip_points(found), (std::vector<Point>{{4.5, 0}, {5.5, 0}, {6.5, 0}}));
  EXPECT_EQ(found.boundary->bip, 1U);
  EXPECT_FALSE(found.boundary->crosses_itself);
  EXPECT_EQ(found.boundary->area, signed_area({boundary_outline(found), true}) * found.boundary->orientation);
  for (const Lobe& lobe : found.lobes) EXPECT_EQ(lobe.inside + lobe.outside, 0.5);
  EXPECT_EQ(found.lobes[0].inside, 0);  // above U, below the axis
  EXPECT_EQ(found.lobes[1].inside, 0);
  EXPECT_EQ(tangle(open(u), open(s), {.bip = 2}).lobes[1].inside, 0.5);
}

TEST(KnownTangle, RepeatedFirstPointsChangeNothing) {
  Polyline u = zigzag, s = x_axis;
  u.insert(u.begin(), 3, u[0]);
  s.insert(s.begin(), 2, s[0]);
  const Tangle plain = tangle(open(zigzag), open(x_axis)), repeated = tangle(open(u), open(s));
  EXPECT_EQ(pip_points(plain), pip_points(repeated));
  for (std::size_t k = 0; k < plain.lobes.size(); ++k) {
    EXPECT_EQ(plain.lobes[k].area, repeated.lobes[k].area);
    EXPECT_EQ(plain.lobes[k].inside, repeated.lobes[k].inside);
  }
}

TEST(KnownTangle, RepeatedFixedPointIsNoCrossing) {
  const Polyline u{{0, 0}, {0, 0}, {4, 1}, {5, -1}, {6, 1}}, s{{0, 0}, {0, 0}, {0, -3}, {9, -3}, {9, 0}, {1, 0}};
  const Tangle found = tangle(open(u), open(s));
  EXPECT_EQ(pip_points(found), (std::vector<Point>{{4.5, 0}, {5.5, 0}}));
}

TEST(KnownTangle, PipsAtVertices) {
  // Every crossing is a vertex of U, of S, or of both.
  const Polyline u{{0.5, -1}, {1, 0}, {1.5, 1}, {2, 0}, {2.5, -1}, {3.5, 1}, {4, 0}, {4.5, -1}};
  const Polyline s{{6, 0}, {4, 0}, {3, 0}, {2, 0}, {-1, 0}};
  const Tangle found = tangle(open(u), open(s)), plain = tangle(open(zigzag), open(x_axis));
  EXPECT_EQ(pip_points(found), pip_points(plain));
  for (std::size_t k = 0; k < plain.lobes.size(); ++k) {
    EXPECT_EQ(found.lobes[k].area, plain.lobes[k].area);
    EXPECT_EQ(found.lobes[k].inside, plain.lobes[k].inside);
  }
}

TEST(KnownTangle, ATouchIsNoPipAndPinchesTheLobe) {
  // U comes down to the axis at x = 1.5 and goes up again before it crosses at 3.
  const Polyline u{{0, -1}, {1, 1}, {1.5, 0}, {2, 1}, {3, -1}};
  const Tangle found = tangle(open(u), open(x_axis));
  EXPECT_EQ(pip_points(found), (std::vector<Point>{{0.5, 0}, {2.5, 0}}));
  EXPECT_EQ(found.nodes.touches(), 1U);
  ASSERT_EQ(found.lobes.size(), 1U);
  EXPECT_EQ(found.lobes[0].area, -1);
  EXPECT_FALSE(found.lobes[0].simple);
  EXPECT_EQ(lobe_pieces(found, 0), (std::vector<double>{0.5, 0.5}));
}

TEST(KnownTangle, ASharedArcCountsOnce) {
  // U runs along the axis from 1 to 2 and leaves it on the other side (a pip), and from 3 to 4 and back up (a touch).
  const Polyline u{{0.5, 1}, {1, 0}, {2, 0}, {2.5, -1}, {3, 0}, {4, 0}, {4.5, -1}, {5, 0}, {5.5, 1}};
  const Tangle found = tangle(open(u), open(x_axis));
  EXPECT_EQ(found.nodes.shared_arcs(), 2U);
  ASSERT_EQ(found.pips.size(), 2U);
  EXPECT_EQ(found.pips[0].at, (Point{1, 0}));
  EXPECT_EQ(found.pips[1].at, (Point{5, 0}));
  EXPECT_EQ(found.lobes[0].area, -1 + 2);  // below the axis, two triangles of 1/2, on the left of U
  EXPECT_FALSE(found.lobes[0].simple);
  EXPECT_EQ(lobe_pieces(found, 0), (std::vector<double>{0.5, 0.5}));
}

TEST(KnownTangle, ManifoldsThatEndOnEachOtherDoNotCrossThere) {
  // U begins on S and ends along it.
  const Polyline u{{-0.5, 0}, {0.5, -1}, {1.5, 1}, {2.5, -1}, {3, 0}, {4, 0}};
  const Polyline s{{6, 0}, {5, 0}, {3.5, 0}, {-1, 0}};
  const Tangle found = tangle(open(u), open(s));
  EXPECT_EQ(pip_points(found), (std::vector<Point>{{1, 0}, {2, 0}}));
  // Both run along each other to the very end of U, vertex by vertex.
  const Polyline same{{6, 0}, {5, 0}, {4, 0}, {3, 0}, {-1, 0}};
  EXPECT_EQ(pip_points(tangle(open(u), open(same))), (std::vector<Point>{{1, 0}, {2, 0}}));
  EXPECT_EQ(pip_points(tangle(open(same), open(u))), (std::vector<Point>{{2, 0}, {1, 0}}));
}

TEST(KnownTangle, InwardManifoldIsRemarkedUpon) {
  const ManifoldPair pair = leaning_fingers(19, 30, 4.5);
  EXPECT_TRUE(tangle(open(pair.u), open(pair.s)).remarks.empty());
  const Tangle found = tangle(open(test::reversed(pair.u)), open(pair.s));
  ASSERT_FALSE(found.remarks.empty());
  EXPECT_NE(found.remarks[0].find("U given inward"), std::string::npos);
}

TEST(KnownTangle, BipByNumberAndPlace) {
  EXPECT_EQ(tangle(open(zigzag), open(x_axis), {.bip = 1}).boundary->bip, 1U);
  EXPECT_EQ(tangle(open(zigzag), open(x_axis), {.bip_near = Point{3.9, 0.3}}).boundary->bip, 3U);
  EXPECT_THROW((void)tangle(open(zigzag), open(x_axis), {.bip = 4}), UsageError);
  EXPECT_THROW((void)tangle(open(zigzag), open(x_axis), {.bip = 1, .bip_near = Point{}}), UsageError);
}

TEST(KnownTangle, ManifoldThatCrossesItselfIsRefused) {
  const Polyline loop{{0, -1}, {0, 2}, {1, 2}, {1, 1}, {-1, 1}};
  EXPECT_THROW((void)tangle(open(loop), open(x_axis)), NotSimpleError);
  EXPECT_NO_THROW((void)tangle(open(loop), open(x_axis), {.check_simple = false}));
}

TEST(KnownTangle, AManifoldMayEndWhereItBegan) {
  // A chain of equal first and last points is no excuse for the ends to cross: here they only meet.
  const Polyline ring{{0, 0}, {2, -1}, {2, 1}, {0, 0}};
  EXPECT_THROW((void)tangle(open(ring), open(x_axis)), NotSimpleError);
}

TEST(KnownTangle, SameBitsForAnyThreadsIndexAndScale) {
  const ManifoldPair pair = leaning_fingers(9, 3000, 3.3);
  const Tangle one = with_threads(1, [&] { return tangle(open(pair.u), open(pair.s)); });
  const std::vector<LobeOverlap> common = overlaps(one);
  const auto same = [&](const Tangle& other, int exponent) {
    ASSERT_EQ(pip_points(one).size(), pip_points(other).size());
    for (std::size_t k = 0; k < one.lobes.size(); ++k) {
      EXPECT_EQ(std::ldexp(one.lobes[k].area, exponent), other.lobes[k].area);
      EXPECT_EQ(std::ldexp(one.lobes[k].inside, exponent), other.lobes[k].inside);
    }
    const std::vector<LobeOverlap> list = overlaps(other);
    ASSERT_EQ(list.size(), common.size());
    for (std::size_t k = 0; k < list.size(); ++k) EXPECT_EQ(list[k].area, std::ldexp(common[k].area, exponent));
  };
  for (const int threads : {2, 7}) {
    same(with_threads(threads, [&] { return tangle(open(pair.u), open(pair.s)); }), 0);
  }
  for (const IndexKind index : {IndexKind::grid, IndexKind::kd})
    same(tangle(open(pair.u), open(pair.s), {.index = index}), 0);
  for (const int exponent : {-300, 300}) {
    ManifoldPair moved = pair;
    for (std::vector<Point>* curve : {&moved.u, &moved.s}) {
      for (Point& p : *curve) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
    }
    same(tangle(open(moved.u), open(moved.s)), 2 * exponent);
  }
}

}  // namespace
}  // namespace lober::detail

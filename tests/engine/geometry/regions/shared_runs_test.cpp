// Edge chains that keep together have no nodes inside of what they share, and all of them where something else happens.
#include "engine/geometry/regions/incidences.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/geometry/index/orientation.hpp"
#include "lober/overlay/regions.hpp"
#include "tests/shapes.hpp"
#include "tests/views.hpp"

namespace lober::detail {
namespace {

using Polygon = std::vector<Point>;

Incidences between(const Polygon& first, const Polygon& second) {
  const IndexedCurve c1(CurveView{first}), c2(CurveView{second});
  const auto begin2 = static_cast<std::uint32_t>(first.size());
  return find_incidences(c1, &c2, IndexKind::tree, {extreme_segment(c1.tree()), begin2 + extreme_segment(c2.tree())});
}

// The upper half of a circle in `segments` steps, from (1, 0) to (-1, 0).
Polygon arc(int segments) {
  Polygon points;
  for (int k = 0; k <= segments; ++k) {
    const double angle = std::numbers::pi * k / segments;
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  return points;
}

Polygon arc_and(Point last, int segments) {
  Polygon points = arc(segments);
  points.push_back(last);
  return points;
}

TEST(SharedRuns, OnlyTheirEndsAreNodes) {
  const Polygon first = arc_and({0, -1}, 1000), second = test::reversed(arc_and({0, -2}, 1000));
  const Incidences found = between(first, second);
  EXPECT_EQ(found.list.size(), 2U);  // the ends of the arc, of which one is the extreme vertex of both
  EXPECT_EQ(found.counts.mutual, 1001U);
  EXPECT_EQ(found.counts.along, 999U);
  const Regions result = regions(CurveView{first}, CurveView{second});
  EXPECT_EQ(result.counts().nodes, 1001U);
  EXPECT_EQ(result.counts().edges, 1002U);
  EXPECT_EQ(result.counts().faces, 3U);
  ASSERT_EQ(result.table().size(), 2U);
  EXPECT_EQ(result.table()[0].w1, 0);
  EXPECT_EQ(result.table()[0].w2, -1);
  EXPECT_NEAR(result.table()[0].area, 1, 1e-15);  // between triangles of heights 1 and 2 on a base of 2
}

TEST(SharedRuns, ExtremeVerticesStayNodesOfAllThatPasses) {
  // Three times round one square, twice by the first curve.
  const Polygon square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  Polygon twice = square;
  twice.insert(twice.end(), square.begin(), square.end());
  const Incidences found = between(twice, test::reversed(square));
  EXPECT_EQ(found.list.size(), 3U);  // of three edge chains through one vertex
  EXPECT_EQ(found.counts.along, 3U);
  const Regions result = regions(CurveView{twice}, CurveView{square});
  EXPECT_EQ(result.counts().nodes, 4U);
  EXPECT_EQ(result.counts().edges, 4U);
  ASSERT_EQ(result.table().size(), 1U);
  EXPECT_EQ(result.table()[0].w1, 2);
  EXPECT_EQ(result.table()[0].w2, 1);
  EXPECT_EQ(result.table()[0].area, 16);
}

TEST(SharedRuns, WhatPassesThroughAVertexOfTheRunMakesItANode) {
  // The run goes along y = 0 at x = 1 .. 5 and beyond; the first curve comes back through (3, 0).
  const Polygon first{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}, {6, 0}, {6, 3}, {3, 3}, {3, -3}, {0, -3}};
  const Polygon second{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}, {6, 0}, {7, 9}, {0, 9}};
  const Incidences found = between(first, second);
  // At (3, 0), inside of a segment of the first curve, with the two that keep together: an incidence with either.
  EXPECT_EQ(found.counts.self1, 1U);
  EXPECT_EQ(found.counts.along, 4U);
  const Regions result = regions(CurveView{first}, CurveView{second});
  EXPECT_EQ(result.areas(FillRule::nonzero).c1, 18);
  EXPECT_EQ(result.areas(FillRule::nonzero).intersection, 9);
}

TEST(SharedRuns, AreLeftWhereACurveMeetsItself) {
  // Both share an arc of 1000 steps; the second curve also leaves it for a spike and comes back through it, at vertices
  // or between them.
  const Polygon base = arc_and({0, -1}, 1000);
  for (const std::size_t at : {std::size_t{200}, std::size_t{500}}) {
    for (const bool through_vertex : {true, false}) {
      const Point a = base[at], b = base[at + 1];
      const Point target = through_vertex ? a : Point{(a.x + b.x) / 2, (a.y + b.y) / 2};
      Polygon other = base;  // from (0, -1) a loop that crosses the arc at `target`, or touches it there
      other.push_back({2 * target.x, 2 * target.y});
      other.push_back({2 * target.x + 1, 2 * target.y});
      other.push_back({3, -1});
      for (const Polygon& second : {other, test::reversed(other)}) {
        const Incidences found = between(base, second);
        const Incidences turned = between(second, base);
        EXPECT_EQ(found.counts.mutual, turned.counts.mutual);
        EXPECT_EQ(found.counts.along, turned.counts.along);
        EXPECT_EQ(found.list.size(), turned.list.size());
        EXPECT_EQ(found.counts.self2, 1U);
        EXPECT_LT(found.list.size(), 20U);
        const Regions forward = regions(CurveView{base}, CurveView{second});
        const Regions back = regions(CurveView{second}, CurveView{base});
        EXPECT_EQ(forward.counts().nodes, back.counts().nodes);
        EXPECT_EQ(forward.counts().edges, back.counts().edges);
        EXPECT_EQ(forward.counts().faces, back.counts().faces);
        EXPECT_NEAR(forward.areas(FillRule::nonzero).intersection, back.areas(FillRule::nonzero).intersection, 1e-15);
      }
    }
  }
}

TEST(SharedRuns, SpikesThatKeepTogetherEndInOneNode) {
  // Both curves run out to (9, 2) and back; the second comes back to a vertex of its own.
  const Polygon first{{0, 0}, {4, 0}, {4, 2}, {6, 2}, {9, 2}, {6, 2}, {4, 2}, {4, 4}, {0, 4}};
  const Polygon second{{0, 0}, {4, 0}, {4, 2}, {6, 2}, {9, 2}, {6, 2}, {4, 2}, {3, 4}, {0, 4}};
  for (const Polygon& other : {second, test::reversed(second), first, test::reversed(first)}) {
    const Regions result = regions(CurveView{first}, CurveView{other});
    EXPECT_EQ(result.areas(FillRule::nonzero).c1, 16);
    EXPECT_EQ(result.areas(FillRule::nonzero).c2, other == first || other == test::reversed(first) ? 16 : 15);
    EXPECT_EQ(result.areas(FillRule::nonzero).intersection, other == first || other == test::reversed(first) ? 16 : 15);
  }
}

}  // namespace
}  // namespace lober::detail

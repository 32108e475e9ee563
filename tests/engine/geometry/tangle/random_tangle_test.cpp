// Random tangles against definitions: pips by comparing all crossings, areas by overlaying polygons.
//
// LOBER_RANDOM_TANGLES  how many (default 400)
// LOBER_SEED            of the random numbers (default 20261121)
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lober/overlay/regions.hpp"
#include "lober/tangle/tangle.hpp"
#include "tests/engine/geometry/tangle/tangle_scenes.hpp"
#include "tests/environment.hpp"
#include "tests/views.hpp"

namespace lober::detail {
namespace {

struct ExactCrossing {
  mpq_class u, s;  // segment + parameter
  bool operator<(const ExactCrossing& other) const { return u < other.u; }
};

// Every crossing of two segments, in rationals.
std::vector<ExactCrossing> all_crossings(const ManifoldPair& pair) {
  std::vector<ExactCrossing> found;
  const auto cross = [](const mpq_class& ax, const mpq_class& ay, const mpq_class& bx, const mpq_class& by) {
    return mpq_class(ax * by - ay * bx);
  };
  for (std::size_t i = 0; i + 1 < pair.u.size(); ++i) {
    for (std::size_t j = 0; j + 1 < pair.s.size(); ++j) {
      const Point &a = pair.u[i], &b = pair.u[i + 1], &c = pair.s[j], &d = pair.s[j + 1];
      if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
          std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) {
        continue;
      }
      const mpq_class ux = mpq_class(b.x) - a.x, uy = mpq_class(b.y) - a.y;
      const mpq_class vx = mpq_class(d.x) - c.x, vy = mpq_class(d.y) - c.y;
      const mpq_class wx = mpq_class(c.x) - a.x, wy = mpq_class(c.y) - a.y;
      const mpq_class below = cross(ux, uy, vx, vy);
      if (below == 0) continue;
      const mpq_class t = cross(wx, wy, vx, vy) / below, r = cross(wx, wy, ux, uy) / below;
      if (t < 0 || t >= 1 || r < 0 || r >= 1) continue;
      found.push_back({mpq_class(static_cast<unsigned long>(i)) + t, mpq_class(static_cast<unsigned long>(j)) + r});
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

bool is_pip(const std::vector<ExactCrossing>& crossings, std::size_t q) {
  return std::none_of(crossings.begin(), crossings.end(), [&](const ExactCrossing& other) {
    return other.u > 0 && other.u < crossings[q].u && other.s < crossings[q].s;
  });
}

double area_of(const std::vector<Point>& polygon) {
  return regions(CurveView{polygon}).areas(FillRule::nonzero).c1;
}
double common_area(const std::vector<Point>& first, const std::vector<Point>& second) {
  return regions(CurveView{first}, CurveView{second}).areas(FillRule::nonzero).intersection;
}

struct Tally {
  std::size_t tangles = 0, refused = 0, pips = 0, sips = 0, overlaps = 0, holding = 0, chords = 0, cut = 0;
};

void check(const ManifoldPair& pair, Tally& tally) {
  Tangle found;
  try {
    found = tangle(open(pair.u), open(pair.s));
  } catch (const NotSimpleError&) {
    ++tally.refused;
    return;
  }
  ++tally.tangles;
  const std::vector<ExactCrossing> crossings = all_crossings(pair);
  const std::size_t start = found.nodes.touches();  // the common fixed point, if there is one, comes first
  ASSERT_EQ(found.nodes.crossings(), crossings.size() - start);
  ASSERT_EQ(found.nodes.size(), crossings.size());
  std::vector<std::uint32_t> pips;
  for (std::size_t q = start; q < crossings.size(); ++q) {
    if (is_pip(crossings, q)) pips.push_back(static_cast<std::uint32_t>(q));
  }
  ASSERT_EQ(found.pips.size(), pips.size());
  for (std::size_t k = 0; k < pips.size(); ++k) ASSERT_EQ(found.pips[k].node, pips[k]);
  tally.pips += pips.size();
  tally.sips += crossings.size() - pips.size();
  if (pips.empty()) return;

  // Polygons have rounded corners, so areas agree to rounding of the coordinates only.
  const double close = 1e-12;
  const std::vector<Point> boundary = boundary_outline(found);
  EXPECT_NEAR(found.boundary->area, area_of(boundary), close);
  tally.chords += found.boundary->crosses_itself;
  std::vector<std::vector<Point>> outlines;
  for (std::size_t k = 0; k < found.lobes.size(); ++k) {
    const Lobe& lobe = found.lobes[k];
    outlines.push_back(lobe_outline(found, k));
    EXPECT_NEAR(lobe.area, signed_area(CurveView{outlines[k]}), close);
    EXPECT_NEAR(std::fabs(lobe.area), area_of(outlines[k]), close) << "the loop is not simple";
    EXPECT_NEAR(lobe.inside, common_area(outlines[k], boundary), close);
    EXPECT_DOUBLE_EQ(lobe.inside + lobe.outside, std::fabs(lobe.area));
    tally.cut += lobe.inside > 0 && lobe.outside > 0;
    tally.holding += lobe.orientation() == found.pips[k].rho || lobe.orientation() == -found.pips[k + 1].rho;
  }
  std::vector<LobeOverlap> list = overlaps(found);
  tally.overlaps += list.size();
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < outlines.size(); ++i) {
    for (std::uint32_t j = i + 1; j < outlines.size(); ++j) {
      double area = 0;
      if (next < list.size() && list[next].i == i && list[next].j == j) area = list[next++].area;
      EXPECT_NEAR(area, common_area(outlines[i], outlines[j]), close) << i << " " << j;
    }
  }
  EXPECT_EQ(next, list.size());
}

TEST(RandomTangle, AgreesWithDefinitions) {
  oracle::Random random(from_environment("LOBER_SEED", 20261121));
  const std::uint64_t pairs = from_environment("LOBER_RANDOM_TANGLES", 400);
  Tally tally;
  for (std::uint64_t k = 0; k < pairs && !HasFailure(); ++k) {
    check(random_manifolds(random, 300, random.integer(3, 9)), tally);
  }
  std::printf(
      "%zu tangles (%zu crossed themselves), %zu pips, %zu sips, %zu overlaps, %zu lobes cut by the boundary, "
      "%zu that hold a fixed point, %zu boundaries whose chord meets a manifold\n",
      tally.tangles, tally.refused, tally.pips, tally.sips, tally.overlaps, tally.cut, tally.holding, tally.chords);
  // Every branch has to be met for this test to mean anything.
  EXPECT_GT(tally.tangles, pairs / 2);
  EXPECT_GT(tally.sips, pairs / 4);
  EXPECT_GT(tally.cut, tally.chords);
  EXPECT_GT(tally.overlaps, 0U);
  EXPECT_GT(tally.cut, 0U);
  EXPECT_GT(tally.holding, 0U);
  EXPECT_GT(tally.chords, 0U);
}

TEST(RandomTangle, LeaningFingersOverlapAsTheirPolygonsDo) {
  Tally tally;
  check(leaning_fingers(9, 40, 3.3), tally);
  EXPECT_EQ(tally.pips, 10U);
  EXPECT_GT(tally.overlaps, 5U);
}

}  // namespace
}  // namespace lober::detail

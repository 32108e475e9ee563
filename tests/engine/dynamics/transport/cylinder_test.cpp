// Overlaps with translates, against overlays of outlines.
#include "lober/tangle/tangle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "engine/dynamics/transport/turnstile/insides.hpp"
#include "kernels/box.hpp"
#include "lober/base/error.hpp"
#include "lober/overlay/regions.hpp"
#include "lober/tangle/manifold_tangle.hpp"
#include "lober/transport/transport.hpp"

namespace lober::detail {
namespace {

std::unique_ptr<ManifoldTangle> standard_tangle(double K, bool smooth) {
  const System system = make_system("standard", {{"K", K}});
  ManifoldTangleOptions options;
  options.lattice = system.lattice;
  options.smooth = smooth;
  options.before = 2;
  options.after = 2;
  options.tolerance = 1e-4;
  return grow_tangle(*system.map, *system.connection, options);
}

double common_area_of(const std::vector<Point>& first, std::vector<Point> second, Point translation) {
  for (Point& point : second) point = {point.x + translation.x, point.y + translation.y};
  if (!meet(box_of(first), box_of(second))) return 0;
  return regions(ClosedCurve::borrow(first), ClosedCurve::borrow(second)).areas(FillRule::nonzero).intersection;
}

// Lobes that reach into neighbouring cells, by polygons: the same to rounding as an overlay of every pair of them.
TEST(OverlapsWithCopy, AreThoseOfOutlines) {
  for (const double K : {2.0, 6.5}) {
    const auto found = standard_tangle(K, false);
    const Tangle& tangle = found->tangle;
    const Point lattice = make_system("standard", {}).lattice;
    std::size_t seen = 0;
    for (const int times : {1, 2, -1}) {
      const Point translation{times * lattice.x, 0};
      std::map<std::pair<std::uint32_t, std::uint32_t>, double> areas;
      for (const LobeOverlap& both : overlaps_with_copy(tangle, translation).overlaps)
        areas[{both.i, both.j}] = both.area;
      for (std::uint32_t i = 0; i < tangle.lobes.size(); ++i) {
        for (std::uint32_t j = 0; j < tangle.lobes.size(); ++j) {
          const double expected = common_area_of(lobe_outline(tangle, i), lobe_outline(tangle, j), translation);
          const auto at = areas.find({i, j});
          // Corners of outlines are rounded.
          EXPECT_NEAR(at == areas.end() ? 0 : at->second, expected, 1e-11) << K << ": " << i << ", " << j;
          seen += expected > 1e-6;
        }
      }
    }
    if (K > 5) {
      EXPECT_GT(seen, 10U);
    }
  }
}

TEST(OverlapsWithCopy, TheOtherWayRoundForTheOtherTranslation) {
  const auto found = standard_tangle(6.5, true);
  const Point lattice = make_system("standard", {}).lattice;
  std::map<std::pair<std::uint32_t, std::uint32_t>, LobeOverlap> there;
  for (const LobeOverlap& both : overlaps_with_copy(found->tangle, lattice).overlaps) there[{both.i, both.j}] = both;
  ASSERT_FALSE(there.empty());
  for (const LobeOverlap& both : overlaps_with_copy(found->tangle, {-lattice.x, 0}).overlaps) {
    const auto at = there.find({both.j, both.i});
    ASSERT_NE(at, there.end());
    EXPECT_NEAR(both.area, at->second.area, both.error + at->second.error);
    EXPECT_NEAR(both.perimeter, at->second.perimeter, 1e-9);
  }
}

// Takes every sixth point of manifolds that hardly stand apart from their translates: polygons cross where manifolds do
// not, which sums over crossings do not allow for. The common area of two lobes is not negative, and not more than one
// of them; bars say what is unknown, but for slivers between arcs as fine as the polygons.
TEST(OverlapsWithCopy, BarsCoverWherePolygonsCrossTranslates) {
  const System system = make_system("pendulum", {{"eps", 0.6}});
  ManifoldTangleOptions growth;
  growth.lattice = system.lattice;
  growth.before = growth.after = 2;
  const auto found = grow_tangle(*system.map, *system.connection, growth);
  const auto every_seventh = [](const Buffer<Point>& points) {
    std::vector<Point> some;
    for (std::size_t k = 0; k < points.size(); k += 7) some.push_back(points[k]);
    return some;
  };
  const std::vector<Point> u = every_seventh(found->u.points), s = every_seventh(found->s.points);
  TangleOptions options;
  options.check_simple = false;
  const Tangle tangle = lober::tangle(OpenCurve::borrow(u), OpenCurve::borrow(s), options);
  std::size_t unknown = 0;
  for (const LobeOverlap& both : overlaps_with_copy(tangle, system.lattice).overlaps) {
    const double expected = common_area_of(lobe_outline(tangle, both.i), lobe_outline(tangle, both.j), system.lattice);
    const double least = std::min(std::fabs(tangle.lobes[both.i].area), std::fabs(tangle.lobes[both.j].area));
    EXPECT_NEAR(both.area, expected, both.error + 1e-3) << both.i << ", " << both.j;
    EXPECT_LE(both.area, least);
    unknown += both.error > 1e-6 * least;
  }
  EXPECT_GT(unknown, 0U);
}

// Manifolds are grown until their polygons do not cross translates either: where they did, T by lobes was wrong.
TEST(TransportOnCylinder, ArcsThatLieNextToTranslatesAreToldApart) {
  TransportOptions options;
  options.iterates = 4;
  const Transport result = transport(make_system("pendulum", {{"eps", 0.6}}), options);
  ASSERT_EQ(result.steps.size(), 4U);
  const TransportStep& last = result.steps.back();
  for (const auto& [from, to] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 0}, {1, 2}, {2, 1}}) {
    const Measured lobes = last.total(from, to), boundaries = last.by_boundaries(from, to);
    EXPECT_NEAR(lobes.value, boundaries.value, lobes.error + boundaries.error) << from << ", " << to;
    EXPECT_LT(lobes.error, 1e-4);
  }
  EXPECT_TRUE(result.agreement.agrees());
}

// Folds that polygons show as corners have no estimate of what they leave out: T32 by boundaries was off by
// more than its bar.
TEST(TransportOnCylinder, FoldsAreNoCorners) {
  TransportOptions options;
  options.iterates = 5;
  options.tolerance = 1e-3;
  const Transport result = transport(make_system("pendulum", {{"eps", 0.377}, {"omega", 2.6}}), options);
  EXPECT_EQ(result.steps.size(), 5U);
  EXPECT_TRUE(result.agreement.agrees());
  for (const TransportBoundary& boundary : result.boundaries) {
    const Buffer<Point>& points = boundary.manifolds->u.points;
    std::size_t corners = 0;
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
      const Point in{points[k].x - points[k - 1].x, points[k].y - points[k - 1].y};
      const Point out{points[k + 1].x - points[k].x, points[k + 1].y - points[k].y};
      const double lengths = std::hypot(in.x, in.y) * std::hypot(out.x, out.y);
      corners += in.x * out.x + in.y * out.y < 0.7 * lengths && std::hypot(in.x, in.y) > options.tolerance;
    }
    EXPECT_EQ(corners, 0U);
  }
}

TEST(OverlapsWithCopy, AreRefusedWithoutATranslation) {
  const auto found = standard_tangle(2, false);
  EXPECT_THROW(static_cast<void>(overlaps_with_copy(found->tangle, {0, 0})), UsageError);
}

// Row after row, what boundaries have in common takes each loop once with the inside of each boundary, and has the bits
// of a row by itself.
TEST(CylinderInsides, RowsShareTheirLoops) {
  const System system = make_system("standard", {{"K", 1.2}});
  ASSERT_FALSE(system.further.empty());
  const auto grown = [&](const Connection& connection) {
    ManifoldTangleOptions options;
    options.lattice = system.lattice;
    options.smooth = true;
    options.before = options.after = 3;
    return grow_tangle(*system.map, connection, options);
  };
  const auto upper = grown(*system.connection), lower = grown(system.further.front());
  const std::array<Barrier, 2> barriers{barrier_of(*upper, system.lattice), barrier_of(*lower, system.lattice)};
  const std::array<const Barrier*, 2> pointers{&barriers[0], &barriers[1]};
  InsidesInCommon rows;
  for (int n = 1; n <= 6; ++n) {
    const int back = n / 2;
    std::vector<InsidesInCommon::Pair> pairs;
    for (const std::size_t c : {0U, 1U}) {
      for (const std::size_t d : {0U, 1U}) pairs.push_back({c, d, n - back, -back, {}});
    }
    const std::vector<Measured> found = rows.of(pointers, pairs), alone = InsidesInCommon{}.of(pointers, pairs);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      EXPECT_EQ(found[k].value, alone[k].value) << n << ": " << k;
      EXPECT_EQ(found[k].error, alone[k].error) << n << ": " << k;
    }
    // For either boundary the loops to f(q), ..., f^(n - back)(q) and to f^-1(q), ..., f^-back(q), with both insides.
    EXPECT_EQ(rows.loops_taken(), 4 * static_cast<std::size_t>(n)) << n;
  }
}

}  // namespace
}  // namespace lober::detail

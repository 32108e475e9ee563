// Tangles of smooth curves: areas known in closed form, and the order of the error.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lober/tangle/tangle.hpp"
#include "tests/engine/geometry/tangle/tangle_scenes.hpp"
#include "tests/views.hpp"

namespace lober::detail {
namespace {

// The sine wave over the axis, run from the right: between pips at whole x lobes of area 2 / pi. The parameter is
// uneven, so that crossings and vertices do not keep step.
ManifoldPair waves(std::size_t points) {
  ManifoldPair pair;
  for (std::size_t k = 0; k < points; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(points - 1);
    const double x = 0.4 + 4.2 * (t + 0.05 * std::sin(5 * t));
    pair.u.push_back({x, -std::sin(std::numbers::pi * x)});
    const double back = 5.1 - 5.3 * (t + 0.03 * std::sin(4 * t));
    pair.s.push_back({back, 0.25 * std::sin(2 * std::numbers::pi * back)});
  }
  return pair;
}
// Between pips k and k + 1 of that: the wave of half the length adds nothing.
double exact(std::size_t lobe) {
  return (lobe % 2 == 0 ? -2 : 2) / std::numbers::pi;
}

double largest_error(const Tangle& found, bool polygons) {
  double largest = 0;
  for (std::size_t k = 0; k < found.lobes.size(); ++k) {
    const double area = polygons ? found.lobes[k].polygon_area : found.lobes[k].area;
    largest = std::max(largest, std::fabs(area - exact(k)));
  }
  return largest;
}

TEST(SmoothTangle, ErrorsFallWithTheSixthPower) {
  double before = 0, polygons_before = 0;
  for (const std::size_t points : {100, 200, 400}) {
    const ManifoldPair pair = waves(points);
    const Tangle found = tangle(open(pair.u), open(pair.s), {.smooth = true});
    ASSERT_EQ(found.pips.size(), 4U);
    EXPECT_EQ(found.fallback_pips, 0U);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(found.pips[k].at.x, static_cast<double>(k + 1),
                  1e-4 * std::pow(100.0 / static_cast<double>(points), 5));
    }
    const double error = largest_error(found, false), polygon_error = largest_error(found, true);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_LE(std::fabs(found.lobes[k].area - exact(k)), found.lobes[k].smooth_error);
    }
    if (before > 0) {
      EXPECT_GT(before / error, 40);
      EXPECT_NEAR(polygons_before / polygon_error, 4, 0.5);
    }
    before = error;
    polygons_before = polygon_error;
  }
  EXPECT_LT(before, 2e-8);
}

TEST(SmoothTangle, EveryAreaIsOfTheSameCurves) {
  const ManifoldPair pair = leaning_fingers(7, 500, 2.5);
  const Tangle found = tangle(open(pair.u), open(pair.s), {.smooth = true});
  const Tangle fine = [] {
    static const ManifoldPair finer = leaning_fingers(7, 50000, 2.5);
    return tangle(open(finer.u), open(finer.s));
  }();
  ASSERT_EQ(found.lobes.size(), fine.lobes.size());
  for (std::size_t k = 0; k < fine.lobes.size(); ++k) {
    EXPECT_NEAR(found.lobes[k].area, fine.lobes[k].area, 1e-8);
    EXPECT_NEAR(found.lobes[k].inside, fine.lobes[k].inside, 1e-8);
    EXPECT_DOUBLE_EQ(found.lobes[k].inside + found.lobes[k].outside, std::fabs(found.lobes[k].area));
  }
  EXPECT_NEAR(found.boundary->area, fine.boundary->area, 1e-7);
  const std::vector<LobeOverlap> common = overlaps(found), finer_common = overlaps(fine);
  ASSERT_EQ(common.size(), finer_common.size());
  for (std::size_t k = 0; k < common.size(); ++k) EXPECT_NEAR(common[k].area, finer_common[k].area, 1e-8);
}

}  // namespace
}  // namespace lober::detail

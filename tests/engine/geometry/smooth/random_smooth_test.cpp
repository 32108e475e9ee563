// Smooth areas of pairs that have nothing smooth about them: whatever the curves do, areas are finite, fit together,
// and regions that polygons leave empty are empty within their error.

#include <gtest/gtest.h>

#include <cmath>

#include "lober/overlay/smooth.hpp"
#include "tests/oracle/families.hpp"
#include "tests/views.hpp"

namespace lober::detail {
namespace {

class RandomSmooth : public testing::TestWithParam<oracle::Family> {};

TEST_P(RandomSmooth, FitsTogether) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto pair = oracle::make_curve_pair(GetParam(), seed);
    const Overlay result = overlay(CurveView{pair.first}, CurveView{pair.second});
    const SmoothAreas smooth = smooth_areas(result);
    const Areas &a = smooth.areas, &e = smooth.error, &polygons = result.areas;
    for (const auto member : {&Areas::c1, &Areas::c2, &Areas::union_, &Areas::c1_minus_c2, &Areas::c2_minus_c1,
                              &Areas::intersection, &Areas::symmetric_difference}) {
      EXPECT_TRUE(std::isfinite(a.*member) && std::isfinite(e.*member)) << seed;
      EXPECT_GE(a.*member, 0) << seed;
      EXPECT_GE(e.*member, 0) << seed;
      if (polygons.*member == 0) {
        EXPECT_LE(a.*member, e.*member) << seed;
      }
    }
    const double slack = 1e-12 * polygons.union_;
    const auto fit = [&](double left, double right, double bars) { EXPECT_NEAR(left, right, bars + slack) << seed; };
    fit(a.c1, a.c1_minus_c2 + a.intersection, e.c1_minus_c2 + e.intersection);
    fit(a.c2, a.c2_minus_c1 + a.intersection, e.c2_minus_c1 + e.intersection);
    fit(a.union_, a.c1_minus_c2 + a.c2_minus_c1 + a.intersection, e.symmetric_difference + e.intersection);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, RandomSmooth,
                         testing::ValuesIn(oracle::families().begin(), oracle::families().end()),
                         [](const auto& member) { return std::string(member.param.name); });

}  // namespace
}  // namespace lober::detail

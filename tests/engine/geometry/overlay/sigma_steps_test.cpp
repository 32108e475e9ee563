// sigma, its classes and S: the tables of Naik, Lekien & Ross (2017), and areas that follow from them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lober/base/error.hpp"
#include "lober/overlay/overlay.hpp"
#include "tests/engine/geometry/overlay/six_crossings.hpp"
#include "tests/oracle/families.hpp"
#include "tests/views.hpp"

namespace lober::detail {
namespace {

using test::six_crossings_c1;
using test::six_crossings_c2;

using Numbers = std::vector<std::uint32_t>;
Numbers column(const std::vector<SigmaStep>& steps, std::uint32_t SigmaStep::*member) {
  Numbers numbers;
  for (const SigmaStep& step : steps) numbers.push_back(step.*member);
  return numbers;
}

TEST(SigmaSteps, AreTablesOneToFour) {
  const std::vector<SigmaStep> steps =
      sigma_steps(overlay(CurveView{six_crossings_c1}, CurveView{six_crossings_c2}), Pairing::c1_minus_c2);
  // The columns with a 1 in the rows of the tables, from 0.
  EXPECT_EQ(column(steps, &SigmaStep::along1), (Numbers{1, 2, 3, 4, 5, 0})) << "Table 1";
  EXPECT_EQ(column(steps, &SigmaStep::along2), (Numbers{5, 0, 3, 4, 1, 2})) << "Table 2";
  EXPECT_EQ(column(steps, &SigmaStep::sigma), (Numbers{1, 0, 3, 4, 5, 2})) << "Tables 3 and 4";
  EXPECT_EQ(column(steps, &SigmaStep::class_number), (Numbers{0, 0, 1, 1, 1, 1})) << "Table 4";
  for (std::size_t k = 0; k < steps.size(); ++k) EXPECT_EQ(steps[k].rho, k % 2 == 0 ? 1 : -1) << "Table 4";
  EXPECT_EQ(steps[0].s + steps[1].s, 2 * 1);
  EXPECT_EQ(steps[2].s + steps[3].s + steps[4].s + steps[5].s, 2 * 5);
}

// The same functions for the other orientation of either input, with crossings as they come along C1.
TEST(SigmaSteps, DoNotDependOnTheOrientation) {
  for (const bool reverse1 : {false, true}) {
    for (const bool reverse2 : {false, true}) {
      std::vector<Point> c1 = six_crossings_c1, c2 = six_crossings_c2;
      if (reverse1) std::reverse(c1.begin(), c1.end());
      if (reverse2) std::reverse(c2.begin(), c2.end());
      const Overlay result = overlay(CurveView{c1}, CurveView{c2});
      const auto as_before = [&](std::uint32_t node) { return reverse1 ? 5 - node : node; };
      for (const Pairing pairing : {Pairing::c1_minus_c2, Pairing::c2_minus_c1}) {
        const std::vector<SigmaStep> steps = sigma_steps(result, pairing);
        const std::vector<SigmaStep> before =
            sigma_steps(overlay(CurveView{six_crossings_c1}, CurveView{six_crossings_c2}), pairing);
        for (const SigmaStep& step : steps) {
          const SigmaStep& same = before[as_before(step.crossing)];
          EXPECT_EQ(as_before(step.sigma), same.sigma);
          EXPECT_EQ(as_before(step.along1), same.along1);
          EXPECT_EQ(as_before(step.along2), same.along2);
          EXPECT_EQ(step.rho, same.rho);
          EXPECT_EQ(step.s, same.s);
        }
      }
    }
  }
}

class SigmaStepsOfFamilies : public testing::TestWithParam<oracle::Family> {};

// Half the sum of S, over all and over each class, with touches and shared arcs and any orientation.
TEST_P(SigmaStepsOfFamilies, GiveTheAreas) {
  std::size_t pieces = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const oracle::CurvePair pair = oracle::make_curve_pair(GetParam(), seed);
    const Overlay result = overlay(CurveView{pair.first}, CurveView{pair.second});
    if (result.nodes.crossings() == 0 || result.largest_coordinate > 1e100) continue;
    for (const Pairing pairing : {Pairing::c1_minus_c2, Pairing::c2_minus_c1}) {
      const std::vector<SigmaStep> steps = sigma_steps(result, pairing);
      ASSERT_EQ(steps.size(), result.nodes.crossings());
      double size = 0;
      std::vector<double> sums;
      Numbers targets;
      for (const SigmaStep& step : steps) {
        sums.resize(std::max(sums.size(), step.class_number + std::size_t{1}));
        sums[step.class_number] += 0.5 * step.s;
        size += std::fabs(step.s);
        targets.push_back(step.sigma);
        if (pairing == Pairing::c1_minus_c2) {
          EXPECT_EQ(step.class_number, result.classes[step.crossing]);
        }
      }
      // sigma is one-to-one and onto.
      std::sort(targets.begin(), targets.end());
      EXPECT_EQ(targets, column(steps, &SigmaStep::crossing));
      const double crossings = static_cast<double>(result.nodes.crossings());
      const double bar =
          0x1p-51 * (crossings * result.largest_coordinate * result.longest_segment + (crossings + 4) * size) + 1e-300;
      double sum = 0;
      for (const double part : sums) sum += part;
      const double area = pairing == Pairing::c1_minus_c2 ? result.areas.c1_minus_c2 : result.areas.c2_minus_c1;
      EXPECT_NEAR(sum, area, bar) << pair.family << ' ' << seed;
      if (result.nodes.crossings() != result.nodes.size()) continue;
      // Without touches and shared arcs each class is the boundary of a piece; a hole is a class too, less its area.
      const auto& found = result.pieces(pairing);
      if (sums.size() != found.size()) continue;
      for (std::size_t k = 0; k < sums.size(); ++k, ++pieces) {
        EXPECT_TRUE(std::any_of(found.areas().begin(), found.areas().end(),
                                [&](double one) { return std::fabs(one - sums[k]) <= bar; }))
            << pair.family << ' ' << seed << ' ' << sums[k];
      }
    }
  }
  RecordProperty("pieces", static_cast<int>(pieces));
}

INSTANTIATE_TEST_SUITE_P(Families, SigmaStepsOfFamilies,
                         testing::ValuesIn(oracle::families().begin(), oracle::families().end()),
                         [](const auto& family) { return std::string(family.param.name); });

TEST(SigmaSteps, AreNoneWithoutCrossings) {
  const std::vector<Point> far{{20, 20}, {21, 20}, {21, 21}};
  const Overlay apart = overlay(CurveView{six_crossings_c1}, CurveView{far});
  EXPECT_TRUE(sigma_steps(apart, Pairing::c1_minus_c2).empty());
  EXPECT_TRUE(
      sigma_steps(overlay(CurveView{six_crossings_c1}, CurveView{six_crossings_c1}), Pairing::c2_minus_c1).empty());
  EXPECT_THROW((void)sigma_steps(apart, Pairing::union_), UsageError);
}

}  // namespace
}  // namespace lober::detail

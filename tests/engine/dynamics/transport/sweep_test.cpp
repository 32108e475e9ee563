#include "lober/sweep.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "lober/error.hpp"
#include "lober/systems.hpp"

namespace lober {
namespace {

FamilyMember vortex_pair(double gamma) {
  const System system = make_system("ovp1", {{"gamma", gamma}}, IntegrationOptions{.tolerance = 1e-9});
  return {system.map, *system.connection};
}

// W(q) - W(q') of the vortex pair, to first order, is zero at 1.40676409.
TEST(Sweep, FindsTheZeroFromEitherSide) {
  SweepOptions options;
  options.tangle.tolerance = 1e-3;
  options.find_zeros = true;
  for (const std::array<double, 2>& values : {std::array{1.38, 1.43}, std::array{1.43, 1.38}}) {
    const Sweep found = sweep(vortex_pair, values, options);
    ASSERT_EQ(found.zeros.size(), 1U);
    const SweepZero& zero = found.zeros[0];
    EXPECT_NEAR(zero.value, 1.40676409, 1e-8);
    EXPECT_EQ(zero.failure, "");
    EXPECT_EQ(zero.low, values[0]);
    EXPECT_GT(zero.width, 0);
    EXPECT_LE(zero.width, 1e-10 * zero.value);
    EXPECT_LT(std::fabs(zero.difference), 1e-9);
    EXPECT_LE(zero.evaluations, 8);
  }
}

TEST(Sweep, SaysWhyAZeroIsNotRefined) {
  SweepOptions options;
  options.tangle.tolerance = 1e-3;
  options.find_zeros = true;
  const std::array values{1.3, 1.5};
  const Sweep failing = sweep(
      [](double gamma) {
        if (gamma != 1.3 && gamma != 1.5) throw DataError("nothing between");
        return vortex_pair(gamma);
      },
      values, options);
  ASSERT_EQ(failing.zeros.size(), 1U);
  EXPECT_EQ(failing.zeros[0].failure, "nothing between");
  EXPECT_EQ(failing.zeros[0].evaluations, 1);
  EXPECT_EQ(failing.zeros[0].width, values[1] - values[0]);

  options.zero_tolerance = 1e-3;
  const Sweep jumping = sweep([](double gamma) { return vortex_pair(gamma < 1.4321 ? 1.3 : 1.5); }, values, options);
  ASSERT_EQ(jumping.zeros.size(), 1U);
  EXPECT_NEAR(jumping.zeros[0].value, 1.4321, 2e-3);
  EXPECT_NE(jumping.zeros[0].failure.find("jumps"), std::string::npos) << jumping.zeros[0].failure;
}

}  // namespace
}  // namespace lober

#include "lober/base/agreement.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace lober {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Agreement, WithinTheSumOfTheBars) {
  Agreement agreement;
  EXPECT_TRUE(agreement.agrees());
  agreement.compare({"T12(1)", "lobes", "boundaries", 1, 1.5, 0.5});
  EXPECT_TRUE(agreement.agrees());
  agreement.compare({"T12(2)", "lobes", "boundaries", 0.92693, 0.78498, 4e-9});
  agreement.compare({"T12(3)", "lobes", "boundaries", 2, 2, 0});
  EXPECT_FALSE(agreement.agrees());
  ASSERT_EQ(agreement.disagreements().size(), 1U);
  EXPECT_EQ(agreement.disagreements()[0].what, "T12(2)");
  EXPECT_NEAR(agreement.disagreements()[0].difference(), 0.14195, 1e-12);
}

TEST(Agreement, OneRouteIsNoComparisonAndNoBarAllowsNothing) {
  Agreement agreement;
  agreement.compare({"T12(1)", "lobes", "boundaries", 1, nan, 0});
  agreement.compare({"T12(1)", "lobes", "boundaries", nan, 1, 0});
  EXPECT_TRUE(agreement.comparisons.empty());
  agreement.compare({"T12(1)", "lobes", "boundaries", 1, 1, nan});
  EXPECT_TRUE(agreement.agrees());
  agreement.compare({"T12(1)", "lobes", "boundaries", 1, 1.0000001, nan});
  EXPECT_FALSE(agreement.agrees());
}

}  // namespace
}  // namespace lober

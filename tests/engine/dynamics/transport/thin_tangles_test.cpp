// Tangles whose lobes are thinner than any polygon that one would grow unasked, and those that are none.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <ostream>
#include <string>

#include "lober/base/error.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/tangle/manifold_tangle.hpp"
#include "tests/refusal.hpp"

namespace lober {
namespace {

std::unique_ptr<ManifoldTangle> turnstile(const std::string& name, const ParameterValues& values) {
  const System system = make_system(name, values);
  return grow_tangle(*system.map, *system.connection);
}

struct Thin {
  std::string system, parameter;
  double value;
  double area;       // of a lobe of the turnstile
  double tolerance;  // relative
};

void PrintTo(const Thin& thin, std::ostream* out) {
  *out << thin.system << ' ' << thin.parameter << '=' << thin.value;
}

class ThinTangles : public testing::TestWithParam<Thin> {};

// References: the actions of the symmetric orbits, in 110-digit arithmetic for maps; for the oscillator Melnikov's
// integral, eps 2 sqrt(2) pi omega / cosh(pi omega / 2), to O(eps^2).
TEST_P(ThinTangles, HaveTwoLobesOfTheRightArea) {
  const Thin& thin = GetParam();
  const auto found = turnstile(thin.system, {{thin.parameter, thin.value}});
  ASSERT_EQ(found->period(), 2U);
  ASSERT_EQ(found->areas_by_action.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const Lobe& lobe = found->tangle.lobes[found->image_of_bip(-1) + k];
    const double action = found->areas_by_action[k];
    EXPECT_NEAR(std::fabs(lobe.area), thin.area, thin.tolerance * thin.area);
    EXPECT_NEAR(std::fabs(action), thin.area, thin.tolerance * thin.area);
    EXPECT_LE(std::fabs(lobe.area - action), lobe.smooth_error + found->action_errors[k]);
  }
}

INSTANTIATE_TEST_SUITE_P(
    , ThinTangles,
    testing::Values(Thin{"standard", "K", 0.25, 1.5629978e-6, 1e-7}, Thin{"standard", "K", 0.2, 1.5515588e-7, 1e-7},
                    Thin{"standard", "K", 0.15, 5.2242777e-9, 1e-6}, Thin{"henon", "k", -0.95, 1.3966981e-7, 1e-7},
                    Thin{"duffing", "eps", 1e-3, 3.5413044e-3, 1e-6}, Thin{"duffing", "eps", 1e-6, 3.5413e-6, 1e-5}),
    [](const auto& each) { return each.param.system + std::to_string(each.index); });

// Orbits that pass the vortices closely are off along the manifold by far more than across it, and those farther out
// by more than these: bars were up to 14 for lobes of 0.25.
TEST(ErrorBars, FollowTheArcsOfALobe) {
  for (const ParameterValues& values : {ParameterValues{{"eps", 0.7}, {"phase", 0.5}}, ParameterValues{{"eps", 1.4}}}) {
    const auto found = turnstile("ovp", values);
    ASSERT_EQ(found->areas_by_action.size(), found->period());
    for (std::size_t k = 0; k < found->period(); ++k) {
      const Lobe& lobe = found->tangle.lobes[found->image_of_bip(-1) + k];
      EXPECT_LE(lobe.smooth_error, 3e-8);
      EXPECT_LE(std::fabs(lobe.area - found->areas_by_action[k]), lobe.smooth_error + found->action_errors[k]);
    }
  }
}

TEST(ThinTangle, IsNotDrawnCoarserThanItsSize) {
  const System system = make_system("ovp", {});
  ManifoldTangleOptions options;
  options.tolerance = 100;
  EXPECT_THROW((void)grow_tangle(*system.map, *system.connection, options), UsageError);
}

TEST(ThinTangle, AgreesWithMelnikov) {
  using std::numbers::pi;
  const double eps = 1e-4;
  const auto found = turnstile("duffing", {{"eps", eps}});
  const double expected = eps * 2 * std::sqrt(2.0) * pi / std::cosh(pi / 2);
  EXPECT_NEAR(std::fabs(found->areas_by_action[0]), expected, 20 * eps * expected);
}

std::string turnstile_refusal(const std::string& name, const ParameterValues& values) {
  return test::refusal([&] { (void)turnstile(name, values); });
}

TEST(ThinTangle, ThatIsNoneIsSaidToCoincide) {
  EXPECT_NE(turnstile_refusal("ovp", {{"eps", 0}}).find("coincide"), std::string::npos);
  EXPECT_NE(turnstile_refusal("duffing", {{"eps", 0}}).find("coincide"), std::string::npos);
  EXPECT_NE(turnstile_refusal("ovp", {{"gamma", 0.01}}).find("coincide"), std::string::npos);
}

// Where polygons cannot show the lobes the action still knows them.
TEST(ThinTangle, BeyondPolygonsHasTheAreaByAction) {
  const std::string text = turnstile_refusal("standard", {{"K", 0.08}});
  EXPECT_NE(text.find("no polygons in double precision"), std::string::npos) << text;
  EXPECT_NE(text.find("by action"), std::string::npos) << text;
}

TEST(ThinTangle, EndsWhereTheWorkIsTooMuch) {
  const std::string text = turnstile_refusal("duffing", {{"omega", 0.35}});
  EXPECT_NE(text.find("more work than is done unasked"), std::string::npos) << text;
}

}  // namespace
}  // namespace lober

// Lobes by geometry and by action, against reference values of 110-digit arithmetic (maps) and of quadruple precision
// (flows).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>

#include "lober/base/error.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/tangle/manifold_tangle.hpp"
#include "lober/transport/transport.hpp"
#include "tests/engine/dynamics/test_maps.hpp"
#include "tests/paths.hpp"

namespace lober {
namespace {

struct LobeCase {
  const char* system;
  ParameterValues parameters;
  Point bip;     // q_A
  double area;   // of either turnstile lobe
  bool outside;  // whether the lobe (q_B, q_A) lies outside
};

std::unique_ptr<ManifoldTangle> grown(const System& system, double tolerance, int before = 1, int after = 0) {
  ManifoldTangleOptions options;
  options.tolerance = tolerance;
  options.before = before;
  options.after = after;
  return grow_tangle(*system.map, *system.connection, options);
}

void check_lobes(const LobeCase& known, double tolerance, double pip_error, double action_error, double area_error) {
  SCOPED_TRACE(known.system);
  const System system = make_system(known.system, known.parameters);
  const auto found = grown(system, tolerance);
  ASSERT_EQ(found->period(), 2U);
  ASSERT_EQ(found->areas_by_action.size(), 2U);
  const Point bip = found->orbits.back().at;
  EXPECT_NEAR(bip.x, known.bip.x, pip_error);
  EXPECT_NEAR(bip.y, known.bip.y, pip_error);
  for (std::size_t k = 0; k < 2; ++k) {
    const Lobe& lobe = found->tangle.lobes[found->bip - 2 + k];
    EXPECT_NEAR(std::fabs(found->areas_by_action[k]), known.area, action_error * known.area);
    EXPECT_NEAR(std::fabs(lobe.area), known.area, area_error * known.area);
    EXPECT_EQ(lobe.area > 0, found->areas_by_action[k] > 0);
    EXPECT_LE(std::fabs(std::fabs(lobe.area) - known.area), lobe.smooth_error + 1e-14);
  }
  EXPECT_EQ(found->tangle.lobes[found->bip - 1].inside == 0, known.outside);
}

TEST(TangleOfMap, LobesOfMapsToFourteenDigits) {
  using std::numbers::pi;
  for (const LobeCase& known : {
           LobeCase{"standard",
                    {{"K", 1.2}},
                    {pi, 1.9173532103668022394821859758},
                    0.05805630576704177816917301265938610107,
                    false},
           LobeCase{"standard",
                    {{"K", 2.0}},
                    {pi, 2.2357374763308007437101795070},
                    0.39492059602290671294237539733539969903,
                    false},
           LobeCase{"henon",
                    {{"k", 0.0}},
                    {-1.1544826836094798202011411312, 0.66641513337707142},
                    0.3659884387255914880128925502543729421,
                    true},
           LobeCase{"henon",
                    {{"k", 0.5}},
                    {-1.5330999704679823237532195910, 0.92519775972446413},
                    1.0364943412491413807970964288427805111,
                    true},
       }) {
    check_lobes(known, 1e-7, 1e-11, 1e-14, 1e-12);
  }
}

TEST(TangleOfMap, LobesOfTheVortexPair) {
  for (const LobeCase& known : {
           LobeCase{"ovp", {{"gamma", 0.5}, {"eps", 0.1}}, {0, 2.068482945180626534}, 0.254106277099506951, true},
           LobeCase{"ovp", {{"gamma", 1.81}, {"eps", 0.1}}, {0, 1.953524655049622202}, 0.257704126619159931, false},
           LobeCase{"ovp1", {{"gamma", 0.5}, {"eps", 0.1}}, {0, 2.064627690528027250}, 0.205511682983426906, true},
           LobeCase{"ovp1", {{"gamma", 1.81}, {"eps", 0.1}}, {0, 1.954296351204017731}, 0.295871016205730941, false},
       }) {
    check_lobes(known, 1e-5, 1e-11, 1e-10, 1e-7);
  }
}

// Signed area of the lobe from q_B to q_A over gamma; it changes sign near 1.474.
TEST(TangleOfMap, FluxOfTheVortexPairChangesSign) {
  struct Known {
    double gamma, area;
  };
  for (const Known known : {Known{0.3, 0.0738884728346927534}, Known{0.8, 0.359265073341903353},
                            Known{1.2, 0.195951329914052724}, Known{2.0, -0.397237323975881752}}) {
    const System system = make_system("ovp", {{"gamma", known.gamma}, {"eps", 0.1}});
    const auto found = grown(system, 1e-4);
    ASSERT_EQ(found->areas_by_action.size(), 2U) << known.gamma;
    EXPECT_NEAR(-found->areas_by_action[1], known.area, 1e-10) << known.gamma;
  }
}

TEST(TangleOfMap, FourPipsAPeriod) {
  const auto found = grown(make_system("ovp", {{"gamma", 1.5}, {"eps", 0.1}}), 1e-4);
  ASSERT_EQ(found->period(), 4U);
  const std::array<double, 4> areas{0.03598126829734, 0.01604741113880, 0.01604741113880, 0.03598126829734};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(std::fabs(found->areas_by_action[k]), areas[k], 1e-10);
  // The outer lobes of this one overlap each other.
  const auto multilobe = grown(make_system("pcr3bp"), 1e-5);
  ASSERT_EQ(multilobe->period(), 4U);
  EXPECT_NEAR(multilobe->local_u.multiplier, 31.552237923806206, 1e-7);
  EXPECT_NEAR(multilobe->orbits.back().at.x, -1.149486253215600261, 1e-11);
  const std::array<double, 4> four{0.002399089699298644, -0.000873578659653445, 0.000873578659653445,
                                   -0.002399089699298644};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(multilobe->areas_by_action[k], four[k], 1e-11);
}

// Lobes of the forced oscillators, whose saddles move with the force, against Melnikov's method: the area between two
// zeros of its integral over the unperturbed separatrix, for small eps.
TEST(TangleOfMap, LobesOfForcedOscillators) {
  using std::numbers::pi;
  for (const double omega : {1.0, 2.0, 3.0}) {
    for (const double eps : {0.01, 0.02}) {
      for (const char* name : {"duffing", "pendulum"}) {
        SCOPED_TRACE(std::string(name) + " omega " + std::to_string(omega) + " eps " + std::to_string(eps));
        const double homoclinic = 2 * std::numbers::sqrt2 * pi * eps / std::cosh(pi * omega / 2);
        const double heteroclinic = 4 * pi * eps / (omega * std::cosh(pi * omega / 2));
        const double melnikov = name == std::string("duffing") ? homoclinic : heteroclinic;
        const System system = make_system(name, {{"omega", omega}, {"eps", eps}});
        const auto found = grown(system, 1e-6);
        ASSERT_EQ(found->period(), 2U);
        ASSERT_EQ(found->areas_by_action.size(), 2U);
        for (std::size_t k = 0; k < 2; ++k) {
          const Lobe& lobe = found->tangle.lobes[found->bip - 2 + k];
          EXPECT_NEAR(std::fabs(found->areas_by_action[k]), melnikov, 10 * eps * eps * melnikov);
          EXPECT_NEAR(lobe.area, found->areas_by_action[k], 1e-6 * melnikov);
        }
      }
    }
  }
}

TEST(TangleOfMap, ForcesThatMoveTheSaddleFar) {
  for (const ParameterValues& parameters :
       {ParameterValues{{"eps", 0.3}}, ParameterValues{{"eps", 0.3}, {"phase", 0.4}}, ParameterValues{{"omega", 1.5}},
        ParameterValues{{"eps", 0.45}}}) {
    for (const char* name : {"duffing", "pendulum"}) {
      const auto found = grown(make_system(name, parameters), 1e-5);
      EXPECT_EQ(found->period(), 2U) << name;
      EXPECT_NEAR(found->areas_by_action[0], -found->areas_by_action[1], 1e-9) << name;
    }
  }
}

// Manifolds that lie closer than the tolerance asked for: their polygons cross where they do not.
TEST(TangleOfMap, ThinLobesAreGrownFiner) {
  const auto chirikov = grown(make_system("standard", {{"K", 0.3}}), 1e-5);
  EXPECT_EQ(chirikov->period(), 2U);
  EXPECT_LE(chirikov->tolerance, 1e-6);
  const auto finer = grown(make_system("standard", {{"K", 0.3}}), 1e-8);
  EXPECT_NEAR(chirikov->areas_by_action[0], finer->areas_by_action[0], 1e-17);
  EXPECT_NEAR(chirikov->areas_by_action[0], -chirikov->areas_by_action[1], 1e-17);
  const auto birth = grown(make_system("ovp", {{"gamma", 1.35}}), 1e-5, 1, 1);  // two of the pips are just born
  EXPECT_EQ(birth->period(), 4U);
  EXPECT_EQ(grown(make_system("standard", {{"K", 1.2}}), 1e-5)->tolerance, 1e-5);
}

// Where damping wins U ends in a sink before it could meet S; where it does not, lobes are found, but areas shrink and
// say nothing of transport.
TEST(TangleOfMap, DampedOscillators) {
  const auto message = [](const ParameterValues& parameters, const auto& job) -> std::string {
    const System system = make_system("duffing", parameters);
    try {
      job(system);
    } catch (const DataError& error) {
      return error.what();
    }
    return "";
  };
  const auto tangle = [](const System& system) { EXPECT_EQ(grown(system, 1e-5)->period(), 2U); };
  const auto all = [](const System& system) { (void)transport(*system.map, *system.connection, {.iterates = 1}); };
  EXPECT_NE(message({{"delta", 0.3}}, tangle).find("do not cross"), std::string::npos);
  EXPECT_EQ(message({{"delta", 0.1}}, tangle), "");
  EXPECT_NE(message({{"delta", 0.1}}, all).find("does not preserve area"), std::string::npos);
}

TEST(TangleOfMap, SaysWhatIsMissing) {
  const System system = make_system("standard", {{"K", 1.2}});
  Connection wrong = *system.connection;
  wrong.from = {3.14159, 0};  // an elliptic point
  EXPECT_THROW((void)grow_tangle(*system.map, wrong), DataError);
  // Manifolds of the same saddle that lead away from each other: into the next cell and never back.
  ManifoldTangleOptions few;
  few.max_iterates = 2;
  few.before = few.after = 6;
  EXPECT_THROW((void)grow_tangle(*system.map, *system.connection, few), DataError);
  ManifoldTangleOptions small;
  small.before = small.after = 8;
  small.max_points = 5000;
  EXPECT_THROW((void)grow_tangle(*system.map, *system.connection, small), DataError);
  EXPECT_THROW((void)grow_tangle(*system.map, *system.connection, {.before = 0}), UsageError);
  TransportOptions none;
  none.iterates = 0;
  EXPECT_THROW((void)transport(*system.map, *system.connection, none), UsageError);
}

}  // namespace
}  // namespace lober

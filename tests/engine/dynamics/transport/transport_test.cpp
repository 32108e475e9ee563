// Lobes by geometry and by action, and transport, against reference values of 110-digit arithmetic (maps) and of
// quadruple precision (flows).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/views.hpp"
#include "lober/error.hpp"
#include "lober/transport.hpp"
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
  const double pi = std::numbers::pi;
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

struct TransportRow {
  int n;
  double flux, total;
};

// Everything that two routes say of one quantity.
void expect_agreement(const Transport& found) {
  EXPECT_FALSE(found.agreement.comparisons.empty());
  for (const Comparison& pair : found.agreement.disagreements()) {
    ADD_FAILURE() << pair.what << ": " << pair.first << " by " << pair.first_by << ", " << pair.second << " by "
                  << pair.second_by << ", bars " << pair.bar;
  }
}

Transport transport_of(const System& system, int iterates, double tolerance, bool all = false) {
  TransportOptions options;
  options.iterates = iterates;
  options.tolerance = tolerance;
  options.lattice = system.lattice;
  if (all || system.further_needed) options.further = system.further;
  return transport(*system.map, *system.connection, options);
}

void check_transport(const Transport& found, std::span<const TransportRow> rows, double error) {
  expect_agreement(found);
  for (const TransportRow& row : rows) {
    const TransportStep& step = found.steps.at(static_cast<std::size_t>(row.n - 1));
    EXPECT_EQ(step.n, row.n);
    EXPECT_NEAR(step.flux(0, 1).value, row.flux, error) << row.n;
    EXPECT_NEAR(step.flux(1, 0).value, row.flux, error) << row.n;
    for (const Measured total : {step.total(0, 1), step.total(1, 0)}) {
      EXPECT_NEAR(total.value, row.total, error * row.n) << row.n;
      EXPECT_LE(std::fabs(total.value - row.total), total.error) << row.n;
      EXPECT_LT(total.error, 1e-5);
    }
    const Measured boundaries = step.by_boundaries(0, 1);
    EXPECT_LE(std::fabs(boundaries.value - row.total), boundaries.error) << row.n;
    EXPECT_LT(std::fabs(boundaries.value - row.total), 1e-6) << row.n;
  }
}

TEST(Transport, HenonMap) {
  const Transport found = transport_of(make_system("henon", {{"k", 0.5}}), 8, 1e-7);
  const double lobe = 1.0364943412491413807970964288427805111;
  EXPECT_NEAR(found.regions[0].area.value, 9.5886920061239648399055, 1e-10);
  EXPECT_NEAR(found.boundaries[0].area12.value, lobe, 1e-12);
  EXPECT_NEAR(found.boundaries[0].action12, lobe, 1e-14);
  EXPECT_NEAR(found.boundaries[0].action21, lobe, 1e-14);
  const std::array<TransportRow, 8> rows{{{1, lobe, lobe},
                                          {2, lobe, 2 * lobe},
                                          {3, lobe, 3 * lobe},
                                          {4, 0.9589873456950768456773, 4.068470369442500988069},
                                          {5, 0.5826983180488817331855, 4.651168687491382721254},
                                          {6, 0.4718224531769735411984, 5.122991140668356262452},
                                          {7, 0.4449562082011656619228, 5.567947348869521924375},
                                          {8, 0.3472857694532554597, 5.915233118322777583846}}};
  check_transport(found, rows, 2e-13);
}

TEST(Transport, VortexPair) {
  const Transport found = transport_of(make_system("ovp", {{"gamma", 0.5}, {"eps", 0.1}}), 5, 1e-5);
  EXPECT_NEAR(found.regions[0].area.value, 4.5732702376385334, 2e-8);
  const std::array<TransportRow, 5> rows{{{1, 0.254106277099507, 0.254106277099507},
                                          {2, 0.254106277099507, 0.508212554199014},
                                          {3, 0.238144168406064, 0.746356722605078},
                                          {4, 0.152565256038327, 0.898921978643405},
                                          {5, 0.146829811695738, 1.045751790339143}}};
  check_transport(found, rows, 1e-8);
}

// Fluid that leaves a bounded flow comes back: the sum of mu(L12(1) n f^m L21(1)) alone is wrong by 0.0656 at n = 2.
TEST(Transport, FluidThatComesBack) {
  const Transport found = transport_of(make_system("duffing"), 3, 1e-6);
  expect_agreement(found);
  EXPECT_NEAR(found.steps[1].total(0, 1).value, 0.63950, 5e-6);
  EXPECT_NEAR(found.steps[2].total(0, 1).value, 0.78498038551, 1e-7);
  EXPECT_NEAR(found.steps[2].by_boundaries(0, 1).value, 0.78498038551, 1e-7);
  EXPECT_NEAR(found.steps[1].overlaps[1][0].value, 0.06558879338, 1e-8);
}

// Lobes that overlap each other count once where they leave and enter at a time.
TEST(Transport, MultilobeTurnstile) {
  const Transport found = transport_of(make_system("pcr3bp"), 2, 1e-5);
  expect_agreement(found);
  EXPECT_LT(found.boundaries[0].area12.value, found.boundaries[0].action12 - 1e-6);
}

// On the cylinder what leaves a cell upward is not lost to its neighbours: 2e8 particles at n = 4.
TEST(Transport, StripOfTheCylinder) {
  const Transport found = transport_of(make_system("standard", {{"K", 2.0}}), 5, 1e-5);
  expect_agreement(found);
  ASSERT_EQ(found.regions.size(), 3U);
  EXPECT_TRUE(found.regions[0].bounded);
  EXPECT_FALSE(found.regions[1].bounded || found.regions[2].bounded);
  const double lobe = 0.39492059602290671294237539733539969903;
  EXPECT_NEAR(found.steps[1].total(0, 1).value, 2 * lobe, 1e-7);
  EXPECT_NEAR(found.steps[3].total(0, 1).value, 1.513, 0.006);
  EXPECT_NEAR(found.steps[4].total(0, 1).value, 1.710, 0.006);
  EXPECT_NEAR(found.steps[4].total(2, 1).value, 0.1114, 0.002);  // from below the strip to above it
  for (const TransportStep& step : found.steps) {
    // The rotation by half a turn exchanges above and below.
    const Measured up = step.total(0, 1), down = step.total(0, 2);
    EXPECT_NEAR(up.value, down.value, up.error + down.error);
    EXPECT_LT(up.error + down.error, 1e-4);
    EXPECT_NEAR(step.by_boundaries(0, 1).value, step.by_boundaries(2, 0).value, 1e-7);
  }
}

// Lobes thinner than what polygons on the cylinder would show at the tolerance: they crossed thrice for each pip, and T
// by boundaries was one lobe short.
TEST(Transport, ThinLobesOfTheCylinder) {
  const Transport found = transport_of(make_system("standard", {{"K", 0.4}}), 3, 1e-5);
  expect_agreement(found);
  EXPECT_NEAR(found.steps[0].by_boundaries(0, 1).value, 9.2922280086e-05, 1e-9);
}

// Every built-in system has two routes, and all that they say agrees; species keep their area.
TEST(Transport, TwoRoutesForEverySystem) {
  for (const auto& [name, iterates] : {std::pair{"ovp", 3},
                                       {"ovp1", 2},
                                       {"duffing", 2},
                                       {"pendulum", 1},
                                       {"double-gyre", 1},
                                       {"standard", 6},
                                       {"henon", 6},
                                       {"pcr3bp", 1}}) {
    SCOPED_TRACE(name);
    const Transport found = transport_of(make_system(name), iterates, 1e-4);
    expect_agreement(found);
    const double area = found.regions[0].area.value;
    for (const TransportStep& step : found.steps) {
      double of_species = 0;
      for (std::size_t j = 0; j < step.total.size(); ++j) of_species += step.total(0, j).value;
      EXPECT_NEAR(of_species, area, 1e-5 * area);
      EXPECT_FALSE(std::isnan(step.by_boundaries(0, 1).value));
    }
  }
}

TEST(Transport, GyreBoundedByWalls) {
  const Transport found = transport_of(make_system("double-gyre"), 1, 1e-4);
  EXPECT_NEAR(found.regions[0].area.value, 1, 0.07);
  EXPECT_NEAR(found.steps[0].by_boundaries(0, 1).value, found.steps[0].total(0, 1).value, 1e-5);
}

// The lower vortex mirrors the upper one; nothing goes from one to the other.
TEST(Transport, SeveralRegions) {
  const Transport found = transport_of(make_system("ovp"), 3, 1e-4, true);
  expect_agreement(found);
  ASSERT_EQ(found.regions.size(), 3U);
  for (const TransportStep& step : found.steps) {
    EXPECT_NEAR(step.total(2, 1).value, step.total(0, 1).value, 1e-5);
    EXPECT_NEAR(step.total(0, 2).value, 0, 1e-9);
    EXPECT_NEAR(step.by_boundaries(0, 2).value, 0, 1e-9);
  }
}

TEST(Transport, ParticlesAreAThirdRoute) {
  const System system = make_system("henon", {{"k", 0.5}});
  TransportOptions options;
  options.iterates = 5;
  options.tolerance = 1e-5;
  options.particles = 100'000;
  const auto run = [&](int threads) {
    return with_threads(threads, [&] { return transport(*system.map, *system.connection, options); });
  };
  const Transport found = run(1), again = run(7);
  expect_agreement(found);
  for (std::size_t k = 0; k < found.steps.size(); ++k) {
    const Measured counted = found.steps[k].by_particles(0, 1);
    EXPECT_NEAR(counted.value, found.steps[k].total(0, 1).value, 5 * counted.error);
    EXPECT_NEAR(counted.error, 0, 0.02);
    EXPECT_EQ(counted.value, again.steps[k].by_particles(0, 1).value);
    EXPECT_FALSE(std::isnan(found.steps[k].by_particles(1, 0).value));
  }
}

// A map that preserves area at the saddle, where it is asked, but nowhere else: routes disagree, and the result says
// so.
TEST(Transport, SaysThatRoutesDisagree) {
  const System system = make_system(LOBER_TEST_LIBRARIES "/leaky.so");
  const Transport found = transport_of(system, 2, 1e-5);
  EXPECT_FALSE(found.agreement.agrees());
  const auto apart = found.agreement.disagreements();
  EXPECT_TRUE(std::any_of(apart.begin(), apart.end(), [](const Comparison& c) { return c.what == "a(1)"; }));
  EXPECT_TRUE(transport_of(make_system(LOBER_TEST_LIBRARIES "/leaky.so", {{"c", 0}}), 2, 1e-5).agreement.agrees());
}

// Two curves are enough: as far as they reach, the same numbers as from the map.
TEST(Transport, OfCurvesAlone) {
  const Transport found = transport_of(make_system("henon", {{"k", 0.5}}), 5, 1e-5);
  const ManifoldTangle& manifolds = found.manifolds();
  TangleOptions options;
  options.smooth = true;
  options.bip_near = manifolds.orbits.back().at;
  options.check_simple = false;  // far outside they are followed coarsely
  const Tangle alone = tangle(manifolds.u, manifolds.s, options);
  ASSERT_EQ(alone.images.period, 2U);  // inferred from the areas
  const TransportOfCurves curves = transport(alone, 100);
  EXPECT_TRUE(curves.agreement.agrees());
  ASSERT_GE(curves.steps.size(), found.steps.size());
  for (std::size_t k = 0; k < found.steps.size(); ++k) {
    EXPECT_NEAR(curves.steps[k].total(0, 1).value, found.steps[k].total(0, 1).value, 1e-8);
    EXPECT_NEAR(curves.steps[k].by_boundaries(0, 1).value, found.steps[k].by_boundaries(0, 1).value, 1e-4);
  }
  EXPECT_LT(curves.steps.size(), 100U);
}

TEST(Transport, SameBitsForAnyNumberOfThreads) {
  const System system = make_system("standard", {{"K", 2.0}});
  const auto run = [&](int threads) { return with_threads(threads, [&] { return transport_of(system, 4, 1e-4); }); };
  const Transport one = run(1);
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  for (const int threads : {2, 7}) {
    const Transport other = run(threads);
    for (std::size_t k = 0; k < one.steps.size(); ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          EXPECT_EQ(bits(one.steps[k].total(i, j).value), bits(other.steps[k].total(i, j).value));
          EXPECT_EQ(bits(one.steps[k].by_boundaries(i, j).value), bits(other.steps[k].by_boundaries(i, j).value));
        }
      }
    }
  }
}

// Of the forced oscillators, whose saddles move with the force, against Melnikov's method: the area between two zeros
// of its integral over the unperturbed separatrix, for small eps.
TEST(TangleOfMap, LobesOfForcedOscillators) {
  const double pi = std::numbers::pi;
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
  few.most_iterates = 2;
  few.before = few.after = 6;
  EXPECT_THROW((void)grow_tangle(*system.map, *system.connection, few), DataError);
  ManifoldTangleOptions small;
  small.before = small.after = 8;
  small.most_points = 5000;
  EXPECT_THROW((void)grow_tangle(*system.map, *system.connection, small), DataError);
  EXPECT_THROW((void)grow_tangle(*system.map, *system.connection, {.before = 0}), UsageError);
  TransportOptions none;
  none.iterates = 0;
  EXPECT_THROW((void)transport(*system.map, *system.connection, none), UsageError);
}

// ------------------------------------------------------------------------------------------ what is refused

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const DataError& error) {
    return error.what();
  }
  return "nothing was refused";
}

// Lobes that reach far outside, where manifolds are followed coarsely, had the sign of that noise: whole lobes were
// added to their overlaps.
TEST(Transport, OfLobesThatReachFarOutside) {
  const System system = make_system("henon", {{"k", 10.0}});
  TransportOptions options;
  options.iterates = 8;
  const Transport found = transport(*system.map, *system.connection, options);
  EXPECT_TRUE(found.agreement.agrees());
  ASSERT_EQ(found.steps.size(), 8U);
  const Measured total = found.steps.back().total(0, 1), boundaries = found.steps.back().by_boundaries(0, 1);
  EXPECT_NEAR(total.value, boundaries.value, 1e-5);
  EXPECT_LT(total.error, 1e-3);
  const ManifoldTangle& manifolds = found.manifolds();
  for (std::size_t k = 0; k < manifolds.tangle.lobes.size(); ++k) {
    const Lobe& lobe = manifolds.tangle.lobes[k];
    EXPECT_LE(std::fabs(std::fabs(lobe.area) - std::fabs(manifolds.areas_by_action[0])), lobe.smooth_error + 1e-12)
        << k;
    EXPECT_TRUE(k == 0 || (lobe.area > 0) != (manifolds.tangle.lobes[k - 1].area > 0)) << k;
  }
}

// Without the lattice of the plane nothing says that fluid crosses the line from saddle to saddle.
TEST(Transport, RefusesAClosureThatTheMapDoesNotKeep) {
  for (const char* name : {"standard", "pendulum"}) {
    const System system = make_system(name, {});
    const std::string text = refusal([&] { (void)transport(*system.map, *system.connection); });
    EXPECT_NE(text.find("by a path that the map does not keep"), std::string::npos) << name << ": " << text;
  }
}

// (x, y) -> (a - b y - x^2, x) with its derivative times `factor` in one place.
class GeneralHenon : public PlanarMap {
 public:
  GeneralHenon(double a, double b, double factor) : a_(a), b_(b), factor_(factor) {}
  void iterate(std::span<Point> points, int iterates) const override {
    for (Point& z : points) {
      for (int n = 0; n < iterates; ++n) z = {a_ - b_ * z.y - z.x * z.x, z.x};
      for (int n = 0; n > iterates; --n) z = {z.y, (a_ - z.y * z.y - z.x) / b_};
    }
  }
  Point iterate_with_derivative(Point z, int iterates, Matrix2& derivative) const override {
    derivative = {};
    for (int n = 0; n != iterates; n += iterates < 0 ? -1 : 1) {
      const Matrix2 a = iterates > 0 ? Matrix2{-2 * factor_ * z.x, -b_, 1, 0} : Matrix2{0, 1, -1 / b_, -2 * z.y / b_};
      derivative = testing::StandardMap::product(a, derivative);
      iterate({&z, 1}, iterates > 0 ? 1 : -1);
    }
    return z;
  }

 private:
  double a_, b_, factor_;
};

TEST(Transport, SaysThatAMapReversesOrientation) {
  const double x = -std::sqrt(3.0);
  const Connection connection{{x, x}, {1, 1}, {x, x}, {1, 1}, std::nullopt};
  const std::string text = refusal([&] { (void)transport(GeneralHenon(3, -1, 1), connection); });
  EXPECT_NE(text.find("reverses orientation"), std::string::npos) << text;
}

TEST(Transport, SaysThatADerivativeDoesNotFit) {
  const Connection connection{{-3, -3}, {1, 1}, {-3, -3}, {1, 1}, std::nullopt};
  const std::string text = refusal([&] { (void)transport(GeneralHenon(3, 1, 1.1), connection); });
  EXPECT_NE(text.find("does not fit its map"), std::string::npos) << text;
}

// There are two homoclinic orbits a period; the place is far from the pips of both that are found first.
TEST(Transport, SaysThatNoPipIsNearThePlace) {
  const Connection connection{{-3, -3}, {1, 1}, {-3, -3}, {1, 1}, std::nullopt};
  TransportOptions options;
  options.iterates = 1;
  options.bip_near = Point{-1.794, 2.567};
  const std::string text = refusal([&] { (void)transport(GeneralHenon(3, 1, 1), connection, options); });
  EXPECT_NE(text.find("pips of one period are"), std::string::npos) << text;
}

TEST(Transport, TakesABudgetOfSeconds) {
  const System system = make_system("duffing", {});
  TransportOptions options;
  options.iterates = 1;
  options.budget = 1000;
  EXPECT_EQ(transport(*system.map, *system.connection, options).steps.size(), 1U);
}

}  // namespace
}  // namespace lober

// Transport against reference values of 110-digit arithmetic (maps) and of quadruple precision (flows).
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
#include "lober/base/error.hpp"
#include "lober/tangle/manifold_tangle.hpp"
#include "lober/transport/transport.hpp"
#include "tests/engine/dynamics/test_maps.hpp"
#include "tests/paths.hpp"
#include "tests/views.hpp"

namespace lober::detail {
namespace {

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
  if (all) options.further = system.further;
  return transport(system, options);
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
  EXPECT_NEAR(found.boundaries[0].flux12.value, lobe, 1e-12);
  EXPECT_NEAR(found.boundaries[0].lobe_area12_by_action, lobe, 1e-14);
  EXPECT_NEAR(found.boundaries[0].lobe_area21_by_action, lobe, 1e-14);
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
  const TransportBoundary& boundary = found.boundaries[0];
  EXPECT_NEAR(boundary.lobe_area12.value, boundary.lobe_area12_by_action, boundary.lobe_area12.error);
  EXPECT_NEAR(boundary.lobe_area12.value, 0.0032726683590, 1e-7);
  EXPECT_NEAR(boundary.flux12.value, 0.0022293293569, boundary.flux12.error);
  EXPECT_EQ(boundary.flux12.value, found.steps[0].flux(0, 1).value);
  ASSERT_FALSE(found.remarks.empty());
  EXPECT_NE(found.remarks.back().find("lobes of the turnstile overlap"), std::string::npos) << found.remarks.back();
}

// The lobes that overlap are those of the left well, R3.
TEST(Transport, RemarksNameTheRegionThatIsLeft) {
  const Transport found = transport_of(make_system("duffing"), 1, 1e-5, true);
  ASSERT_EQ(found.regions.size(), 3U);
  ASSERT_FALSE(found.remarks.empty());
  const TransportBoundary& left = found.boundaries[1];
  ASSERT_GT(left.lobe_area12.value, left.flux12.value + 1e-3);
  EXPECT_NE(found.remarks.back().find(" leaves R3 in one iterate"), std::string::npos) << found.remarks.back();
}

// However coarse the polygons that are asked for: error bars hold, because manifolds are grown finer until they do.
TEST(Transport, CoarseTolerances) {
  for (const char* const name : {"ovp", "pendulum", "pcr3bp", "henon"}) {
    for (const double tolerance : {0.3, 0.1, 0.03}) {
      SCOPED_TRACE(name + std::string(" ") + std::to_string(tolerance));
      expect_agreement(transport_of(make_system(name), 3, tolerance));
    }
  }
}

// The boundary turns so little at its pip that arcs are fitted across it: 1.3e-7 off, with a bar of 1.1e-7.
TEST(Transport, BarsCountACornerThatArcsRound) {
  expect_agreement(transport_of(make_system("henon", {{"k", -0.810779}}), 3, 1e-5));
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
    const Measured out = step.by_boundaries(0, 1), in = step.by_boundaries(2, 0);
    EXPECT_NEAR(out.value, in.value, out.error + in.error);
    EXPECT_LT(out.error + in.error, 1e-4);
    EXPECT_NEAR(out.value, step.total(0, 1).value, 1e-5);
  }
}

// From nearly integrable to lobes of hundreds of cells, of which overlaps are sums over as many translates. Each within
// its own share of work; what it took before this test was written: no answer in 150 s for K = 0.15, 0.2 and 10.7.
TEST(Transport, CylinderForEveryK) {
  for (const auto& [K, iterates] :
       {std::pair{0.14, 2}, {0.2, 7}, {1.0, 7}, {6.5, 4}, {10.7, 3}, {50.0, 1}, {500.0, 1}}) {
    SCOPED_TRACE(K);
    const Transport found = transport_of(make_system("standard", {{"K", K}}), iterates, 1e-5);
    expect_agreement(found);
    ASSERT_EQ(found.steps.size(), static_cast<std::size_t>(iterates));
    for (const TransportStep& step : found.steps) {
      // The rotation by half a turn exchanges above and below, and species keep their area.
      const Measured up = step.total(0, 1), down = step.total(0, 2), stays = step.total(0, 0);
      EXPECT_NEAR(up.value, down.value, up.error + down.error);
      EXPECT_NEAR(up.value + down.value + stays.value, found.regions[0].area.value,
                  up.error + down.error + stays.error + found.regions[0].area.error);
    }
    const TransportBoundary& boundary = found.boundaries[0];
    EXPECT_NEAR(boundary.lobe_area12.value, boundary.lobe_area12_by_action, boundary.lobe_area12.error);
  }
}

// More than is done unasked ends the table, with the reason.
TEST(Transport, RowsOfACylinderEndWithTheWork) {
  TransportOptions options;
  const System system = make_system("standard", {{"K", 25.0}});
  options.lattice = system.lattice;
  options.further = system.further;
  options.iterates = 9;
  options.max_work = 1e6;
  const Transport found = transport(*system.map, *system.connection, options);
  EXPECT_LT(found.steps.size(), 9U);
  EXPECT_GE(found.steps.size(), 1U);
  ASSERT_FALSE(found.remarks.empty());
  EXPECT_NE(found.remarks[0].find("a limit of seconds allows more"), std::string::npos) << found.remarks[0];
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

// Two pips of a period are mirror images of each other, as far from one saddle as the other one is from the other
// saddle: neither is nearer to halfway, whatever the tolerance.
TEST(Transport, BipOfAMirroredTangleDoesNotDependOnTheTolerance) {
  for (const double eps : {0.1, 0.24}) {
    const System system = make_system("double-gyre", {{"eps", eps}});
    std::vector<Point> bips;
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6}) {
      ManifoldTangleOptions options;
      options.tolerance = tolerance;
      const std::unique_ptr<ManifoldTangle> found = grow_tangle(*system.map, *system.connection, options);
      bips.push_back(found->tangle.pips[found->bip].at);
      EXPECT_NEAR(bips.back().x, bips.front().x, 1e-6) << tolerance;
      EXPECT_NEAR(bips.back().y, bips.front().y, 1e-6) << tolerance;
    }
  }
}

// With A < 0 the gyres are their own mirror images. The pip found there first is so near to the saddle, after an
// iterate that stretches by 2e4, that S has errors as large as that distance.
TEST(Transport, GyresThatTurnTheOtherWay) {
  for (const double amplitude : {0.1, -0.1, -0.09, -0.11}) {
    SCOPED_TRACE(amplitude);
    const Transport found = transport_of(make_system("double-gyre", {{"A", amplitude}}), 1, 1e-4);
    expect_agreement(found);
    if (std::fabs(amplitude) == 0.1) {
      EXPECT_NEAR(found.boundaries[0].lobe_area12_by_action, 0.1290189717084, 1e-11);
    }
  }
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
  EXPECT_EQ(curves.remarks, alone.remarks);
}

// Curves alone do not show whether the map keeps the straight line between two saddles, nor that the plane repeats
// itself.
TEST(Transport, OfCurvesFromTwoSaddlesSaysWhatIsAssumed) {
  const Transport found = transport_of(make_system("standard", {{"K", 1.2}}), 1, 1e-5);
  const ManifoldTangle& manifolds = found.manifolds();
  TangleOptions options;
  options.smooth = true;
  options.bip_near = manifolds.orbits.back().at;
  const TransportOfCurves curves = transport(tangle(manifolds.u, manifolds.s, options), 1);
  ASSERT_FALSE(curves.remarks.empty());
  EXPECT_NE(curves.remarks.back().find("which the map is taken to keep"), std::string::npos) << curves.remarks.back();
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

}  // namespace
}  // namespace lober::detail

// The table of escape against reference values: fractions from curves
// of another program and 1.2e8 trajectories.
#include "lober/transport/escape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/transport/monte_carlo.hpp"

namespace lober::detail {
namespace {

constexpr double ship_energy = 0.25307;
constexpr std::array<double, 9> known{
    0, 0, 0, 0, 0.111522124886, 0.029905210198, 0.001081405359, 0.003073452366, 0.009601023222};

const System& ship() {
  static const System system = make_system("capsize");
  return system;
}

Escape table(double tolerance, int crossings, double integration = 1e-13) {
  EscapeOptions options;
  options.tolerance = tolerance;
  options.crossings = crossings;
  options.integration.tolerance = integration;
  return escape(*ship().flow, *ship().section, ship_energy, ship().saddles, options);
}

// Coarse, but good enough for the nine digits asked for.
const Escape& coarse() {
  static const Escape result = table(1e-5, 4);
  return result;
}

// The m of F_m by entry, exit and n: enter left, exit right after n crossings is m = 2n - 2, and so on.
int expected_iterates(const EscapeFraction& row) {
  if (row.entry == 0) return row.exit == 1 ? 2 * row.crossings - 2 : 2 * row.crossings - 1;
  return row.exit == 0 ? 2 * row.crossings : 2 * row.crossings - 1;
}

void check_areas() {
  for (const Bottleneck& bottleneck : coarse().bottlenecks) {
    EXPECT_EQ(bottleneck.entry.size(), 5U);
    EXPECT_EQ(bottleneck.exit.size(), 5U);
    EXPECT_LT(bottleneck.area_defect, 1e-6);
    for (const auto* curves : {&bottleneck.entry, &bottleneck.exit}) {
      for (const TubeCurve& curve : *curves) {
        EXPECT_LE(std::fabs(curve.area - bottleneck.area), curve.area_error + bottleneck.area_error);
      }
    }
  }
}

void check_values() {
  const Escape& result = coarse();
  ASSERT_EQ(result.table.size(), 16U);
  for (const EscapeFraction& row : result.table) {
    SCOPED_TRACE(row.iterates);
    EXPECT_EQ(row.iterates, expected_iterates(row));
    ASSERT_TRUE(row.is_known());
    EXPECT_NEAR(row.fraction, known[static_cast<std::size_t>(row.iterates)], 1e-9);
    EXPECT_LE(std::fabs(row.fraction - known[static_cast<std::size_t>(row.iterates)]), row.error + 1e-12);
    EXPECT_LT(row.error, 1e-7);
  }
}

void check_splits() {
  int compared = 0;
  for (const EscapeFraction& row : coarse().table) {
    if (!(row.other == row.other)) continue;
    EXPECT_NE(row.forward, row.other_forward);
    EXPECT_NEAR(row.fraction, row.other, 1e-9);
    ++compared;
  }
  EXPECT_EQ(compared, 14);  // all but m = 0 and m = 8
  EXPECT_LT(coarse().largest_split_difference, 1e-9);
}

void check_symmetry() {
  // (x, vx) -> (-x, -vx) exchanges left and right; nothing in the engine knows.
  for (const EscapeFraction& a : coarse().table) {
    for (const EscapeFraction& b : coarse().table) {
      if (a.iterates != b.iterates) continue;
      EXPECT_NEAR(a.fraction, b.fraction, a.error + b.error + 1e-14);
    }
  }
}

void check_survival() {
  for (std::size_t entry = 0; entry < 2; ++entry) {
    const auto steps = survival(coarse(), entry);
    ASSERT_EQ(steps.size(), 4U);
    const int last = entry == 0 ? 7 : 8;
    const double gone = std::accumulate(known.begin(), known.begin() + last + 1, 0.0);
    EXPECT_NEAR(steps.back().remains, 1 - gone, 1e-8);
    EXPECT_EQ(steps.front().remains, 1);
    for (const Survival& step : steps) EXPECT_NEAR(step.left[0] + step.left[1] + step.remains, 1, 1e-15);
  }
}

void check_trajectories() {
  MonteCarloOptions options;
  options.trajectories = 10000;
  const MonteCarlo two = with_threads(2, [&] { return monte_carlo(*ship().flow, coarse(), options); });
  EXPECT_EQ(two.lost, 0U);
  EXPECT_LE(two.largest_deviation, 3.0);
  options.trajectories = 3000;
  const auto counts = [&](int threads) {
    std::vector<std::uint64_t> list;
    const MonteCarlo result = with_threads(threads, [&] { return monte_carlo(*ship().flow, coarse(), options); });
    for (const MonteCarloFraction& row : result.table) list.push_back(row.count);
    return list;
  };
  const auto one = counts(1);
  EXPECT_EQ(one, counts(3));
  options.seed = 2;
  EXPECT_NE(one, counts(1));
}

// One test, because each one is a process of its own and all need the same table.
TEST(Escape, TableOfTheShip) {
  check_areas();
  check_values();
  check_splits();
  check_symmetry();
  check_survival();
  check_trajectories();
}

TEST(Escape, GoesOnWhereImagesAreCut) {
  EscapeOptions options;
  options.tolerance = 3e-5;
  options.crossings = 5;
  const Escape result = escape(*ship().flow, *ship().section, ship_energy, ship().saddles, options);
  ASSERT_EQ(result.table.size(), 20U);
  int cut = 0;
  for (const EscapeFraction& row : result.table) {
    SCOPED_TRACE(row.iterates);
    ASSERT_TRUE(row.is_known());
    EXPECT_EQ(row.cut, row.iterates > 8);
    if (!row.cut) continue;
    ++cut;
    // The results of the program at ten times the resolution; splits and the mirror image agree with it to the error
    // bars.
    EXPECT_NEAR(row.fraction, row.iterates == 9 ? 0.0124649 : 0.0081919, row.error);
    EXPECT_LT(row.error, 1e-4);
    if (!(row.other == row.other)) continue;
    EXPECT_NEAR(row.fraction, row.other, 2 * row.error);
  }
  EXPECT_EQ(cut, 3);
  // A cut image holds all that has not left.
  for (const Bottleneck& bottleneck : result.bottlenecks) {
    for (const auto* curves : {&bottleneck.entry, &bottleneck.exit}) {
      ASSERT_EQ(curves->size(), 6U);
      EXPECT_TRUE(curves->back().cut);
      EXPECT_NEAR(std::fabs(signed_area(curves->back().image)), bottleneck.area * (1 - known[4]),
                  1e-3 * bottleneck.area);
    }
  }
}

// Every second vertex of coarse curves may by chance give the same area as all: the other half of them tells.
TEST(Escape, BarsCoverWhatOneHalfOfTheVerticesHides) {
  EscapeOptions options;
  options.tolerance = 1e-3;
  options.crossings = 6;
  const Escape result = escape(*ship().flow, *ship().section, 0.265, ship().saddles, options);
  EXPECT_EQ(result.crossings, 6);
  EXPECT_TRUE(result.agreement.agrees());
}

// A quarter of what enters by the second bottleneck leaves by the first against the direction that counts.
TEST(Escape, CountsWhatLeavesBeforeTheFirstCrossing) {
  EscapeOptions options;
  options.crossings = 1;
  const Escape result = escape(*ship().flow, *ship().section, 0.4, ship().saddles, options);
  ASSERT_EQ(result.table.size(), 5U);
  const EscapeFraction& row = result.table[2];
  EXPECT_EQ(row.crossings, 0);
  EXPECT_EQ(row.iterates, 0);
  EXPECT_EQ(row.entry, 1U);
  EXPECT_EQ(row.exit, 0U);
  EXPECT_NEAR(row.fraction, result.table[1].fraction, row.error + result.table[1].error);  // the mirror image
  double left = 0;
  for (std::size_t k = 2; k < 5; ++k) left += result.table[k].fraction;
  EXPECT_NEAR(survival(result, 1).at(0).remains, 1 - left, 1e-15);
  EXPECT_TRUE(result.agreement.agrees());
  // At the ship's own energy nothing does.
  EXPECT_EQ(escape(*ship().flow, *ship().section, ship_energy, ship().saddles, options).table.size(), 4U);
}

// The section off the middle is tangent to trajectories, and tears images; splits agree, as both are of such curves.
TEST(Escape, SaysWhereTheSectionTearsImages) {
  EscapeOptions options;
  options.crossings = 2;
  for (const double x : {0.12, 0.15, -0.15}) {
    const Section section = position_section(*ship().flow, 0, x, 1);
    const Escape result = escape(*ship().flow, section, 0.26, ship().saddles, options);
    const std::vector<Comparison> disagreements = result.agreement.disagreements();
    EXPECT_TRUE(std::any_of(disagreements.begin(), disagreements.end(), [](const Comparison& comparison) {
      return comparison.what.find("cut image 2") != std::string::npos;
    })) << x;
  }
}

// Twice cut curves have jumps where they wind about an orbit; energies at which half of the table is made of them.
TEST(Escape, BarsCoverWhatJumpsMiss) {
  for (const double at : {0.32, 0.35, 0.4, 0.5}) {
    EscapeOptions options;
    options.crossings = 2;
    options.tolerance = at == 0.35 ? 1e-5 : 1e-4;
    const Escape result = escape(*ship().flow, *ship().section, at, ship().saddles, options);
    EXPECT_EQ(result.crossings, 2) << at;
    EXPECT_TRUE(result.agreement.agrees()) << at;
    EXPECT_GT(result.agreement.comparisons.size(), 20U);
  }
}

TEST(Escape, FindsTheTangency) {
  // F_6 is born at energy 0.252962.
  for (const bool above : {false, true}) {
    EscapeOptions options;
    options.tolerance = 1e-5;
    options.crossings = 3;
    const Escape result = escape(*ship().flow, *ship().section, above ? 0.252965 : 0.252959, ship().saddles, options);
    for (const EscapeFraction& row : result.table) {
      if (row.iterates != 6) continue;
      EXPECT_EQ(row.fraction > 0, above);
    }
  }
}

TEST(Escape, EndsBeforeTheNextImageIsTooMuch) {
  EscapeOptions options;
  options.tolerance = 1e-5;
  options.crossings = 30;
  options.max_points = 3000;
  const Escape result = escape(*ship().flow, *ship().section, ship_energy, ship().saddles, options);
  EXPECT_EQ(result.stop, EscapeStop::points);
  EXPECT_GE(result.crossings, 1);
  EXPECT_LT(result.crossings, 30);
  EXPECT_GT(result.points_ahead, 3000);
  EXPECT_EQ(result.table.size(), 4U * static_cast<std::size_t>(result.crossings));
  for (const EscapeFraction& row : result.table) {
    EXPECT_TRUE(row.is_known());
    EXPECT_NEAR(row.fraction, known[static_cast<std::size_t>(row.iterates)], 1e-8);
  }
  options.max_points = 1'000'000;
  options.max_work = 1000;
  const Escape worked = escape(*ship().flow, *ship().section, ship_energy, ship().saddles, options);
  EXPECT_EQ(worked.stop, EscapeStop::work);
  EXPECT_GT(worked.work_spent + worked.work_ahead, 1000);
  options.budget = 1e-9;
  const Escape none = escape(*ship().flow, *ship().section, ship_energy, ship().saddles, options);
  EXPECT_EQ(none.stop, EscapeStop::budget);
  EXPECT_EQ(none.crossings, 0);
  EXPECT_TRUE(none.table.empty());
  EXPECT_EQ(none.bottlenecks.size(), 2U);
}

// Barely above the saddle trajectories take so long past it that a crossing of the section costs three hundred others.
TEST(Escape, WorkIsCountedInEvaluationsOfTheField) {
  const System steep = make_system("capsize", {{"R", 3}});
  EscapeOptions options;
  options.tolerance = 1e-4;
  options.crossings = 2;
  options.max_work = 3e7;
  const Escape result = escape(*steep.flow, *steep.section, ship_energy, steep.saddles, options);
  EXPECT_EQ(result.stop, EscapeStop::work);
  EXPECT_LT(result.work_spent, 2 * options.max_work);
  EXPECT_GT(result.work_spent, 1e6);
}

TEST(Escape, RowsComeOneByOneAndOutliveAnInterrupt) {
  EscapeOptions options;
  options.tolerance = 1e-4;
  options.crossings = 4;
  std::vector<int> reported;
  options.rows_known = [&](const Escape& so_far, int n) {
    reported.push_back(n);
    EXPECT_EQ(so_far.crossings, n);
    EXPECT_EQ(so_far.table.size(), 4U * static_cast<std::size_t>(n));
    EXPECT_EQ(so_far.bottlenecks.size(), 2U);
  };
  options.progress = [&](double) { return reported.size() < 2; };  // while the third images are made
  const Escape result = escape(*ship().flow, *ship().section, ship_energy, ship().saddles, options);
  EXPECT_EQ(reported, (std::vector<int>{1, 2}));
  EXPECT_EQ(result.stop, EscapeStop::cancelled);
  EXPECT_EQ(result.crossings, 2);
  EXPECT_EQ(result.table.size(), 8U);
  EXPECT_EQ(survival(result, 0).size(), 2U);
  options.progress = [](double) { return false; };
  EXPECT_THROW((void)escape(*ship().flow, *ship().section, ship_energy, ship().saddles, options), Cancelled);
}

// A flow whose integral of p dq is wrong by one part in a hundred million.
class WrongAction final : public Flow {
 public:
  explicit WrongAction(const Flow& flow) : flow_(flow) {}
  [[nodiscard]] int dimension() const override { return flow_.dimension(); }
  [[nodiscard]] double period() const override { return flow_.period(); }
  [[nodiscard]] FlowState velocity(const FlowState& x, double t) const override { return flow_.velocity(x, t); }
  [[nodiscard]] FlowMatrix jacobian(const FlowState& x, double t) const override { return flow_.jacobian(x, t); }
  [[nodiscard]] std::span<const ConjugatePair> conjugate_pairs() const override { return flow_.conjugate_pairs(); }
  [[nodiscard]] double hamiltonian(const FlowState& x, double t) const override { return flow_.hamiltonian(x, t); }
  void integrate(std::span<FlowState> states, double from, double to, const IntegrationOptions& o) const override {
    flow_.integrate(states, from, to, o);
  }
  FlowState integrate_with_derivative(const FlowState& x, double from, double to, FlowMatrix& derivative,
                                      const IntegrationOptions& o) const override {
    return flow_.integrate_with_derivative(x, from, to, derivative, o);
  }
  FlowState integrate_with_action(const FlowState& x, double from, double to, double& action,
                                  const IntegrationOptions& o) const override {
    const FlowState end = flow_.integrate_with_action(x, from, to, action, o);
    action *= 1 + 1e-8;
    return end;
  }
  std::uint64_t to_section(std::span<FlowState> states, std::span<double> times, const Section& section, int crossings,
                           const IntegrationOptions& o) const override {
    return flow_.to_section(states, times, section, crossings, o);
  }
  [[nodiscard]] std::unique_ptr<PlanarMap> stroboscopic_map(double phase, const IntegrationOptions& o) const override {
    return flow_.stroboscopic_map(phase, o);
  }
  [[nodiscard]] std::unique_ptr<PlanarMap> section_map(const Section& section, double at,
                                                       const IntegrationOptions& o) const override {
    return flow_.section_map(section, at, o);
  }
  [[nodiscard]] FlowState on_section(const Section& section, double at, Point point) const override {
    return flow_.on_section(section, at, point);
  }

 private:
  const Flow& flow_;
};

TEST(Escape, SaysWhenTwoRoutesDisagree) {
  EscapeOptions options;
  options.crossings = 2;
  options.tolerance = 1e-5;
  const Escape right = escape(*ship().flow, *ship().section, ship_energy, ship().saddles, options);
  int splits = 0, areas = 0, mirrored = 0, reversed = 0;
  for (const Comparison& comparison : right.agreement.comparisons) {
    EXPECT_TRUE(comparison.agrees()) << comparison.what << ' ' << comparison.difference() << ' ' << comparison.bar;
    splits += comparison.first_by.starts_with("split") ? 1 : 0;
    areas += comparison.second_by == "action" ? 1 : 0;
    mirrored += comparison.second_by.starts_with("symmetry") ? 1 : 0;
    reversed += comparison.second_by.starts_with("time reversal") ? 1 : 0;
  }
  EXPECT_GT(splits, 0);
  EXPECT_GE(areas, 12);
  EXPECT_GT(mirrored, 0);
  EXPECT_GT(reversed, 0);
  const Escape wrong = escape(WrongAction(*ship().flow), *ship().section, ship_energy, ship().saddles, options);
  EXPECT_FALSE(wrong.agreement.agrees());
}

TEST(Escape, ComparesTrajectoriesWithCurves) {
  const Escape& result = coarse();
  MonteCarloOptions options;
  options.trajectories = 5000;
  MonteCarlo counted = monte_carlo(*ship().flow, result, options);
  Agreement agreement;
  compare(result, counted, agreement);
  EXPECT_EQ(agreement.comparisons.size(), result.table.size());
  EXPECT_TRUE(agreement.agrees());
  for (MonteCarloFraction& row : counted.table) row.fraction += 0.02;
  compare(result, counted, agreement);
  EXPECT_FALSE(agreement.agrees());
}

TEST(Escape, SameBitsForAnyNumberOfThreads) {
  const auto of = [](int threads) { return with_threads(threads, [] { return table(1e-3, 2); }); };
  const Escape one = of(1);
  for (const int threads : {2, 5}) {
    const Escape other = of(threads);
    for (std::size_t k = 0; k < one.table.size(); ++k) EXPECT_EQ(one.table[k].fraction, other.table[k].fraction);
    for (std::size_t k = 0; k < 2; ++k) {
      ASSERT_EQ(one.bottlenecks[k].entry.size(), other.bottlenecks[k].entry.size());
      for (std::size_t j = 0; j < one.bottlenecks[k].entry.size(); ++j) {
        EXPECT_EQ(one.bottlenecks[k].entry[j].image.points, other.bottlenecks[k].entry[j].image.points);
      }
    }
  }
}

TEST(Escape, SaysWhatIsWrong) {
  const Flow& flow = *ship().flow;
  const auto attempt = [&](const Section& section, double at, std::span<const FlowState> saddles) {
    (void)escape(flow, section, at, saddles, {});
  };
  Section section = *ship().section;
  EXPECT_THROW(attempt(section, 0.2, ship().saddles), UsageError);
  EXPECT_THROW(attempt(section, ship_energy, {}), UsageError);
  EXPECT_THROW(attempt(section, ship_energy, std::vector<FlowState>{ship().saddles[0], ship().saddles[0]}), UsageError);
  section.direction = 0;
  EXPECT_THROW(attempt(section, ship_energy, ship().saddles), UsageError);
  section = *ship().section;
  section.coordinate = 2;
  EXPECT_THROW(attempt(section, ship_energy, ship().saddles), UsageError);
}

}  // namespace
}  // namespace lober::detail

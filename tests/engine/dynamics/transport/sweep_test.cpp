#include "lober/transport/sweep.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#include "lober/base/error.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/transport/transport.hpp"

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

// A zero of size 0 has no tolerance of its own size.
TEST(Sweep, ZeroAtZeroHasTheBarOfItsInterval) {
  const auto moved = [](double value) { return vortex_pair(1.40676409 + value); };
  SweepOptions options;
  options.tangle.tolerance = 1e-3;
  options.find_zeros = true;
  const Sweep found = sweep(moved, std::array{-0.03, 0.02}, options);
  ASSERT_EQ(found.zeros.size(), 1U);
  EXPECT_NEAR(found.zeros[0].value, 0, 1e-8);
  EXPECT_GE(found.zeros[0].width, 1e-17);
  EXPECT_LE(found.zeros[0].width, 1e-10);
}

// Newton's method converges to another pip where a step is too large: the flux of the standard map at K = 10 was 12.40
// after K = 5, and the difference had changed its sign.
TEST(Sweep, FollowsOnePipOverLargeSteps) {
  SweepOptions options;
  options.tangle.tolerance = 1e-3;
  const auto standard = [](double K) {
    const System system = make_system("standard", {{"K", K}});
    return FamilyMember{system.map, *system.connection, system.lattice};
  };
  const std::array values{5.0, 10.0};
  const Sweep coarse = sweep(standard, values, options);
  const std::array steps{5.0, 6.0, 7.0, 8.0, 9.0, 10.0};
  const Sweep fine = sweep(standard, steps, options);
  ASSERT_EQ(coarse.failures() + fine.failures(), 0U);
  EXPECT_TRUE(coarse.zeros.empty());
  EXPECT_TRUE(fine.zeros.empty());
  EXPECT_NEAR(coarse.rows[1].flux21.value, fine.rows[5].flux21.value, 1e-5);
  EXPECT_NEAR(coarse.rows[1].flux21.value, 10.360804, 1e-5);
  EXPECT_EQ(coarse.rows[1].difference > 0, fine.rows[5].difference > 0);
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

// One definition: what a sweep calls the flux is a(1) of transport, also where lobes of the turnstile overlap, on a
// cylinder, and where more boundaries bound R1.
TEST(Sweep, FluxIsThatOfTransport) {
  for (const char* const name : {"pcr3bp", "standard", "ovp", "double-gyre"}) {
    const System system = make_system(name);
    TransportOptions one;
    one.iterates = 1;
    one.lattice = system.lattice;
    const Transport direct = transport(*system.map, *system.connection, one);
    const Sweep swept = sweep(
        [&](double) -> FamilyMember {
          return {system.map, *system.connection, system.lattice};
        },
        std::array{1.0});
    const SweepRow& row = swept.rows[0];
    ASSERT_EQ(row.failure + row.remark, "") << name;
    const TransportBoundary& boundary = direct.boundaries[0];
    EXPECT_NEAR(row.flux12.value, boundary.flux12.value, row.flux12.error + boundary.flux12.error) << name;
    EXPECT_NEAR(row.flux21.value, boundary.flux21.value, row.flux21.error + boundary.flux21.error) << name;
    EXPECT_LT(row.flux21.error, 1e-4 * row.flux21.value) << name;
    EXPECT_NEAR(row.lobe_area12.value, row.lobe_area12_by_action, row.lobe_area12.error) << name;
  }
}

// A tangle by itself takes now one pip as the bip and now another: W(q) - W(q') jumped, and was said to have zeros.
TEST(Sweep, FollowsOnePip) {
  for (const char* const name : {"duffing", "double-gyre"}) {
    const Family family = [&](double eps) -> FamilyMember {
      const System system = make_system(name, {{"eps", eps}});
      return {system.map, *system.connection, system.lattice};
    };
    std::vector<double> values;
    for (int k = 0; k <= 10; ++k) values.push_back(0.1 + 0.01 * k);
    const Sweep found = sweep(family, values);
    ASSERT_EQ(found.failures(), 0U);
    EXPECT_TRUE(found.zeros.empty()) << name;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const SweepRow& row = found.rows[k];
      ASSERT_EQ(row.remark, "");
      const double last = k == 0 ? 0 : std::fabs(found.rows[k - 1].difference);
      EXPECT_GT(std::fabs(row.difference), last) << name << " at " << values[k];
      EXPECT_NEAR(row.lobe_area21.value, row.lobe_area21_by_action, row.lobe_area21.error) << name;
      // The tangle of that value by itself, whichever pip it takes.
      const auto alone = grow_tangle(*family(values[k]).map, family(values[k]).connection);
      EXPECT_NEAR(std::fabs(alone->areas_by_action[0]), std::fabs(row.difference), 1e-11)
          << name << " at " << values[k];
    }
  }
}

// The periodic orbit moves on with the energy, away from where it is guessed: alone, -1.52 finds a centre.
TEST(Sweep, FollowsTheSaddle) {
  const Connection guess = *make_system("pcr3bp").connection;
  const Family family = [&](double energy) -> FamilyMember {
    const System system = make_system("pcr3bp", {{"energy", energy}});
    return {system.map, guess, system.lattice};
  };
  EXPECT_THROW((void)grow_tangle(*family(-1.52).map, family(-1.52).connection), DataError);
  const std::array values{-1.53, -1.528, -1.526, -1.524, -1.522, -1.52};
  const std::array backwards{-1.52, -1.522, -1.524, -1.526, -1.528, -1.53};
  const Sweep there = sweep(family, values), back = sweep(family, backwards);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const SweepRow &row = there.rows[k], &other = back.rows[values.size() - 1 - k];
    ASSERT_EQ(row.failure, "") << values[k];
    ASSERT_EQ(other.failure, "") << values[k];
    EXPECT_NEAR(row.from.x, other.from.x, 1e-9);
    EXPECT_NEAR(row.lobe_area21.value, row.lobe_area21_by_action, row.lobe_area21.error);
    EXPECT_NEAR(row.lobe_area21_by_action, other.lobe_area21_by_action, 1e-9);
    if (k > 0) {
      EXPECT_GT(row.multiplier, there.rows[k - 1].multiplier);
    }
  }
}

// Values are worked out from nothing at 0, 32, ... and where none can be continued: there too a turnstile that is not
// that of the value before is not said to be, wherever the jump is.
TEST(Sweep, DoesNotFollowAcrossAJump) {
  for (const int jump : {3, 8, 9, 32}) {
    const Family family = [&](double value) -> FamilyMember {
      const System system = make_system(value < jump - 0.5 ? "duffing" : "henon");
      return {system.map, *system.connection, system.lattice};
    };
    std::vector<double> values;
    for (int k = 0; k < (jump < 11 ? 11 : 34); ++k) values.push_back(k);
    const Sweep found = sweep(family, values);
    ASSERT_EQ(found.failures(), 0U);
    for (int k = 0; k < static_cast<int>(values.size()); ++k) {
      EXPECT_EQ(found.rows[static_cast<std::size_t>(k)].follows, k != 0 && k != jump) << k << " of " << jump;
    }
  }
}

// Counts points that are mapped; those with derivatives count three.
class CountingMap final : public PlanarMap {
 public:
  CountingMap(std::shared_ptr<const PlanarMap> map, std::atomic<std::size_t>& count)
      : map_(std::move(map)), count_(count) {}
  void iterate(std::span<Point> points, int iterates) const override {
    add(points.size(), iterates);
    map_->iterate(points, iterates);
  }
  Point iterate_with_derivative(Point point, int iterates, Matrix2& derivative) const override {
    add(3, iterates);
    return map_->iterate_with_derivative(point, iterates, derivative);
  }
  std::optional<long double> action(Point from, Point to) const override { return map_->action(from, to); }
  double action_accuracy() const override { return map_->action_accuracy(); }

 private:
  void add(std::size_t points, int iterates) const { count_ += points * static_cast<std::size_t>(std::abs(iterates)); }
  std::shared_ptr<const PlanarMap> map_;
  std::atomic<std::size_t>& count_;
};

TEST(Sweep, TakesAThirdOfTheEvaluationsOfSingleValues) {
  struct Scene {
    const char *system, *parameter;
    double first, step;
    int values;
  };
  for (const Scene& scene : {Scene{"standard", "K", 0.9, 0.02, 24}, Scene{"henon", "k", 0.3, 0.02, 16},
                             Scene{"duffing", "eps", 0.1, 0.01, 21}, Scene{"double-gyre", "eps", 0.1, 0.01, 11},
                             Scene{"ovp", "gamma", 1.3, 0.0125, 17}}) {
    std::atomic<std::size_t> count{0};
    const Family family = [&](double value) -> FamilyMember {
      const System system = make_system(scene.system, {{scene.parameter, value}});
      return {std::make_shared<CountingMap>(system.map, count), *system.connection, system.lattice};
    };
    std::vector<double> values;
    for (int k = 0; k < scene.values; ++k) values.push_back(scene.first + scene.step * k);
    const Sweep swept = sweep(family, values);
    EXPECT_EQ(swept.failures(), 0U);
    const std::size_t together = count.exchange(0);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const Sweep single = sweep(family, std::array{values[k]});
      ASSERT_EQ(single.failures(), 0U);
      const SweepRow &row = swept.rows[k], &own = single.rows[0];
      EXPECT_NEAR(row.lobe_area12.value, own.lobe_area12.value, row.lobe_area12.error + own.lobe_area12.error)
          << scene.system << ' ' << values[k];
      EXPECT_NEAR(std::fabs(row.difference), std::fabs(own.difference), 1e-9 * std::fabs(own.difference))
          << scene.system;
    }
    EXPECT_LT(3 * together, count) << scene.system << ' ' << together;
  }
}

// Without area preservation there are lobes and no flux.
TEST(Sweep, SaysWhyThereIsNoFlux) {
  const Sweep swept = sweep(
      [](double delta) -> FamilyMember {
        const System system = make_system("pendulum", {{"delta", delta}});
        return {system.map, *system.connection, system.lattice};
      },
      std::array{1e-3});
  const SweepRow& row = swept.rows[0];
  ASSERT_EQ(row.failure, "");
  EXPECT_TRUE(std::isnan(row.flux21.value));
  EXPECT_NE(row.remark.find("does not preserve area"), std::string::npos) << row.remark;
  EXPECT_GT(row.lobe_area21.value, 0.1);
}

}  // namespace
}  // namespace lober

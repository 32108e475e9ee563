// Transport of maps for which its formulas do not hold, and bips that are not there.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "lober/base/error.hpp"
#include "lober/transport/transport.hpp"
#include "tests/engine/dynamics/test_maps.hpp"
#include "tests/paths.hpp"
#include "tests/refusal.hpp"

namespace lober {
namespace {

using test::refusal;

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
      derivative = test::StandardMap::product(a, derivative);
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
  options.bip_near = Point{-1, 9};
  const std::string text = refusal([&] { (void)transport(GeneralHenon(3, 1, 1), connection, options); });
  EXPECT_NE(text.find("and pips about it are"), std::string::npos) << text;
}

// (q, p) -> (q + L sin p', p'), p' = p - K sin q. In the limit of small K and L the saddles (pi, 0) and (0, pi) have
// the energies L - K and K - L of H = K cos q + L cos p.
class KickedHarper : public PlanarMap {
 public:
  KickedHarper(double k, double l) : k_(k), l_(l) {}
  void iterate(std::span<Point> points, int iterates) const override {
    for (Point& z : points) {
      for (int n = 0; n < iterates; ++n) {
        z.y -= k_ * std::sin(z.x);
        z.x += l_ * std::sin(z.y);
      }
      for (int n = 0; n > iterates; --n) {
        z.x -= l_ * std::sin(z.y);
        z.y += k_ * std::sin(z.x);
      }
    }
  }
  Point iterate_with_derivative(Point z, int iterates, Matrix2& derivative) const override {
    derivative = {};
    for (int n = 0; n != iterates; n += iterates < 0 ? -1 : 1) {
      const Point before = z;
      iterate({&z, 1}, iterates > 0 ? 1 : -1);
      const Point from = iterates > 0 ? before : z, to = iterates > 0 ? z : before;
      const double a = k_ * std::cos(from.x), b = l_ * std::cos(to.y);
      const Matrix2 step = iterates > 0 ? Matrix2{1 - a * b, b, -a, 1} : Matrix2{1, -b, a, 1 - a * b};
      derivative = test::StandardMap::product(step, derivative);
    }
    return z;
  }

 private:
  double k_, l_;
};

// No orbit leads from the one saddle to the other, and more work finds none.
TEST(Transport, SaysThatManifoldsHaveNotCrossed) {
  const double half = std::numbers::pi;
  const Connection connection{{half, 0}, {-1, 1}, {0, half}, {1, -1}, std::nullopt};
  ManifoldTangleOptions options;
  options.max_work = 1.2e5;
  const std::string text = refusal([&] { (void)grow_tangle(KickedHarper(1.6, 0.8), connection, options); });
  EXPECT_NE(text.find("have not crossed"), std::string::npos) << text;
  // With as much of both there is one.
  EXPECT_GE(grow_tangle(KickedHarper(0.8, 0.8), connection, options)->tangle.pips.size(), 2U);
}

// Seconds are no help there, and are not suggested: they were, and ended without a turnstile too.
TEST(Transport, SaysThatOneIterateStretchesTooFar) {
  const System system = make_system("duffing", {{"omega", 0.3}});
  TransportOptions options;
  for (const double budget : {0.0, 20.0}) {
    options.budget = budget;
    const std::string text = refusal([&] { (void)transport(system, options); });
    EXPECT_NE(text.find("one iterate stretches by 1.1e+09"), std::string::npos) << text;
    EXPECT_EQ(text.find("allows more"), std::string::npos) << text;
  }
}

// Rows multiply by ten: without an end at the budget they would go on for days.
TEST(Transport, ABudgetEndsInTheMiddleOfARow) {
  const System system = make_system("henon", {{"k", 10}});
  TransportOptions options;
  options.iterates = 100;
  options.budget = 2;
  const Transport found = transport(system, options);
  EXPECT_GE(found.steps.size(), 2U);
  EXPECT_LT(found.steps.size(), 40U);
  ASSERT_FALSE(found.remarks.empty());
  EXPECT_NE(found.remarks[0].find("limit of seconds"), std::string::npos) << found.remarks[0];
  EXPECT_TRUE(found.agreement.agrees());
  // The manifolds are there, with their lobes.
  ASSERT_EQ(found.boundaries.size(), 1U);
  EXPECT_GE(found.boundaries[0].manifolds->tangle.lobes.size(), 2U);
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

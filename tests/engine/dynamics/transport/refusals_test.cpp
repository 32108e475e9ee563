// Transport of maps for which its formulas do not hold, and bips that are not there.
#include <gtest/gtest.h>

#include <string>

#include "lober/error.hpp"
#include "lober/transport.hpp"
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

TEST(Transport, TakesABudgetOfSeconds) {
  const System system = make_system("duffing", {});
  TransportOptions options;
  options.iterates = 1;
  options.budget = 1000;
  EXPECT_EQ(transport(*system.map, *system.connection, options).steps.size(), 1U);
}

}  // namespace
}  // namespace lober

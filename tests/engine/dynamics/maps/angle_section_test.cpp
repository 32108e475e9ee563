// Return maps to a section of an angle, z = 0 mod 2 pi: the ABC flow.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/dynamics/dynamics.hpp"
#include "kernels/point.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

using std::numbers::pi;

double rising(const System& system, Point z) {
  return system.flow->velocity({z.x, z.y, 0}, 0)[2];
}

std::vector<Point> points_of_section(const System& system, int count) {
  std::vector<Point> points;
  for (int k = 0; static_cast<int>(points.size()) < count; ++k) {
    const Point z{-pi + std::fmod(1.234 + 2.17 * k, 2 * pi), -pi + std::fmod(0.357 + 1.31 * k, 2 * pi)};
    if (rising(system, z) > 0.05) points.push_back(z);
  }
  return points;
}

// Runge and Kutta's classical method by small steps, which knows nothing of levels: the unfolded z is watched for
// rising through a multiple of 2 pi, and the crossing is found by Henon's trick, a last step with z as the time.
struct Crossing {
  Point at;
  int turns = 0;
};
Crossing by_small_steps(const System& system, Point start) {
  const auto field = [&](const FlowState& x) { return system.flow->velocity(x, 0); };
  const auto step = [](const FlowState& x, double h, const auto& f) {
    const auto moved = [&](const FlowState& k, double by) {
      FlowState y = x;
      for (std::size_t i = 0; i < 3; ++i) y[i] += by * k[i];
      return y;
    };
    const FlowState k1 = f(x), k2 = f(moved(k1, h / 2)), k3 = f(moved(k2, h / 2)), k4 = f(moved(k3, h));
    FlowState y = x;
    for (std::size_t i = 0; i < 3; ++i) y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    return y;
  };
  FlowState x{start.x, start.y, 0};
  for (int n = 0; n < 2000000; ++n) {
    const FlowState next = step(x, 1e-3, field);
    const double below = std::floor(x[2] / (2 * pi)), above = std::floor(next[2] / (2 * pi));
    if (above > below && n > 0) {
      const auto by_z = [&](const FlowState& y) {
        FlowState v = field(y);
        for (std::size_t i = 0; i < 2; ++i) v[i] /= v[2];
        v[2] = 1;
        return v;
      };
      const FlowState end = step(x, above * 2 * pi - x[2], by_z);
      return {{end[0], end[1]}, static_cast<int>(above)};
    }
    x = next;
  }
  return {{std::nan(""), std::nan("")}, 0};
}

TEST(AngleSection, IsThatOfSmallSteps) {
  const System system = make_system("abc");
  int up = 0, back = 0;
  for (const Point start : points_of_section(system, 60)) {
    const Crossing expected = by_small_steps(system, start);
    Point found = start;
    system.map->iterate({&found, 1}, 1);
    if (std::isnan(expected.at.x)) continue;
    EXPECT_LT(distance(found, expected.at), 1e-6) << start.x << ' ' << start.y;
    ++(expected.turns == 1 ? up : back);
  }
  // Orbits that go once round, and some that come back to where they began, or below.
  EXPECT_GT(up, 5);
  EXPECT_GT(back, 2);
}

TEST(AngleSection, IsInvertedByBackwardTime) {
  const System system = make_system("abc");
  std::vector<Point> points = points_of_section(system, 50);
  const std::vector<Point> starts = points;
  system.map->iterate(points, 1);
  system.map->iterate(points, -1);
  for (std::size_t k = 0; k < points.size(); ++k)
    EXPECT_LT(distance(points[k], starts[k]), 1e-6) << k;  // some orbits are stretched by 10^4
}

// The flow preserves volume, so that its return map preserves z' dx dy.
TEST(AngleSection, PreservesTheFlux) {
  const System system = make_system("abc");
  bool changes_area = false;
  for (const Point start : points_of_section(system, 50)) {
    Matrix2 d;
    const Point end = system.map->iterate_with_derivative(start, 1, d);
    const double determinant = d.xx * d.yy - d.xy * d.yx;
    const double size = 1 + std::fabs(d.xx * d.yy) + std::fabs(d.xy * d.yx);
    EXPECT_NEAR(determinant * rising(system, end) / rising(system, start), 1, 1e-9 * size) << start.x << ' ' << start.y;
    changes_area = changes_area || std::fabs(determinant - 1) > 0.1;
  }
  EXPECT_TRUE(changes_area);
}

// With C = 0 both B sin x + A cos z, the speed along y, and the orbit in (x, z) are those of a pendulum: x comes back.
TEST(AngleSection, KeepsTheIntegralWithoutC) {
  const System system = make_system("abc", {{"C", 0}});
  for (const Point start : points_of_section(system, 30)) {
    Point end = start;
    system.map->iterate({&end, 1}, 1);
    EXPECT_NEAR(std::sin(end.x), std::sin(start.x), 1e-10) << start.x << ' ' << start.y;
    EXPECT_GT(std::fabs(end.y - start.y), 1e-3);
  }
}

// Where the flow crosses downward there is no point of the section, and an orbit that begins there is none.
TEST(AngleSection, HasNoPointsWhereTheFlowFalls) {
  const System system = make_system("abc");
  EXPECT_TRUE(system.map->is_defined_at({0, 1}));
  EXPECT_FALSE(system.map->is_defined_at({pi, -1}));
  Point falling{pi, -1};
  system.map->iterate({&falling, 1}, 1);
  EXPECT_TRUE(std::isnan(falling.x));
}

// Crossings of Flow::to_section count at each multiple, and in both directions if that is asked for.
TEST(AngleSection, CountsAllMultiples) {
  const System system = make_system("abc");
  Section plane = *system.section;
  plane.direction = 0;
  std::array<FlowState, 2> states{FlowState{0.1, 1, 6 * pi + 0.3}, FlowState{0.1, 1, 0.3}};
  std::array<double, 2> times{};
  system.flow->to_section(states, times, plane, 3, {});
  EXPECT_NEAR(times[0], times[1], 1e-9);
  EXPECT_GT(times[1], 1);
  EXPECT_EQ(states[1][2], 0);
  EXPECT_NEAR(states[0][0], states[1][0], 1e-8);
}

TEST(AngleSection, NeedsAPeriodThatIsNotNegative) {
  const System system = make_system("abc");
  for (const double period : {-1.0, std::nan("")}) {
    Section bad = *system.section;
    bad.period = period;
    EXPECT_THROW(static_cast<void>(system.flow->section_map(bad, 0, {})), UsageError);
  }
}

}  // namespace
}  // namespace lober::detail

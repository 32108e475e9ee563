// How good the estimate of the discretisation error is: against the true one, for pairs of smooth curves whose areas
// are known.
//
// LOBER_DISCRETISATION_PAIRS  how many pairs of each kind (default 200)
// LOBER_SEED                  the first seed (default 0)
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "lober/overlay/overlay.hpp"
#include "tests/environment.hpp"
#include "tests/oracle/random.hpp"
#include "tests/stress/coverage.hpp"
#include "tests/views.hpp"

namespace lober::stress {
using namespace lober::detail;
namespace {

using oracle::Random;
using std::numbers::pi;

struct Circle {
  Point centre;
  double radius;
};

struct SmoothPair {
  std::vector<Point> first, second;
  Areas areas;  // of the smooth curves
};

// Two circles that cross at distance d, the radii r and s: the sum of two circular segments.
double lens_area(double r, double s, double d) {
  const double along = (d * d + r * r - s * s) / (2 * d);
  const auto segment = [](double radius, double height) {
    return radius * radius * std::acos(height / radius) - height * std::sqrt((radius - height) * (radius + height));
  };
  return segment(r, along) + segment(s, d - along);
}

// Two circles that cross, moved by a linear map of determinant `stretch`: ellipses that cross in a known area.
// `uneven` below 1 is how much denser than the mean the points are somewhere.
SmoothPair make_scene(Random& random, double max_stretch, double max_unevenness) {
  const double r = random.log_uniform(0.3, 3), s = random.log_uniform(0.3, 3);
  const double d = std::fabs(r - s) + random.uniform(0.1, 0.9) * (r + s - std::fabs(r - s));
  const Point centre{random.uniform(-5, 5), random.uniform(-5, 5)};
  const double direction = random.uniform(0, 2 * pi), stretch = random.log_uniform(1, max_stretch);
  const double tilt = random.uniform(0, pi), c = std::cos(tilt), t = std::sin(tilt);
  const auto sampled = [&](const Circle& circle) {
    const auto count = static_cast<std::size_t>(random.log_uniform(50, 5000));
    const double phase = random.uniform(0, 2 * pi), uneven = random.uniform(0, max_unevenness),
                 densest = random.uniform(0, 2 * pi);
    std::vector<Point> points;
    for (std::size_t k = 0; k < count; ++k) {
      const double even = phase + 2 * pi * static_cast<double>(k) / static_cast<double>(count);
      const double angle = even + uneven * std::sin(even - densest);
      const double x = stretch * (circle.centre.x + circle.radius * std::cos(angle)),
                   y = circle.centre.y + circle.radius * std::sin(angle);
      points.push_back({c * x - t * y, t * x + c * y});
    }
    return points;
  };
  SmoothPair scene;
  scene.first = sampled({centre, r});
  scene.second = sampled({{centre.x + d * std::cos(direction), centre.y + d * std::sin(direction)}, s});
  const double area1 = stretch * pi * r * r, area2 = stretch * pi * s * s, common = stretch * lens_area(r, s, d);
  scene.areas = {.c1 = area1,
                 .c2 = area2,
                 .intersection = common,
                 .union_ = area1 + area2 - common,
                 .c1_minus_c2 = area1 - common,
                 .c2_minus_c1 = area2 - common,
                 .symmetric_difference = area1 + area2 - 2 * common};
  return scene;
}

struct ShapeKind {
  const char* name;
  double max_stretch, max_unevenness;
};

/// For the names of tests.
std::ostream& operator<<(std::ostream& stream, const ShapeKind& kind) {
  return stream << kind.name;
}

struct Row {
  const char* name;
  double Areas::*area;
  bool one_sign;  // both polygons lose along its boundary. Else losses may cancel, and the estimate is only as good
                  // as what is left: the worst pairs are a factor of several off
};
constexpr std::array rows{
    Row{"C1", &Areas::c1, true},
    Row{"C2", &Areas::c2, true},
    Row{"intersection", &Areas::intersection, true},
    Row{"union", &Areas::union_, true},
    Row{"C1 minus C2", &Areas::c1_minus_c2, false},
    Row{"C2 minus C1", &Areas::c2_minus_c1, false},
    Row{"symmetric difference", &Areas::symmetric_difference, false},
};

class DiscretisationStability : public testing::TestWithParam<ShapeKind> {};

TEST_P(DiscretisationStability, EstimateIsNearTheTrueError) {
  const ShapeKind& kind = GetParam();
  const std::uint64_t seed = from_environment("LOBER_SEED", 0);
  const std::size_t count = from_environment("LOBER_DISCRETISATION_PAIRS", 200);
  std::vector<Areas> ratios(count);  // estimate / true error
  for_each_block(count, 1, [&](std::size_t k, std::size_t) {
    Random random(Random(seed + k).bits());
    const SmoothPair scene = make_scene(random, kind.max_stretch, kind.max_unevenness);
    const Overlay found = overlay(CurveView{scene.first}, CurveView{scene.second});
    const Areas estimate = discretisation_error(found);
    for (const Row& row : rows) {
      const auto area = row.area;
      ratios[k].*area = estimate.*area / std::fabs(scene.areas.*area - found.areas.*area);
    }
  });
  std::printf("%zu pairs of %s\n%-22s %9s %9s %9s %9s %9s  within 2\n", count, kind.name, "estimate / true error",
              "least", "1 %", "median", "99 %", "most");
  for (const Row& row : rows) {
    std::vector<double> sorted;
    for (const Areas& ratio : ratios) sorted.push_back(ratio.*(row.area));
    std::sort(sorted.begin(), sorted.end());
    const auto near = std::count_if(sorted.begin(), sorted.end(), [](double q) { return q >= 0.5 && q <= 2; });
    const double share = static_cast<double>(near) / static_cast<double>(count);
    std::printf("%-22s %9.4g %9.4g %9.4g %9.4g %9.4g %8.2f%%\n", row.name, sorted.front(), quantile(sorted, 0.01),
                quantile(sorted, 0.5), quantile(sorted, 0.99), sorted.back(), 100 * share);
    EXPECT_GE(share, 0.99) << row.name;
    EXPECT_NEAR(quantile(sorted, 0.5), 1, 0.01) << row.name;
    if (!row.one_sign) continue;
    EXPECT_GE(quantile(sorted, 0.01), 0.95) << row.name;
    EXPECT_LE(quantile(sorted, 0.99), 1.05) << row.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, DiscretisationStability,
                         testing::Values(ShapeKind{"circles", 1, 0}, ShapeKind{"ellipses", 5, 0},
                                         ShapeKind{"uneven_ellipses", 5, 0.5}),
                         [](const auto& member) { return std::string(member.param.name); });

}  // namespace
}  // namespace lober::stress

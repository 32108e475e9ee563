// Curves of so few points that their smooth arcs are wrong by more than lobes are thick.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "lober/curve/curve.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/smooth.hpp"
#include "tests/engine/geometry/smooth/shapes.hpp"
#include "tests/views.hpp"

namespace lober::smooth_test {
using namespace lober::detail;
namespace {

// The unit circle and one of radius r whose centre is at distance d, both stretched in y.
Areas stretched_circles(double r, double d, double stretch) {
  const long double x = (static_cast<long double>(d) * d + 1 - static_cast<long double>(r) * r) / (2 * d);
  const long double square = (1 - x) * (1 + x), y = std::sqrt(std::max(square, 0.0L));
  long double both = d < std::max(1.0, r) ? std::numbers::pi_v<long double> * std::min(r, 1.0) * std::min(r, 1.0) : 0;
  if (square > 0)
    both = std::atan2(y, x) - x * y + static_cast<long double>(r) * r * std::atan2(y, d - x) - (d - x) * y;
  return from(pi * stretch, pi * r * r * stretch, static_cast<double>(both * stretch));
}

// Pairs of ellipses of one shape that touch or nearly so, from outside or inside, in the direction `at` of circles that
// are stretched then.
class Touching {
 public:
  explicit Touching(std::uint64_t seed) : random_(seed) {}

  void expect_in_bars(int least, int most, double stretch, double at) {
    const int n1 = static_cast<int>(uniform(least, most)), n2 = static_cast<int>(std::exp(uniform(3, 6)));
    const double r = std::pow(10, uniform(-0.9, 0.9)), depth = std::pow(10, uniform(-7, -1.5)) * (choose() ? 1 : -1);
    const bool inside = choose();
    const double d = inside ? std::fabs(1 - r) + depth : 1 + r - depth;
    if (d <= 0) return;
    const bool even = choose();
    const Points c1 = points(0, 0, 1, n1, stretch, even);
    const Points c2 = points(d * std::cos(at), d * std::sin(at), r, n2, stretch, even);
    const Areas exact = stretched_circles(r, d, stretch);
    const SmoothAreas smooth = smooth_areas(overlay(CurveView{c1}, CurveView{c2}));
    for (const auto member : members) {
      const double rounding = 1e-14 * exact.union_;
      ASSERT_LE(std::fabs(smooth.areas.*member - exact.*member), smooth.error.*member + rounding)
          << n1 << " and " << n2 << " points, radius " << r << ", distance " << d << ", stretch " << stretch << ", at "
          << at << (even ? "" : ", uneven");
    }
  }
  double uniform(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }

 private:
  bool choose() { return uniform(0, 1) < 0.5; }
  Points points(double x, double y, double r, int n, double stretch, bool even) {
    const double first = uniform(0, 1);
    Points result;
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * pi * (k + first + (even ? 0 : uniform(-0.35, 0.35))) / n;
      result.push_back({x + r * std::cos(angle), stretch * (y + r * std::sin(angle))});
    }
    return result;
  }
  std::mt19937_64 random_;
};

TEST(SmoothFewPoints, LensesThatArcsMissAreInTheBar) {
  Touching pairs(11);
  for (int k = 0; k < 6000; ++k) {
    pairs.expect_in_bars(14, 40, k % 2 == 0 ? 0.3 : 3, pairs.uniform(0, 2 * pi));
    if (HasFatalFailure()) return;
  }
}

// The segment across the spike of a thin ellipse, between two vertices that turn like corners, stays straight.
TEST(SmoothFewPoints, SpikesAreInTheBar) {
  Touching pairs(12);
  for (int k = 0; k < 6000; ++k) {
    pairs.expect_in_bars(14, 60, k % 2 == 0 ? 0.3 : 0.2, (k % 4 < 2 ? 0 : pi) + pairs.uniform(-0.3, 0.3));
    if (HasFatalFailure()) return;
  }
}

// A leaf of the search is nearly the whole ellipse, and lies beyond both ends of the chord between its own ends.
TEST(SmoothFewPoints, ALeafThatTurnsRoundIsSearched) {
  for (int k = 0; k < 60; ++k) {
    const double at = 2 * pi * k / 60, r = 0.14, d = 1 + r - 6e-3;
    const Points c1 = sample(ellipse(0, 0, 1, 3), 19),
                 c2 = sample(ellipse(d * std::cos(at), 3 * d * std::sin(at), r, 3 * r), 46);
    const SmoothAreas smooth = smooth_areas(overlay(CurveView{c1}, CurveView{c2}));
    const double both = stretched_circles(r, d, 3).intersection;
    EXPECT_LE(std::fabs(smooth.areas.intersection - both), smooth.error.intersection) << k;
  }
}

// The chord of an arc lies beside that of the arc that it crosses, and at an angle to it.
TEST(SmoothFewPoints, ChordsThatDoNotLieAboveEachOtherAreCompared) {
  for (int k = 0; k < 2000; ++k) {
    const double at = 0.6 * (k % 100 / 99.0 - 0.5), stretch = 0.1, r = 0.56, d = 1 + r - 5e-7;
    const Points c1 = sample(ellipse(0, 0, 1, stretch), 17, 0.05 * (k / 100));
    const Points c2 = sample(ellipse(d * std::cos(at), stretch * d * std::sin(at), r, stretch * r), 168);
    const SmoothAreas smooth = smooth_areas(overlay(CurveView{c1}, CurveView{c2}));
    const double both = stretched_circles(r, d, stretch).intersection;
    EXPECT_LE(std::fabs(smooth.areas.intersection - both), smooth.error.intersection) << k;
  }
}

}  // namespace
}  // namespace lober::smooth_test

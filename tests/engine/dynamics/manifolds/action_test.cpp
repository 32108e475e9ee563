// Lobe areas as differences of the actions of two homoclinic orbits (MacKay, Meiss & Percival 1984), against references
// computed to 30 digits and more. The orbits are those through given points, followed both ways until they come nearest
// to their fixed points; the action being stationary, what they miss there is squared.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "engine/dynamics/dynamics.hpp"

namespace lober::detail {
namespace {

/// A point in more digits than the maps have: an orbit that starts one rounding off its stable manifold comes no nearer
/// to the saddle than the root of that.
struct LongPoint {
  long double x, y;
};

/// Points of the orbit through z, from nearest `begin` to nearest `end`; step(z, 1) is the image, step(z, -1) the
/// pre-image.
template <typename Step>
std::vector<Point> orbit(const Step& step, LongPoint z, Point begin, Point end) {
  const auto rounded = [](LongPoint p) { return Point{static_cast<double>(p.x), static_cast<double>(p.y)}; };
  const auto follow = [&](LongPoint from, int direction, Point target) {
    std::vector<Point> tail;
    double nearest = 1e300;
    for (;;) {
      from = step(from, direction);
      const Point here = rounded(from);
      const double off = std::hypot(here.x - target.x, here.y - target.y);
      if (tail.size() > 4 && !(off < nearest)) return tail;
      nearest = off;
      tail.push_back(here);
    }
  };
  std::vector<Point> points = follow(z, -1, begin);
  std::reverse(points.begin(), points.end());
  points.push_back(rounded(z));
  const std::vector<Point> after = follow(z, 1, end);
  points.insert(points.end(), after.begin(), after.end());
  return points;
}

/// Sum of the actions of the steps, each less `of_fixed_point`, so that the tails converge; the ends are put on the
/// fixed points.
template <typename Step>
long double total_action(const PlanarMap& map, const Step& step, LongPoint z, Point begin, Point end,
                         long double of_fixed_point) {
  std::vector<Point> points = orbit(step, z, begin, end);
  points.insert(points.begin(), begin);
  points.push_back(end);
  long double sum = 0;
  for (std::size_t k = 1; k < points.size(); ++k) sum += *map.action(points[k - 1], points[k]) - of_fixed_point;
  return sum;
}

TEST(Action, LobesOfTheStandardMap) {
  constexpr long double k = 1.2;
  const System system = make_system("standard", {{"K", 1.2}});
  const Point begin{0, 0}, end = system.lattice;
  const auto step = [](LongPoint z, int direction) -> LongPoint {
    if (direction > 0) return {z.x + z.y + k * std::sin(z.x), z.y + k * std::sin(z.x)};
    return {z.x - z.y, z.y - k * std::sin(z.x - z.y)};
  };
  const auto total = [&](LongPoint z) { return total_action(*system.map, step, z, begin, end, 0); };
  const long double area = total({std::numbers::pi_v<long double>, 1.9173532103668022394821859758L}) -
                           total({1.9628421288471131321305931545L, 1.2485458479090651355516320286L});
  EXPECT_NEAR(static_cast<double>(area), 0.05805630576704177816917301265938610107, 2e-16);
}

TEST(Action, LobesOfTheHenonMap) {
  constexpr long double k = 0.5;
  const System system = make_system("henon", {{"k", 0.5}});
  const long double s = 1 + std::sqrt(1 + k);
  const Point saddle{static_cast<double>(s), static_cast<double>(s)};
  const auto step = [](LongPoint z, int direction) -> LongPoint {
    if (direction > 0) return {z.x * z.x - k - z.y, z.x};
    return {z.y, z.y * z.y - k - z.x};
  };
  const auto total = [&](LongPoint z) {
    return total_action(*system.map, step, z, saddle, saddle, *system.map->action(saddle, saddle));
  };
  const long double a = total({-1.5330999704679823237532195910L, 0.92519775972446413661609497004L});
  // The other orbit is symmetric about a point of the diagonal that goes to the saddle: where the part of f^n(d, d)
  // along the unstable direction vanishes. There are several; the action of the principal one tells.
  const long double lambda = s + std::sqrt(s * s - 1);
  const auto zero_between = [&](long double low, long double high, int iterates) {
    const auto positive = [&](long double d) {
      LongPoint z{d, d};
      for (int n = 0; n < iterates; ++n) z = step(z, 1);
      return lambda * (z.x - s) - (z.y - s) > 0;
    };
    const bool at_low = positive(low);
    if (positive(high) == at_low) return std::numeric_limits<long double>::quiet_NaN();
    for (int halving = 0; halving < 70; ++halving) {
      const long double middle = 0.5L * (low + high);
      (positive(middle) == at_low ? low : high) = middle;
    }
    return low;
  };
  double nearest = 1;
  for (long double d = -1.6L; d < 1; d += 1e-3L) {
    long double root = zero_between(d, d + 1e-3L, 6);
    root = zero_between(root - 1e-6L, root + 1e-6L, 9);
    root = zero_between(root - 1e-9L, root + 1e-9L, 13);
    if (std::isnan(root)) continue;
    const auto area = static_cast<double>(std::abs(a - total({root, root})) - 1.0364943412491413807970964288427805111L);
    nearest = std::min(nearest, std::abs(area));
  }
  EXPECT_LT(nearest, 2e-15);
}

TEST(Action, LobesOfTheVortexPair) {
  struct Reference {
    const char* name;
    double gamma, xp, ya, xb, yb, area;
  };
  for (const Reference& r : {Reference{"ovp", 0.5, 1.451260038107551142, 2.068482945180626534, 1.142891659497408535,
                                       1.229496792704067590, 0.254106277099506951},
                             Reference{"ovp1", 0.5, 1.455237909563602025, 2.064627690528027250, 1.141265606088736719,
                                       1.240047821859368424, 0.205511682983426906}}) {
    const System system = make_system(r.name, {{"gamma", r.gamma}}, {.tolerance = 1e-14});
    const Point right{r.xp, 0}, left{-r.xp, 0};
    const auto step = [&](LongPoint z, int direction) -> LongPoint {
      Point p{static_cast<double>(z.x), static_cast<double>(z.y)};
      system.map->iterate({&p, 1}, direction);
      return {p.x, p.y};
    };
    const auto total = [&](LongPoint z) { return total_action(*system.map, step, z, right, left, 0); };
    const long double area = std::abs(total({0, r.ya}) - total({r.xb, r.yb}));
    EXPECT_NEAR(static_cast<double>(area), r.area, 1e-10 * r.area) << r.name;
  }
}

}  // namespace
}  // namespace lober::detail

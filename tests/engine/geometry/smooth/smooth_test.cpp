#include "lober/overlay/smooth.hpp"
#include "tests/views.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "tests/engine/geometry/smooth/shapes.hpp"

namespace lober::smooth_test {
using namespace lober::detail;
namespace {

TEST(Smooth, AnalyticScenesConvergeWithOrderFourAtLeast) {
  for (const Scene& scene : scenes()) {
    double first = 0;
    for (const int n : {125, 250, 500, 1000, 2000, 4000}) {
      const Points c1 = sample(scene.c1, n), c2 = sample(scene.c2, n + n / 7, 0.391);
      const Overlay result = overlay(CurveView{c1}, CurveView{c2});
      const SmoothAreas smooth = smooth_areas(result);
      const double error = worst(smooth.areas, scene.exact);
      if (n == 125) first = error;
      std::printf("%-9s N = %4d: polygons %.1e, smooth %.1e, order %.2f, bar %.1e\n", scene.name, n,
                  worst(result.areas, scene.exact), error, std::log2(first / error) / std::log2(n / 125.0),
                  smooth.error.symmetric_difference / scene.exact.symmetric_difference);
      EXPECT_EQ(smooth.fallback_segments, 0U);
      EXPECT_EQ(smooth.fallback_crossings, 0U);
      EXPECT_LE(error, std::max(2e-14, first * std::pow(125.0 / n, 4))) << scene.name << n;
      for (const auto member : members) {
        EXPECT_LE(std::fabs(smooth.areas.*member - scene.exact.*member), smooth.error.*member + 2e-15)
            << scene.name << n;
      }
    }
  }
}

SmoothAreas smooth_of(const Points& c1, const Points& c2) {
  return smooth_areas(overlay(CurveView{c1}, CurveView{c2}));
}

void expect_equal(const Areas& a, const Areas& b) {
  for (const auto member : members) EXPECT_EQ(a.*member, b.*member);
}
void expect_near(const Areas& a, const Areas& b, double tolerance) {
  for (const auto member : members) EXPECT_NEAR(a.*member, b.*member, tolerance);
}

TEST(Smooth, AThousandPointsOnTheLens) {
  const Points c1 = sample(ellipse(0, 0, 1, 1), 1000), c2 = sample(ellipse(0.7, 0, 1, 1), 1000);
  EXPECT_LT(worst(smooth_of(c1, c2).areas, lens(0.7)), 1e-9);
}

TEST(Smooth, OrientationAndFirstVertexDoNotMatter) {
  Points c1 = sample(wavy(0.1, 5), 500), c2 = sample(ellipse(0, 0, 1, 1), 500);
  const Areas before = smooth_of(c1, c2).areas;
  std::reverse(c1.begin(), c1.end());
  expect_near(smooth_of(c1, c2).areas, before, 1e-14);
  std::reverse(c2.begin(), c2.end());
  expect_near(smooth_of(c1, c2).areas, before, 1e-14);
  for (int turn = 0; turn < 50; ++turn) {  // a crossing among them passes the first vertex
    std::rotate(c1.begin(), c1.begin() + 10, c1.end());
    std::rotate(c2.begin(), c2.begin() + 7, c2.end());
    expect_near(smooth_of(c1, c2).areas, before, 1e-14);
  }
}

TEST(Smooth, CrossingAtVertices) {
  // Circles about (-a, 0) and (a, 0) meet in (0, +-b).
  const double a = 0.6, b = 0.8, angle = std::atan2(b, a);
  for (const int n : {400, 401}) {
    Points c1, c2;
    for (int k = 0; k < n; ++k) {
      const double t = angle + 2 * pi * k / n;
      c1.push_back(k == 0 ? Point{0, b} : Point{-a + std::cos(t), std::sin(t)});
      c2.push_back(k == 0 ? Point{0, b} : Point{a - std::cos(t), std::sin(t)});
    }
    EXPECT_LT(worst(smooth_of(c1, c2).areas, lens(2 * a)), 1e-10);
  }
}

TEST(Smooth, UnevenPoints) {
  // Segments grow by a factor of 1000 along each half, by a few per cent from one to the next.
  const auto uneven = [](const Shape& shape) {
    Points points;
    const int half = 400;
    for (const int sign : {1, -1}) {
      for (int k = 0; k < half; ++k) {
        const double part = (std::pow(1000.0, (k + 0.0) / half) - 1) / 999;
        const double angle = sign > 0 ? pi * part : 2 * pi - pi * part;
        if (sign > 0) points.push_back(shape(angle));
        if (sign < 0 && k > 0) points.push_back(shape(angle));
      }
      if (sign > 0) points.push_back(shape(pi));
    }
    std::reverse(points.begin() + half + 1, points.end());
    return points;
  };
  const Points c1 = uneven(ellipse(0, 0, 1, 1)), c2 = uneven(ellipse(0.7, 0, 1, 1));
  const Overlay result = overlay(CurveView{c1}, CurveView{c2});
  const SmoothAreas smooth = smooth_areas(result);
  EXPECT_LT(worst(smooth.areas, lens(0.7)), 1e-4 * worst(result.areas, lens(0.7)));
  for (const auto member : members) {
    EXPECT_LE(std::fabs(smooth.areas.*member - lens(0.7).*member), smooth.error.*member);
  }
}

TEST(Smooth, PolygonsStayPolygons) {
  const auto expect_polygon = [](const Points& c1, const Points& c2) {
    const Overlay result = overlay(CurveView{c1}, CurveView{c2});
    expect_equal(smooth_areas(result).areas, result.areas);
  };
  const Points square{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, other{{0.3, 0.2}, {1.6, 0.4}, {0.9, 1.7}};
  expect_polygon(square, other);
  expect_polygon(square, {{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}});
  Points divided;  // sides with vertices on them
  for (std::size_t k = 0; k < 4; ++k) {
    const Point a = square[k], b = square[(k + 1) % 4];
    for (int j = 0; j < 16; ++j) divided.push_back({a.x + (b.x - a.x) * j / 16, a.y + (b.y - a.y) * j / 16});
  }
  expect_polygon(divided, other);
  Points star;  // every vertex turns by more than 45 degrees
  for (int k = 0; k < 40; ++k) {
    const double r = k % 2 == 0 ? 1 : 0.6, t = 2 * pi * k / 40;
    star.push_back({r * std::cos(t), r * std::sin(t)});
  }
  expect_polygon(star, square);
}

TEST(Smooth, CornersOnASmoothCurve) {
  // The upper half of the unit disc, its diameter divided evenly or not at all, against a disc that it does not cut.
  double previous = 0;
  for (const int n : {50, 100, 200, 400}) {
    for (const int across : {1, n}) {
      Points half;
      for (int k = 0; k < n; ++k) half.push_back({std::cos(pi * k / n), std::sin(pi * k / n)});
      for (int k = 0; k < across; ++k) half.push_back({-1 + 2.0 * k / across, 0});
      const Points circle = sample(ellipse(0, 0.25, 1, 1), n);
      const SmoothAreas smooth = smooth_of(half, circle);
      // The circle's part below y = 0 is a segment of the disc at distance 1/4; the upper arcs meet at y = 1/8.
      EXPECT_LE(std::fabs(smooth.areas.c1 - pi / 2), smooth.error.c1);
      const double error = std::fabs(smooth.areas.c1 - pi / 2);
      if (across == n) {
        if (previous > 0) {
          EXPECT_LT(error, previous / 14);
        }
        previous = error;
      }
    }
  }
}

TEST(Smooth, NoiseCostsNoMoreThanTheBar) {
  const Areas exact = lens(0.7);
  for (const int n : {200, 2000}) {
    for (const double size : {1e-9, 1e-6, 1e-3, 1e-2, 0.1, 0.3}) {
      for (unsigned seed = 0; seed < 20; ++seed) {
        const double h = 2 * pi / n;
        const Points c1 = jittered(sample(ellipse(0, 0, 1, 1), n), size * h, 2 * seed);
        const Points c2 = jittered(sample(ellipse(0.7, 0, 1, 1), n), size * h, 2 * seed + 1);
        Overlay result;
        try {
          result = overlay(CurveView{c1}, CurveView{c2});
        } catch (const NotSimpleError&) {
          continue;  // jitter may make a knot
        }
        const SmoothAreas smooth = smooth_areas(result);
        for (const auto member : members) {
          EXPECT_LE(std::fabs(smooth.areas.*member - exact.*member),
                    std::fabs(result.areas.*member - exact.*member) + smooth.error.*member)
              << n << " " << size << " " << seed;
        }
        if (size == 0.3) {
          EXPECT_GT(smooth.fallback_segments, static_cast<std::uint64_t>(n))  // of 2 n
          ;
        }
      }
    }
  }
}

TEST(Smooth, SharedArcsAreNoLobes) {
  const Points circle = sample(ellipse(0, 0, 1, 1), 300);
  const SmoothAreas same = smooth_of(circle, circle);
  EXPECT_EQ(same.areas.symmetric_difference, 0);
  EXPECT_EQ(same.error.symmetric_difference, 0);
  EXPECT_NEAR(same.areas.intersection, pi, 1e-10);

  // One half shared, in the other half a smaller radius with corners at the ends: nothing of C2 outside C1.
  Points inner = circle;
  for (Point& p : inner) {
    if (p.y < 0) p = {0.9 * p.x, 0.9 * p.y};
  }
  const SmoothAreas half = smooth_of(circle, inner);
  EXPECT_EQ(half.areas.c2_minus_c1, 0);
  EXPECT_NEAR(half.areas.union_, pi, 1e-9);
  std::rotate(inner.begin(), inner.begin() + 77, inner.end());
  std::reverse(inner.begin(), inner.end());
  const SmoothAreas turned = smooth_of(circle, inner);
  expect_near(turned.areas, half.areas, 1e-14);
  EXPECT_EQ(turned.areas.c2_minus_c1, 0);

  // Outside instead, along the same arc run the other way.
  Points outer = circle;
  for (Point& p : outer) {
    if (p.y < 0) p = {p.x, 2.5 - p.y};
  }
  const SmoothAreas apart = smooth_of(circle, outer);
  EXPECT_EQ(apart.areas.intersection, 0);
  EXPECT_NEAR(apart.areas.c1_minus_c2, pi, 1e-9);
}

TEST(Smooth, RepeatedVerticesDoNotMatter) {
  const Points c1 = sample(wavy(0.1, 5), 500), c2 = sample(ellipse(0, 0, 1, 1), 500);
  Points repeated;
  for (std::size_t k = 0; k < c1.size(); ++k) repeated.insert(repeated.end(), 1 + k % 3, c1[k]);
  expect_near(smooth_of(repeated, c2).areas, smooth_of(c1, c2).areas, 1e-15);
  // A stall takes no longer than its points: each of its segments looking for neighbours took minutes.
  Points stalled = c1;
  stalled.insert(stalled.begin() + 77, 400000, c1[77]);
  expect_near(smooth_of(stalled, c2).areas, smooth_of(c1, c2).areas, 1e-15);
}

TEST(Smooth, BunchedVerticesHaveAnErrorBar) {
  // Pairs of vertices a hundred times closer than the pairs are: no stencil fits.
  const auto bunched = [](double x) {
    Points points;
    for (int k = 0; k < 400; ++k) {
      for (const double t : {2 * pi * k / 400, 2 * pi * (k + 0.01) / 400})
        points.push_back({x + std::cos(t), std::sin(t)});
    }
    return points;
  };
  const SmoothAreas smooth = smooth_of(bunched(0), bunched(0.7));
  EXPECT_GT(smooth.fallback_segments, 0U);
  for (const auto member : members) {
    EXPECT_LE(std::fabs(smooth.areas.*member - lens(0.7).*member), smooth.error.*member);
  }
}

// Few vertices leave one of use on either side, and both demand the same of a segment of a regular polygon.
TEST(Smooth, FewVerticesOfACircleHaveAnErrorBar) {
  for (std::size_t points = 9; points <= 24; ++points) {
    std::vector<Point> circle;
    for (std::size_t k = 0; k < points; ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(points);
      circle.push_back({std::cos(angle), std::sin(angle)});
    }
    const SmoothArea smooth = smooth_area(ClosedCurve::borrow(circle));
    EXPECT_LE(std::fabs(smooth.area - std::numbers::pi), smooth.error) << points << " points";
    EXPECT_LT(smooth.error, 0.5) << points << " points";
  }
}

TEST(Smooth, CurvesThatDoNotMeet) {
  const Points outer = sample(ellipse(0, 0, 2, 2), 400), inner = sample(ellipse(0.1, 0, 1, 1), 400),
               aside = sample(ellipse(5, 0, 1, 1), 400);
  expect_near(smooth_of(outer, inner).areas, from(4 * pi, pi, pi), 1e-10);
  expect_near(smooth_of(inner, outer).areas, from(pi, 4 * pi, pi), 1e-10);
  expect_near(smooth_of(inner, aside).areas, from(pi, pi, 0), 1e-10);
}

TEST(Smooth, LobesThatPolygonsMissAreInTheBar) {
  // Circles apart, and one within the other one: no polygon crosses another one, but the circles do.
  const double distance = 1.999;
  const SmoothAreas apart = smooth_of(sample(ellipse(0, 0, 1, 1), 50), sample(ellipse(distance, 0, 1, 1), 30));
  const Areas exact = lens(distance);
  EXPECT_EQ(apart.areas.intersection, 0);
  for (const auto member : {&Areas::intersection, &Areas::c1_minus_c2, &Areas::c2_minus_c1, &Areas::union_}) {
    EXPECT_LE(std::fabs(apart.areas.*member - exact.*member), apart.error.*member);
  }
  EXPECT_LT(apart.error.intersection, 2 * exact.intersection);
  const double out = 5e-4;
  const SmoothAreas within = smooth_of(sample(ellipse(1 + out, 0, 1, 1), 50, 0.5), sample(ellipse(0, 0, 2, 2), 4000));
  // The crescent outside the larger circle: half-angles at both centres.
  const double d = 1 + out, x = (d * d + 3) / (2 * d), y = std::sqrt(4 - x * x);
  const double large = std::atan2(y, x), small = std::atan2(y, x - d);
  const double crescent = (small - y * (x - d)) - 4 * (large - x * y / 4);
  EXPECT_EQ(within.areas.c1_minus_c2, 0);
  EXPECT_GE(within.error.c1_minus_c2, crescent);
  EXPECT_LT(within.error.c1_minus_c2, 2 * crescent + 1e-6);

  // Beside two crossings, at any angle of the scene.
  const auto radius = [](double angle) {
    const double back = (1 - std::cos(angle)) / 2;
    return 1 - 1e-3 + 2 * back - 2.3 * std::pow(back, 4);
  };
  double common = 0;
  const int steps = 1 << 20;
  for (int k = 0; k < steps; ++k) common += pi / steps * std::pow(std::min(radius((k + 0.5) * 2 * pi / steps), 1.0), 2);
  for (const double turn : {0.0, 0.3, 1.1, 2.0, 2.9, 4.2, 5.5}) {
    Points circle, other;
    for (int k = 0; k < 50; ++k) {
      const double angle = (k + 0.5) * 2 * pi / 50 + turn;
      circle.push_back({std::cos(angle), std::sin(angle)});
    }
    for (int k = 0; k < 4000; ++k) {
      const double angle = k * 2 * pi / 4000;
      other.push_back({radius(angle) * std::cos(angle + turn), radius(angle) * std::sin(angle + turn)});
    }
    std::rotate(other.begin(), other.begin() + static_cast<std::ptrdiff_t>(600 * turn), other.end());
    const SmoothAreas beside = smooth_of(circle, other);
    EXPECT_LE(std::fabs(beside.areas.intersection - common), beside.error.intersection) << turn;
    EXPECT_LT(beside.error.intersection, 1e-4 + beside.error.c1 + beside.error.c2) << turn;
  }
}

// Polygons of unequal segments cross where the circles touch from inside or outside, anywhere but where those cross:
// crossings stay where they are, and arcs are far longer than the lobe.
TEST(Smooth, CirclesThatTouchHaveABarForUnequalPoints) {
  std::mt19937_64 random(1);
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  double widest = 0;
  for (int k = 0; k < 20000; ++k) {
    const int n1 = static_cast<int>(uniform(30, 600)), n2 = static_cast<int>(uniform(30, 600));
    const double r = std::array{0.3, 0.5, 0.7, 0.9}[static_cast<std::size_t>(k % 4)];
    const double depth = std::pow(10, uniform(-9, -3)), turn = uniform(0, 2 * pi);
    const double d = k % 8 < 4 ? 1 - r + depth : 1 + r - depth;
    const auto circle = [](double x, double y, double radius, int n, double first) {
      Points points;
      for (int i = 0; i < n; ++i) {
        const double angle = 2 * pi * (i + first) / n;
        points.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
      }
      return points;
    };
    const double first1 = uniform(0, 1), first2 = uniform(0, 1);
    const SmoothAreas smooth =
        smooth_of(circle(0, 0, 1, n1, first1), circle(d * std::cos(turn), d * std::sin(turn), r, n2, first2));
    const long double x = (static_cast<long double>(d) * d + 1 - static_cast<long double>(r) * r) / (2 * d);
    const long double y = std::sqrt((1 - x) * (1 + x)), a1 = std::atan2(y, x), a2 = std::atan2(y, d - x);
    const long double both = a1 - x * y + static_cast<long double>(r) * r * a2 - (d - x) * y;
    const long double pi_of_all = std::numbers::pi_v<long double>, second = pi_of_all * r * r;
    const Areas exact = from(static_cast<double>(pi_of_all), static_cast<double>(second), static_cast<double>(both));
    // A difference of nearly equal areas has no digits in doubles.
    const double outside = static_cast<double>(second - both);
    ASSERT_LE(std::fabs(smooth.areas.intersection - exact.intersection), smooth.error.intersection + 1e-15) << k;
    ASSERT_LE(std::fabs(smooth.areas.c2_minus_c1 - outside), smooth.error.c2_minus_c1 + 1e-15) << k;
    ASSERT_LE(std::fabs(smooth.areas.c1_minus_c2 - exact.c1_minus_c2), smooth.error.c1_minus_c2 + 1e-15) << k;
    const double side1 = 2 * pi / n1, side2 = 2 * pi * r / n2;
    widest = std::max(widest, smooth.error.intersection / (side1 * side1 * side1 + side2 * side2 * side2 / r));
  }
  EXPECT_LT(widest, 1);  // sides times what they bend by
}

TEST(Smooth, ThousandLobesThatPolygonsMissAreAllFound) {
  // Over the middle of each segment of a circle the other curve comes inside of it by less than the sagitta.
  const double lobes = 1000;
  const auto radius = [&](double angle) { return 1 - 2e-6 + 6e-6 * (1 - std::cos(lobes * angle)); };
  Points circle, other;
  for (int k = 0; k < 1000; ++k) {
    const double angle = (k + 0.5) * 2 * pi / 1000;
    circle.push_back({std::cos(angle), std::sin(angle)});
  }
  for (int k = 0; k < 60000; ++k) {
    const double angle = k * 2 * pi / 60000;
    other.push_back({radius(angle) * std::cos(angle), radius(angle) * std::sin(angle)});
  }
  double inside = 0;  // of one lobe, in steps of equal angles
  const int steps = 1 << 16;
  for (int k = 0; k < steps; ++k)
    inside += pi / lobes / steps * std::max(1 - std::pow(radius((k + 0.5) * 2 * pi / lobes / steps), 2), 0.0);
  const SmoothAreas smooth = smooth_of(circle, other);
  EXPECT_EQ(smooth.areas.c1_minus_c2, 0);
  EXPECT_GE(smooth.error.c1_minus_c2, lobes * inside);
  EXPECT_LT(smooth.error.c1_minus_c2, 1.1 * lobes * inside);
}

TEST(Smooth, ArcsThatKeepTheirDistanceHaveNoMoreBar) {
  // Closer together than their segments' sagittas, and never nearer than to a tenth of these.
  const Points outer = sample(ellipse(0, 0, 1 + 1e-3, 1 + 1e-3), 50), inner = sample(ellipse(0, 0, 1, 1), 50);
  const SmoothAreas smooth = smooth_of(outer, inner);
  EXPECT_LT(smooth.error.c1_minus_c2, 1.5 * (smooth.error.c1 + smooth.error.c2));
  // A crossing of a lens has its bar where it is, however the polygons go on.
  const SmoothAreas crossing = smooth_of(sample(ellipse(0, 0, 1, 1), 400), sample(ellipse(0.03, 0, 1, 1), 400, 0.713));
  EXPECT_LT(crossing.error.intersection, 1e-9);
}

TEST(Smooth, NearTangentCurvesKeepTheirBar) {
  // Lobes down to a thousandth of the sagitta of a segment, which polygons get wrong altogether.
  for (const double depth : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const Points c1 = sample(ellipse(0, 0, 1, 1), 400), c2 = sample(ellipse(2 - depth, 0, 1, 1), 400, 0.713);
    const SmoothAreas smooth = smooth_of(c1, c2);
    const Areas exact = lens(2 - depth);
    EXPECT_LE(std::fabs(smooth.areas.intersection - exact.intersection), smooth.error.intersection) << depth;
  }
  const Points wave = sample(wavy(1e-6, 40), 1000), circle = sample(ellipse(0, 0, 1, 1), 1000, 0.6);
  const SmoothAreas smooth = smooth_of(wave, circle);
  EXPECT_LE(std::fabs(smooth.areas.symmetric_difference - waves(1e-6).symmetric_difference),
            smooth.error.symmetric_difference);
}

TEST(Smooth, SameBitsForAnyNumberOfThreads) {
  const Points c1 = sample(wavy(0.05, 61), 20000), c2 = sample(ellipse(0, 0, 1, 1), 20000);
  const Overlay result = overlay(CurveView{c1}, CurveView{c2});
  const SmoothAreas one = with_threads(1, [&] { return smooth_areas(result); });
  for (const int threads : {2, 7}) {
    const SmoothAreas more = with_threads(threads, [&] { return smooth_areas(result); });
    expect_equal(more.areas, one.areas);
    expect_equal(more.error, one.error);
  }
}

TEST(Smooth, AnyScale) {
  const Points c1 = sample(wavy(0.1, 5), 300), c2 = sample(ellipse(0, 0, 1, 1), 300);
  const Areas plain = smooth_of(c1, c2).areas;
  for (const int exponent : {-500, 500, 20}) {
    const auto scaled = [&](Points points) {
      for (Point& p : points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
      return points;
    };
    const Areas areas = smooth_of(scaled(c1), scaled(c2)).areas;
    for (const auto member : members) EXPECT_NEAR(std::ldexp(areas.*member, -2 * exponent), plain.*member, 1e-15);
  }
}

TEST(Smooth, AreaOfOneCurve) {
  Points wave = sample(wavy(0.1, 5), 1000);
  const double area = pi * (1 + 0.1 * 0.1 / 2);
  for (const double orientation : {1.0, -1.0}) {
    for (const int exponent : {0, -500}) {
      Points scaled = wave;
      for (Point& p : scaled) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
      const SmoothArea found = smooth_area(CurveView{scaled});
      EXPECT_NEAR(std::ldexp(found.area, -2 * exponent), orientation * area, 1e-11);
      EXPECT_LE(std::fabs(std::ldexp(found.area, -2 * exponent) - orientation * area),
                std::ldexp(found.error, -2 * exponent));
      EXPECT_EQ(found.fallback_segments, 0U);
    }
    std::reverse(wave.begin(), wave.end());
  }
}

// Coordinates far from the origin are rounded: circles of radius 1 whose centres are 1e8 away.
TEST(Smooth, BarsHoldTheRoundingOfVertices) {
  for (const std::size_t size : {50U, 200U, 1000U, 10000U}) {
    for (int turn = 0; turn < 20; ++turn) {
      for (const double offset : {1e3, 1e6, 1e8}) {
        const double x = offset + 0.37 * turn, y = offset - 0.61 * turn;
        Points circle(size);
        for (std::size_t k = 0; k < size; ++k) {
          const double angle = 2 * pi * (static_cast<double>(k) + 0.05 * turn) / static_cast<double>(size);
          circle[k] = {x + std::cos(angle), y + std::sin(angle)};
        }
        const SmoothArea found = smooth_area(CurveView{circle});
        EXPECT_LE(std::fabs(found.area - pi), found.error) << size << ' ' << offset << ' ' << turn;
        EXPECT_LT(found.error, 1e-3);
      }
    }
  }
}

}  // namespace
}  // namespace lober::smooth_test

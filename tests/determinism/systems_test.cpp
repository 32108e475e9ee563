// Windings, classes, images, orbits, level curves, Melnikov's function and tubes: the same bits whatever the threads,
// the instruction set and, where crossings are searched, the index.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "lober/dynamics/levels.hpp"
#include "lober/dynamics/manifolds.hpp"
#include "lober/dynamics/orbits.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/transport/escape.hpp"
#include "lober/transport/melnikov.hpp"
#include "tests/determinism/hash.hpp"
#include "tests/determinism/variations.hpp"

namespace lober::detail {
namespace {

using std::numbers::pi;

// exp(2 i t) + a exp(5 i t), which crosses itself.
std::vector<Point> loops(std::size_t count, double a) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = 2 * pi * static_cast<double>(k) / static_cast<double>(count);
    points.push_back({std::cos(2 * t) + a * std::cos(5 * t), std::sin(2 * t) + a * std::sin(5 * t)});
  }
  return points;
}

// A circle with `waves` waves.
std::vector<Point> flower(std::size_t count, int waves, double depth, double phase) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = 2 * pi * static_cast<double>(k) / static_cast<double>(count);
    const double r = 1 + depth * std::cos(waves * t + phase);
    points.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return points;
}

TEST(SystemsDeterminism, Windings) {
  const std::vector<Point> curve = loops(100'000, 0.55);
  const Buffer<Point> at = spread_points(Rectangle::of({-1.6, -1.6}, {1.6, 1.6}), 20'000);
  std::size_t inside = 0;
  expect_same(false, [&](IndexKind) {
    const IndexedCurve indexed(ClosedCurve::borrow(curve));
    Hash hash;
    inside = 0;
    for (const Winding& winding : windings(indexed, at)) {
      hash.add(winding.number);
      hash.add(winding.on);
      inside += winding.number != 0 ? 1U : 0U;
    }
    for (const InteriorValue& value : interior_function(indexed, std::span<const Point>(at).first(500))) {
      hash.add(value.j);
    }
    return hash.value();
  });
  EXPECT_GT(inside, 1'000U);
}

TEST(SystemsDeterminism, ClassesOfCrossings) {
  const std::vector<Point> one = flower(60'000, 900, 0.2, 0), other = flower(60'000, 1100, 0.2, 1);
  std::size_t steps = 0;
  expect_same(true, [&](IndexKind index) {
    OverlayOptions options;
    options.index = index;
    const Overlay found = overlay(ClosedCurve::borrow(one), ClosedCurve::borrow(other), options);
    Hash hash;
    for (const Pairing pairing : {Pairing::c1_minus_c2, Pairing::c2_minus_c1}) {
      const std::vector<SigmaStep> list = sigma_steps(found, pairing);
      steps = list.size();
      for (const SigmaStep& step : list) {
        hash.add(step.sigma);
        hash.add(step.class_number);
        hash.add(step.s);
      }
    }
    return hash.value();
  });
  EXPECT_GT(steps, 1'000U);
}

TEST(SystemsDeterminism, ImagesOfACurve) {
  const System system = make_system("duffing");
  const std::vector<Point> circle = flower(40, 1, 0, 0);
  ImageOptions options;
  options.tolerance = 1e-5;
  std::size_t points = 0;
  expect_same(false, [&](IndexKind) {
    Hash hash;
    points = 0;
    for (const CurveImage& image : images_of(*system.map, -2, 2, CurveView{circle, true}, options)) {
      hash.add_all(image.points);
      hash.add_all(image.parameters);
      points += image.points.size();
    }
    return hash.value();
  });
  EXPECT_GT(points, 1'000U);
}

// Orbits of a map, a stroboscopic map, and return maps with an energy and with angles.
TEST(SystemsDeterminism, OrbitsOnSections) {
  for (const char* name : {"standard", "pendulum", "capsize", "abc"}) {
    SCOPED_TRACE(name);
    const System system = make_system(name);
    const Buffer<Point> starts = spread_points(system.window, 100);
    const OrbitOptions options{.iterates = 20,
                               .lattice = system.lattice,
                               .origin = {system.window.min_x, system.window.min_y},
                               .second_lattice = system.second_lattice};
    std::size_t finite = 0;
    expect_same(false, [&](IndexKind) {
      Hash hash;
      finite = 0;
      follow_orbits(*system.map, starts, options, [&](std::size_t, std::span<const Point> points) {
        for (const Point& point : points) {
          const bool known = std::isfinite(point.x);
          finite += known ? 1U : 0U;
          hash.add(known ? point : Point{});  // a NaN has many bit patterns
        }
        return true;
      });
      return hash.value();
    });
    EXPECT_GT(finite, 500U);
  }
}

TEST(SystemsDeterminism, LevelCurves) {
  const System system = make_system("capsize");
  std::size_t points = 0;
  expect_same(false, [&](IndexKind) {
    const LevelGrid grid(energy_of(*system.flow, 0), Rectangle::of({-1.8, -0.8}, {1.8, 1.4}), 300, 200);
    Hash hash;
    points = 0;
    for (const double level : {0.1, 0.22, 0.28}) {
      for (const LevelCurve& curve : grid.curves(level)) {
        hash.add_all(curve.points);
        hash.add(curve.closed);
        points += curve.points.size();
      }
    }
    return hash.value();
  });
  EXPECT_GT(points, 500U);
}

TEST(SystemsDeterminism, MelnikovsFunction) {
  for (const char* name : {"pendulum", "ovp"}) {
    SCOPED_TRACE(name);
    expect_same(false, [&](IndexKind) {
      const FlowFamily family = [&](double eps) { return make_system(name, {{"eps", eps}}).flow; };
      const Melnikov found = melnikov(family, *make_system(name).connection);
      EXPECT_EQ(found.zeros.size(), 2U);
      Hash hash;
      hash.add_all(found.cosines);
      hash.add_all(found.sines);
      for (const double number : {found.period, found.error, found.largest}) hash.add(number);
      for (const MelnikovZero& zero : found.zeros) {
        hash.add(zero.t0);
        hash.add(zero.slope);
      }
      for (const MelnikovLobe& lobe : found.lobes) hash.add(lobe.integral);
      return hash.value();
    });
  }
}

TEST(SystemsDeterminism, TubesOfBottlenecks) {
  const System ship = make_system("capsize");
  EscapeOptions options;
  options.tolerance = 1e-4;
  std::size_t points = 0;
  expect_same(false, [&](IndexKind) {
    Hash hash;
    points = 0;
    for (const Bottleneck& found : bottlenecks(*ship.flow, *ship.section, 0.25307, ship.saddles, options)) {
      for (const double number : {found.orbit.period, found.orbit.action, found.multiplier, found.area}) {
        hash.add(number);
      }
      for (const auto* curves : {&found.entry, &found.exit}) {
        for (const TubeCurve& curve : *curves) {
          hash.add_all(curve.image.points);
          hash.add(curve.area);
          hash.add(curve.area_error);
          points += curve.image.points.size();
        }
      }
    }
    return hash.value();
  });
  EXPECT_GT(points, 100U);
}

}  // namespace
}  // namespace lober::detail

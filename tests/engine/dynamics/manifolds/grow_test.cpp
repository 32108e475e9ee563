#include "lober/dynamics/manifolds.hpp"
#include "tests/views.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <thread>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/box.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/shifted_map.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/smooth.hpp"
#include "tests/distance.hpp"
#include "tests/engine/dynamics/test_maps.hpp"

namespace lober::detail {
namespace {

using test::HenonMap;
using test::StandardMap;

struct Sagittas {
  double worst = 0;           // in units of the tolerance
  double optimal_points = 0;  // of a polygon whose every segment is as far off as allowed: sum of sqrt(distance / e)
};

// The true distance of the curve from each segment, by sixteen points between its ends.
Sagittas measured(const PlanarMap& map, const LocalManifold& local, const GrownManifold& grown, double tolerance) {
  Sagittas result;
  const bool inverse = local.multiplier < 0;
  const double ratio = inverse ? local.multiplier * local.multiplier : local.multiplier;
  for (std::size_t k = 0; k + 1 < grown.generation_begin.size(); ++k) {
    for (std::size_t i = std::max<std::size_t>(grown.generation_begin[k], 1); i < grown.generation_begin[k + 1]; ++i) {
      const double to = grown.parameters[i];
      const double from = grown.parameters[i - 1] / (i == grown.generation_begin[k] ? ratio : 1);
      double most = 0;
      for (int j = 1; j < 16; ++j) {
        Point point = local.at(from + (to - from) * j / 16);
        map.iterate({&point, 1}, static_cast<int>(k) * local.steps * (inverse ? 2 : 1));
        most = std::max(most, distance_to_segment(point, grown.points[i - 1], grown.points[i]));
      }
      result.worst = std::max(result.worst, most / tolerance);
      result.optimal_points += std::sqrt(most / tolerance);
    }
  }
  return result;
}

struct GrowCase {
  const char* name;
  double k;
  Point saddle;
  ManifoldSide side;
  Branch branch;
  int iterates;
};

TEST(Grow, MeetsTheToleranceWithFewPoints) {
  const GrowCase cases[] = {{"unstable", 1.2, {0, 0}, ManifoldSide::unstable, Branch::plus, 6},
                            {"stable", 1.2, {2 * std::numbers::pi, 0}, ManifoldSide::stable, Branch::minus, 6},
                            {"slow", 0.1, {0, 0}, ManifoldSide::unstable, Branch::plus, 12},
                            {"inverse saddle", 5, {std::numbers::pi, 0}, ManifoldSide::unstable, Branch::minus, 3}};
  for (const GrowCase& c : cases) {
    const StandardMap map(c.k);
    const LocalManifold local = local_manifold(map, c.saddle, c.side);
    for (const double tolerance : {1e-4, 1e-6}) {
      const GrownManifold grown =
          grow(map, local, c.branch, {.tolerance = tolerance, .iterates = c.iterates, .max_length = 1});
      EXPECT_EQ(grown.stop, GrowthStop::iterates);
      EXPECT_TRUE(grown.diagnostics.empty()) << c.name;
      const Sagittas sagittas = measured(map, local, grown, tolerance);
      // The distance is estimated; estimates are good where the tolerance is far below the radius of the folds.
      EXPECT_LE(sagittas.worst, tolerance > 1e-5 ? 1.25 : 1.0) << c.name << ' ' << tolerance;
      EXPECT_LE(static_cast<double>(grown.points.size()), (tolerance > 1e-5 ? 1.3 : 1.15) * sagittas.optimal_points)
          << c.name << ' ' << tolerance;
    }
  }
}

// Folds that lie where one generation ends and the next begins, which neither sees whole: the distance was up to 7.7
// tolerances.
TEST(Grow, ToleranceHoldsBetweenGenerations) {
  for (const double k : {0.3, 0.5, 0.7, 1.2, 2.5}) {
    const StandardMap map(k);
    for (const ManifoldSide side : all_manifold_sides) {
      const LocalManifold local = local_manifold(map, {0, 0}, side);
      for (const double tolerance : {1e-3, 1e-4}) {
        for (const Branch branch : {Branch::plus, Branch::minus}) {
          const GrownManifold grown = grow(map, local, branch, {.tolerance = tolerance, .length = 40});
          EXPECT_LE(measured(map, local, grown, tolerance).worst, 1.7)
              << k << ' ' << tolerance << ' ' << static_cast<int>(branch);
        }
      }
    }
  }
}

TEST(Grow, VerticesAreExactImages) {
  const StandardMap map(1.2);
  const LocalManifold local = local_manifold(map, {0, 0}, ManifoldSide::unstable);
  const GrownManifold grown = grow(map, local, Branch::minus, {.tolerance = 1e-4, .iterates = 5});
  ASSERT_EQ(grown.generation_begin.size(), 7U);
  EXPECT_EQ(grown.points[0], local.saddle);
  for (std::size_t k = 0; k + 1 < grown.generation_begin.size(); ++k) {
    for (std::size_t i = std::max<std::size_t>(grown.generation_begin[k], 1); i < grown.generation_begin[k + 1]; ++i) {
      Point point = local.at(grown.parameters[i]);
      map.iterate({&point, 1}, static_cast<int>(k));
      ASSERT_EQ(grown.points[i], point) << i;
      if (i > grown.generation_begin[k]) {
        ASSERT_LT(grown.parameters[i], grown.parameters[i - 1]);
      }
    }
  }
}

TEST(Grow, ManifoldsOfOneSaddleBeginInOnePoint) {
  const System duffing = make_system("duffing", {{"omega", 2}});
  const Point guess = duffing.connection->from;
  const LocalManifold u = local_manifold(*duffing.map, guess, ManifoldSide::unstable);
  const LocalManifold s = local_manifold(*duffing.map, guess, ManifoldSide::stable);
  const GrowthOptions options{.tolerance = 1e-4, .iterates = 1};
  EXPECT_EQ(grow(*duffing.map, u, Branch::plus, options).points[0],
            grow(*duffing.map, s, Branch::plus, options).points[0]);
}

TEST(Grow, ImagesAreNotComputedTwice) {
  const StandardMap map(1.2);
  const LocalManifold local = local_manifold(map, {0, 0}, ManifoldSide::unstable);
  const GrownManifold grown = grow(map, local, Branch::plus, {.tolerance = 1e-6, .iterates = 6});
  double bare = 0;
  for (std::size_t k = 1; k + 1 < grown.generation_begin.size(); ++k) {
    bare += static_cast<double>(k * (grown.generation_begin[k + 1] - grown.generation_begin[k]));
  }
  EXPECT_LE(static_cast<double>(grown.images), 1.15 * bare);
}

// The manifold that one thread grows, and any other number of threads to the bit.
GrownManifold grown_by_any_threads(const PlanarMap& map, const LocalManifold& local, Branch branch,
                                   const GrowthOptions& options) {
  GrownManifold one = with_threads(1, [&] { return grow(map, local, branch, options); });
  for (const int threads : {2, 7}) {
    const GrownManifold other = with_threads(threads, [&] { return grow(map, local, branch, options); });
    EXPECT_EQ(one.points, other.points);
    EXPECT_EQ(one.parameters, other.parameters);
    EXPECT_EQ(one.generation_begin, other.generation_begin);
    EXPECT_EQ(one.diagnostics, other.diagnostics);
    EXPECT_EQ(one.length, other.length);
    EXPECT_EQ(one.images, other.images);
    EXPECT_EQ(one.stop, other.stop);
  }
  return one;
}

TEST(Grow, SameBitsForAnyNumberOfThreads) {
  const HenonMap map(0.5);
  const LocalManifold local = local_manifold(map, {2.2, 2.2}, ManifoldSide::unstable);
  const GrowthOptions options{.tolerance = 1e-6, .iterates = 6, .box = Box::of({-5, -5}, {5, 5})};
  EXPECT_GT(grown_by_any_threads(map, local, Branch::minus, options).points.size(), 10'000U);
}

// Outside of the box segments are long: of those that cross its edge only what lies inside counts.
TEST(Grow, LengthEndsAtTheEdgesOfTheBox) {
  const HenonMap map(0.5);
  const LocalManifold local = local_manifold(map, {2.2, 2.2}, ManifoldSide::stable);
  const Box box = Box::of({-1, -1}, {1, 1});
  const GrownManifold grown = grow(map, local, Branch::minus, {.tolerance = 1e-4, .iterates = 7, .box = box});
  double inside = 0, whole = 0;
  constexpr int parts = 2000;
  for (std::size_t k = 0; k + 1 < grown.points.size(); ++k) {
    const Point a = grown.points[k], b = grown.points[k + 1];
    int met = 0;
    for (int part = 0; part < parts; ++part) {
      const double t = (part + 0.5) / parts;
      const Point p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      met += meet(Box::of(p, p), box) ? 1 : 0;
    }
    whole += distance(a, b);
    inside += distance(a, b) * met / parts;
  }
  EXPECT_GT(whole, 4 * inside);
  EXPECT_NEAR(grown.length, inside, 1e-3 * whole);
}

TEST(Grow, ReportsWhatEscapes) {
  const HenonMap map(0.5);
  const LocalManifold local = local_manifold(map, {2.2, 2.2}, ManifoldSide::unstable);
  const Box box = Box::of({-5, -5}, {5, 5});
  const GrownManifold grown = grow(map, local, Branch::minus, {.tolerance = 1e-4, .iterates = 14, .box = box});
  bool left = false;
  for (const GrowthDiagnostic& diagnostic : grown.diagnostics) {
    left = left || diagnostic.cause == GrowthDiagnosticCause::left_box;
    EXPECT_LE(diagnostic.first + diagnostic.count, grown.points.size() - 1);
  }
  EXPECT_TRUE(left);
  for (const Point point : grown.points) ASSERT_TRUE(std::isfinite(point.x) && std::isfinite(point.y));
  // The other branch goes straight to infinity.
  const GrownManifold gone = grow(map, local, Branch::plus, {.tolerance = 1e-4, .length = 1e9, .box = box});
  EXPECT_EQ(gone.stop, GrowthStop::failed);
  EXPECT_GT(gone.points.size(), 2U);
}

// A map whose orbits end at x = 8.
class Discontinuous : public StandardMap {
 public:
  using StandardMap::StandardMap;
  void iterate(std::span<Point> points, int iterates) const override {
    for (Point& point : points) {
      for (int n = 0; n < iterates; ++n) {
        StandardMap::iterate({&point, 1}, 1);
        if (point.x > 8) point = {std::nan(""), std::nan("")};
      }
    }
  }
};

TEST(Grow, GoesOnBehindTears) {
  const LocalManifold local = local_manifold(StandardMap(1.2), {0, 0}, ManifoldSide::unstable, {.max_length = 1});
  const GrownManifold grown = grow(Discontinuous(1.2), local, Branch::plus, {.tolerance = 1e-4, .iterates = 8});
  const GrownManifold whole = grow(StandardMap(1.2), local, Branch::plus, {.tolerance = 1e-4, .iterates = 8});
  EXPECT_EQ(grown.stop, GrowthStop::iterates);
  EXPECT_LT(grown.points.size(), whole.points.size());
  std::size_t tears = 0;
  for (const GrowthDiagnostic& diagnostic : grown.diagnostics) {
    EXPECT_EQ(diagnostic.cause, GrowthDiagnosticCause::failed);
    EXPECT_EQ(diagnostic.count, 1U);
    tears += diagnostic.count;
    // Both ends of the tear are followed until nothing more of the curve is to be had.
    if (tears == 1) {
      EXPECT_NEAR(grown.points[diagnostic.first].x, 8, 1e-4);
    }
  }
  EXPECT_GT(tears, 0U);
  for (const Point point : grown.points) ASSERT_LE(point.x, 8);  // and so finite
}

TEST(Grow, Stops) {
  const StandardMap map(1.2);
  const LocalManifold local = local_manifold(map, {0, 0}, ManifoldSide::unstable);
  const GrownManifold by_length = grow(map, local, Branch::plus, {.tolerance = 1e-5, .length = 40});
  EXPECT_EQ(by_length.stop, GrowthStop::length);
  EXPECT_GE(by_length.length, 40);
  EXPECT_LT(by_length.length, 40.5);
  const GrownManifold by_points =
      grow(map, local, Branch::plus, {.tolerance = 1e-6, .length = 1e9, .max_points = 5000});
  EXPECT_EQ(by_points.stop, GrowthStop::points);
  EXPECT_LE(by_points.points.size(), 5000U);
  EXPECT_GT(by_points.points.size(), 4000U);
  const GrownManifold by_memory =
      grow(map, local, Branch::plus, {.tolerance = 1e-6, .length = 1e9, .max_memory = 600'000});
  EXPECT_EQ(by_memory.points, by_points.points);
  // The points that there are agree with a longer run.
  const GrownManifold longer = grow(map, local, Branch::plus, {.tolerance = 1e-5, .length = 60});
  ASSERT_GT(longer.points.size(), by_length.generation_begin[2]);
  EXPECT_TRUE(std::equal(by_length.points.begin(),
                         by_length.points.begin() + static_cast<std::ptrdiff_t>(by_length.generation_begin[2]),
                         longer.points.begin()));
  int calls = 0;
  const GrownManifold cancelled =
      grow(map, local, Branch::plus, {.tolerance = 1e-6, .iterates = 8, .progress = [&](const GrowthProgress& at) {
                                        ++calls;
                                        return at.iterates < 3;
                                      }});
  EXPECT_EQ(cancelled.stop, GrowthStop::cancelled);
  EXPECT_GT(calls, 3);
  EXPECT_GE(cancelled.generation_begin.size(), 4U);
  EXPECT_GT(cancelled.points.size(), 1000U);
}

// The last vertex is where the length is reached, and an image of its own parameter like any other.
TEST(Grow, EndsAtTheLength) {
  const HenonMap henon(0.5);
  const StandardMap standard(1.2);
  const Point of_henon{1 + std::sqrt(1.5), 1 + std::sqrt(1.5)};
  const auto expect_end = [](const PlanarMap& map, Point saddle, ManifoldSide side, double length, double tolerance) {
    const LocalManifold local = local_manifold(map, saddle, side);
    const GrownManifold grown = grow(map, local, Branch::plus, {.tolerance = tolerance, .length = length});
    EXPECT_EQ(grown.stop, GrowthStop::length);
    EXPECT_GE(grown.length, length);
    EXPECT_LE(grown.length, length * (1 + 1e-8)) << length;
    double sum = 0;
    for (std::size_t k = 1; k < grown.points.size(); ++k) sum += distance(grown.points[k - 1], grown.points[k]);
    EXPECT_NEAR(sum, grown.length, 1e-9 * length);
    Point last = local.at(grown.parameters.back());
    map.iterate({&last, 1}, static_cast<int>(grown.generation_begin.size() - 2) * local.image().steps);
    EXPECT_LE(distance(last, grown.points.back()), 1e-9) << length;
  };
  for (const ManifoldSide side : all_manifold_sides) {
    for (const double length : {1e-6, 1e-3, 0.05, 0.3, 1.0, 3.0}) {
      for (const double tolerance : {1e-6, 1e-2}) {
        expect_end(henon, of_henon, side, length, tolerance);
        expect_end(standard, {0, 0}, side, length, tolerance);
      }
    }
  }
}

TEST(Grow, KeepsToTheNumberOfPoints) {
  const StandardMap map(1.2);
  const LocalManifold local = local_manifold(map, {0, 0}, ManifoldSide::unstable);
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    for (const std::size_t points : {2U, 3U, 4U, 5U, 7U, 16U, 50U, 100U, 333U, 1000U, 2001U, 20'000U}) {
      const GrownManifold grown =
          grow(map, local, Branch::plus, {.tolerance = tolerance, .length = 1e5, .max_points = points});
      EXPECT_EQ(grown.stop, GrowthStop::points);
      EXPECT_LE(grown.points.size(), points);
      EXPECT_GE(static_cast<double>(grown.points.size()), points < 50 ? 2 : 0.8 * static_cast<double>(points));
      EXPECT_EQ(grown.parameters.size(), grown.points.size());
      EXPECT_EQ(grown.generation_begin.back(), grown.points.size());
      double sum = 0;
      for (std::size_t k = 1; k < grown.points.size(); ++k) sum += distance(grown.points[k - 1], grown.points[k]);
      EXPECT_NEAR(sum, grown.length, 1e-9 * sum);
    }
  }
}

// Long generations are traced in sections side by side: a limit ends them where it would end them one by one.
TEST(Grow, LimitsEndSectionsAtTheSamePointForAnyNumberOfThreads) {
  const StandardMap map(1.2);
  const LocalManifold local = local_manifold(map, {0, 0}, ManifoldSide::unstable);
  const GrowthOptions whole{.tolerance = 1e-8, .iterates = 8};
  const GrownManifold all = grow(map, local, Branch::plus, whole);
  ASSERT_GT(all.points.size(), 200'000U);
  const auto expect_prefix = [&](GrowthOptions options, GrowthStop stop) {
    GrownManifold one = grown_by_any_threads(map, local, Branch::plus, options);
    EXPECT_EQ(one.stop, stop);
    EXPECT_GT(one.points.size(), 100'000U);
    EXPECT_LT(one.points.size(), all.points.size());
    // Where a limit cuts a guide, points are placed anew.
    const std::size_t alike = one.points.size() - 60'000;
    EXPECT_TRUE(
        std::equal(one.points.begin(), one.points.begin() + static_cast<std::ptrdiff_t>(alike), all.points.begin()));
    return one;
  };
  GrowthOptions options = whole;
  options.length = 0.8 * all.length;
  const GrownManifold by_length = expect_prefix(options, GrowthStop::length);
  EXPECT_GE(by_length.length, options.length);
  EXPECT_LT(by_length.length, options.length + 0.1);
  options = whole;
  options.max_points = all.points.size() * 4 / 5;
  const GrownManifold by_points = expect_prefix(options, GrowthStop::points);
  EXPECT_LE(by_points.points.size(), options.max_points);
  EXPECT_GT(static_cast<double>(by_points.points.size()), 0.99 * static_cast<double>(options.max_points));
  options.whole_pieces = true;
  const GrownManifold pieces = expect_prefix(options, GrowthStop::points);
  EXPECT_EQ(pieces.points.size(), all.generation_begin[8]);
  options = whole;
  options.max_images = all.images * 4 / 5;
  expect_prefix(options, GrowthStop::points);
  options = whole;
  options.max_work = 0.8 * static_cast<double>(all.images);
  expect_prefix(options, GrowthStop::work);
}

TEST(Grow, ProgressIsCalledFromTheCallingThread) {
  const StandardMap map(1.2);
  const LocalManifold local = local_manifold(map, {0, 0}, ManifoldSide::unstable);
  const std::thread::id caller = std::this_thread::get_id();
  std::size_t calls = 0, most = 0;
  bool from_others = false;
  GrowthOptions options{.tolerance = 1e-8, .iterates = 8};
  options.progress = [&](const GrowthProgress& at) {
    ++calls;
    from_others = from_others || std::this_thread::get_id() != caller;
    EXPECT_GE(at.points, most);
    most = at.points;
    return at.points < 100'000;
  };
  const GrownManifold grown = grow(map, local, Branch::plus, options);
  EXPECT_EQ(grown.stop, GrowthStop::cancelled);
  EXPECT_GT(calls, 10U);
  EXPECT_FALSE(from_others);
}

// The stable branch of the oscillating vortex pair on the line y = 0 runs into the other saddle.
TEST(Grow, ABranchMayEnd) {
  const System system = make_system("ovp");
  const LocalManifold local = local_manifold(*system.map, {1.45, 0}, ManifoldSide::stable);
  const GrownManifold grown = grow(*system.map, local, Branch::minus, {.tolerance = 1e-3, .length = 4});
  EXPECT_EQ(grown.stop, GrowthStop::ended);
  EXPECT_NEAR(grown.length, 2 * 1.451260038107551142, 1e-3);
  EXPECT_NEAR(grown.points.back().x, -1.451260038107551142, 1e-3);
}

// The distance of points in a box from a polygon that is fine there only, for every eighth of them.
double farthest_in_box(std::span<const Point> points, const Box& box, std::span<const Point> polygon) {
  double farthest = 0;
  for (std::size_t i = 0; i < points.size(); i += 8) {
    const Point p = points[i];
    if (!meet(Box::of(p, p), box)) continue;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < polygon.size(); ++k) {
      if (!meet(Box::of(polygon[k], polygon[k + 1]), box)) continue;
      nearest = std::min(nearest, distance_to_segment(p, polygon[k], polygon[k + 1]));
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

// A manifold that leaves the box, is followed coarsely there and comes back between two points.
TEST(Grow, NothingOfABoxIsLost) {
  const System duffing = make_system("duffing");
  const LocalManifold local = local_manifold(*duffing.map, duffing.connection->from, ManifoldSide::unstable);
  const Box box = Box::of({-0.3, -0.3}, {0.3, 0.3});
  for (const Branch branch : {Branch::plus, Branch::minus}) {
    const GrownManifold fine = grow(*duffing.map, local, branch, {.tolerance = 1e-5, .iterates = 3});
    const GrownManifold boxed = grow(*duffing.map, local, branch, {.tolerance = 1e-4, .iterates = 3, .box = box});
    EXPECT_LT(boxed.points.size(), fine.points.size());
    EXPECT_LT(farthest_in_box(fine.points, box, boxed.points), 1.2e-4);
  }
}

TEST(ImageOf, NothingOfABoxIsLost) {
  const System duffing = make_system("duffing");
  const Box box = Box::of({-0.3, -0.3}, {0.3, 0.3});
  const CurveFunction circle = [](std::span<const double> t, std::span<Point> points) {
    for (std::size_t k = 0; k < t.size(); ++k) points[k] = {0.6 * std::cos(t[k]) - 1, 0.6 * std::sin(t[k])};
  };
  const std::array<double, 2> ends{0, 2 * std::numbers::pi};
  const CurveImage fine = image_of(*duffing.map, 4, circle, ends, {.tolerance = 1e-5});
  const CurveImage boxed = image_of(*duffing.map, 4, circle, ends, {.tolerance = 1e-4, .box = box});
  EXPECT_LT(boxed.points.size(), fine.points.size());
  EXPECT_LT(farthest_in_box(fine.points, box, boxed.points), 1.2e-4);
}

// The saddle lies outside of the box.
TEST(Grow, ReachesABoxFarFromTheSaddle) {
  const HenonMap map(0.5);
  const LocalManifold local = local_manifold(map, {2.2, 2.2}, ManifoldSide::unstable);
  const Box box = Box::of({0, 0}, {1, 1});
  const GrownManifold fine = grow(map, local, Branch::minus, {.tolerance = 1e-5, .iterates = 6});
  const GrownManifold boxed = grow(map, local, Branch::minus, {.tolerance = 1e-4, .iterates = 6, .box = box});
  EXPECT_EQ(boxed.stop, GrowthStop::iterates);
  EXPECT_GT(boxed.length, 1);
  EXPECT_LT(farthest_in_box(fine.points, box, boxed.points), 1.2e-4);
  const GrownManifold gone = grow(map, local, Branch::plus, {.tolerance = 1e-4, .length = 1e9, .box = box});
  EXPECT_EQ(gone.stop, GrowthStop::failed);
}

// A separatrix ends in the other saddle; what rounding makes of it from there on is followed as far as work allows.
TEST(Grow, EndsWithItsWork) {
  const System pendulum = make_system("pendulum", {{"eps", 0}});
  const LocalManifold local = local_manifold(*pendulum.map, pendulum.connection->from, ManifoldSide::unstable);
  const GrowthOptions options{.tolerance = 1e-5, .length = 20, .max_work = 3e6};
  const GrownManifold grown = grow(*pendulum.map, local, Branch::plus, options);
  EXPECT_EQ(grown.stop, GrowthStop::work);
  EXPECT_GT(grown.length, 6);
  const GrownManifold same = with_threads(3, [&] { return grow(*pendulum.map, local, Branch::plus, options); });
  EXPECT_EQ(grown.points, same.points);
}

TEST(ImageOf, EndsWithItsWork) {
  const System duffing = make_system("duffing");
  const std::vector<Point> square{{1, -1}, {1.5, -1}, {1.5, 1}, {1, 1}};
  const std::vector<CurveImage> images =
      images_of(*duffing.map, 0, 9, CurveView{square}, {.tolerance = 1e-6, .max_work = 1e6});
  ASSERT_GT(images.size(), 1U);
  ASSERT_LT(images.size(), 9U);
  EXPECT_EQ(images.back().stop, GrowthStop::work);
  EXPECT_TRUE(images.back().points.empty());
  EXPECT_EQ(images[images.size() - 2].stop, GrowthStop::iterates);
}

TEST(Grow, RefusesOptionsWithoutSense) {
  const StandardMap map(1.2);
  const LocalManifold local = local_manifold(map, {0, 0}, ManifoldSide::unstable);
  EXPECT_THROW((void)grow(map, local, Branch::plus, {.tolerance = 0, .iterates = 1}), UsageError);
  EXPECT_THROW((void)grow(map, local, Branch::plus, {.tolerance = 1e-5}), UsageError);
  EXPECT_THROW((void)grow(map, local, Branch::plus, {.tolerance = 1e-15, .iterates = 1}), UsageError);
  EXPECT_THROW((void)grow(map, local, Branch::plus, {.tolerance = 1e-5, .iterates = 1, .max_points = 1}), UsageError);
  EXPECT_THROW((void)grow(map, LocalManifold{}, Branch::plus, {.tolerance = 1e-5, .iterates = 1}), UsageError);
}

// ------------------------------------------------------------------------------------------- lobes

// The part of a curve from where x first is at or past `from` to where it is past `to`; either may be the larger.
std::vector<Point> part_between(const GrownManifold& curve, double from, double to) {
  std::vector<Point> part;
  const double sign = to > from ? 1 : -1;
  for (const Point point : curve.points) {
    if (sign * point.x > sign * to) break;
    if (sign * point.x >= sign * from) part.push_back(point);
  }
  return part;
}

struct LobeAreas {
  double polygon, smooth, error;
  std::size_t points;
};

// The lobe of the standard map between the pips q_B and q_A. Both arcs are graphs over x a little beyond the pips; the
// one that is below in between is closed far above, the other one far below, so that the lobe is what they share.
LobeAreas lobe(double k, Point q_b, Point q_a, double tolerance) {
  const StandardMap map(k);
  const LocalManifoldOptions near{.max_length = 0.5};  // so that it takes some growing
  const LocalManifold u = local_manifold(map, {0, 0}, ManifoldSide::unstable, near);
  const LocalManifold s = local_manifold(map, {2 * std::numbers::pi, 0}, ManifoldSide::stable, near);
  const GrowthOptions options{.tolerance = tolerance, .length = 6, .max_length = 1};
  const GrownManifold grown_u = grow(map, u, Branch::plus, options), grown_s = grow(map, s, Branch::minus, options);
  constexpr double beyond = 0.15;  // more than a segment, so that each arc reaches over both pips
  std::vector<Point> first = part_between(grown_u, q_b.x - beyond, q_a.x + beyond);
  std::vector<Point> second = part_between(grown_s, q_a.x + beyond, q_b.x - beyond);
  const std::size_t points = first.size() + second.size();
  const auto middle = [&](const std::vector<Point>& curve) {
    const double x = (q_a.x + q_b.x) / 2;
    return std::min_element(curve.begin(), curve.end(),
                            [&](Point a, Point b) { return std::fabs(a.x - x) < std::fabs(b.x - x); })
        ->y;
  };
  const double far = middle(first) < middle(second) ? 10 : -10;
  first.push_back({first.back().x, far});
  first.push_back({first.front().x, far});
  second.push_back({second.back().x, -far});
  second.push_back({second.front().x, -far});
  const Overlay result = overlay(CurveView{first}, CurveView{second});
  const SmoothAreas smooth = smooth_areas(result);
  return {result.areas.intersection, smooth.areas.intersection, smooth.error.intersection, points};
}

TEST(Grow, LobesOfTheStandardMap) {
  struct {
    double k;
    Point q_b, q_a;
    double area;
  } const lobes[] = {
      {1.2, {1.96284212884713, 1.24854584790906}, {std::numbers::pi, 1.91735321036680}, 0.05805630576704178}};
  for (const auto& expected : lobes) {
    // The error of polygons falls with the tolerance, that is with the square of the spacing.
    double error[3];
    for (int k = 0; k < 3; ++k) {
      const double tolerance = 1e-4 * std::pow(0.1, k);
      error[k] = std::fabs(lobe(expected.k, expected.q_b, expected.q_a, tolerance).polygon - expected.area);
      EXPECT_LE(error[k], 4 * tolerance);
    }
    EXPECT_LE(error[2], error[0] / 30);
    const LobeAreas fine = lobe(expected.k, expected.q_b, expected.q_a, 1e-8);
    EXPECT_LE(fine.points, 100'000U);
    EXPECT_NEAR(fine.smooth, expected.area, 1e-12 * expected.area) << fine.points << ' ' << fine.error;
  }
}

// The saddles of the resonance 1/3 go round the cylinder once in three iterates: their manifolds are those of the map
// up to that shift, at both signs of the multiplier of time, and every vertex is the image of its parameter.
TEST(Grow, ManifoldsOfAResonance) {
  const StandardMap map(0.9);
  const Point round{2 * std::numbers::pi, 0};
  const ShiftedMap up_to_round(map, 3, round);
  EXPECT_THROW((void)local_manifold(map, {0, 1.8}, ManifoldSide::unstable, {.period = 3}), DataError);
  for (const ManifoldSide side : all_manifold_sides) {
    const LocalManifold local = local_manifold(up_to_round, {0, 1.8}, side, {.period = 3});
    EXPECT_NEAR(local.saddle.y, 1.8024056274013, 1e-12);  // by a search for fixed points
    EXPECT_NEAR(local.multiplier, 2.42877906759, 1e-10);
    const GrownManifold grown = grow(up_to_round, local, Branch::plus, {.tolerance = 1e-6, .length = 8});
    ASSERT_EQ(grown.stop, GrowthStop::length);
    EXPECT_LE(measured(up_to_round, local, grown, 1e-6).worst, 1.5);
    for (std::size_t k = 0; k + 1 < grown.generation_begin.size(); ++k) {
      const std::size_t i = grown.generation_begin[k];
      Point point = local.at(grown.parameters[i]);
      map.iterate({&point, 1}, static_cast<int>(k) * local.steps);
      const double rounds = static_cast<double>(k) * (side == ManifoldSide::unstable ? 1 : -1);
      EXPECT_LE(distance(grown.points[i], {point.x - rounds * round.x, point.y}), 1e-11) << k;
    }
  }
  EXPECT_THROW(ShiftedMap(map, 0, round), UsageError);
  Point point{};
  EXPECT_THROW(up_to_round.iterate({&point, 1}, 4), UsageError);
}

}  // namespace
}  // namespace lober::detail

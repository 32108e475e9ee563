// Boundaries that the path which closes them crosses, of smooth curves: against polygons of many more points.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "lober/tangle/tangle.hpp"
#include "tests/engine/geometry/tangle/tangle_scenes.hpp"
#include "tests/environment.hpp"
#include "tests/oracle/random.hpp"
#include "tests/views.hpp"

namespace lober::detail {
namespace {

void expect_close_to(double found, double error, double fine, double fine_error, const std::string& of) {
  EXPECT_LE(std::fabs(found - fine), error + fine_error) << of;
}

// Boundary and parts of lobes of smooth curves against those of polygons, or of smooth curves, through many more points
// of the same curves.
void expect_covered(const Tangle& found, const Tangle& fine) {
  ASSERT_EQ(found.lobes.size(), fine.lobes.size());
  const std::vector<LobeShape> shapes = lobe_shapes(fine);
  const bool smooth = fine.boundary->smooth_error > 0;
  const double boundary = smooth ? fine.boundary->smooth_error : 2 * boundary_discretisation(fine);
  expect_close_to(found.boundary->area, found.boundary->smooth_error, fine.boundary->area, boundary, "boundary");
  for (std::size_t k = 0; k < fine.lobes.size(); ++k) {
    const Lobe &lobe = found.lobes[k], &other = fine.lobes[k];
    const double error = lobe.smooth_error + lobe.boundary_error;
    const double of_fine = smooth ? other.smooth_error + other.boundary_error : boundary + 2 * shapes[k].discretisation;
    expect_close_to(lobe.inside, error, other.inside, of_fine, "inside of lobe " + std::to_string(k));
    expect_close_to(lobe.outside, error, other.outside, of_fine, "outside of lobe " + std::to_string(k));
    EXPECT_NEAR(lobe.inside + lobe.outside, std::fabs(lobe.area), 1e-15);
  }
}

TEST(CrossedBoundary, HasTheAreaOfTheSmoothCurves) {
  const ManifoldPair pair = wave_and_arc(100), many = wave_and_arc(10000);
  const Tangle found = tangle(open(pair.u), open(pair.s), {.smooth = true});
  ASSERT_TRUE(found.boundary->crosses_itself);
  EXPECT_FALSE(found.boundary->of_polygons);
  // By quadrature of the curves themselves.
  EXPECT_LE(std::fabs(found.boundary->area - 0.1273334017), found.boundary->smooth_error);
  EXPECT_LE(found.boundary->smooth_error, 1e-7);
  for (const Lobe& lobe : found.lobes) EXPECT_LE(lobe.boundary_error, 1e-7);
  expect_covered(found, tangle(open(many.u), open(many.s)));
}

// Corners are none of smooth curves, however many there are.
TEST(CrossedBoundary, IsClosedByStraightLines) {
  const ManifoldPair pair = wave_and_arc(100), many = wave_and_arc(10000);
  TangleOptions options;
  for (int k = 12; k > 0; --k) options.closure.push_back({k / 12.0 - 0.02, k % 2 == 0 ? -0.17 : 0.15});
  for (std::size_t bip = 0; bip < 4; ++bip) {
    options.bip = bip;
    options.smooth = false;
    const Tangle fine = tangle(open(many.u), open(many.s), options);
    options.smooth = true;
    const Tangle found = tangle(open(pair.u), open(pair.s), options);
    ASSERT_TRUE(found.boundary->crosses_itself);
    EXPECT_FALSE(found.boundary->of_polygons);
    EXPECT_LE(found.boundary->smooth_error, 1e-7);
    expect_covered(found, fine);
  }
}

// The path runs along the manifolds, or touches them: polygons stand for smooth curves then, and their bar with them.
TEST(CrossedBoundary, SaysWherePolygonsStandForSmoothCurves) {
  const ManifoldPair pair = wave_and_arc(100), many = wave_and_arc(10000);
  TangleOptions options;
  options.closure = {{0.4, -0.2}, pair.u[120], pair.u[121], {0.1, -0.2}};
  const Tangle fine = tangle(open(many.u), open(many.s), options);
  options.smooth = true;
  const Tangle found = tangle(open(pair.u), open(pair.s), options);
  ASSERT_TRUE(found.boundary->crosses_itself);
  EXPECT_TRUE(found.boundary->of_polygons);
  EXPECT_FALSE(found.remarks.empty());
  EXPECT_LE(found.boundary->smooth_error, 1e-4);
  expect_covered(found, fine);
}

// A path that crosses itself and nothing else bounds what it winds round.
TEST(CrossedBoundary, ByThePathAlone) {
  const ManifoldPair pair = wave_and_arc(100), many = wave_and_arc(10000);
  TangleOptions options;
  options.closure = {{1.05, 0.5}, {0.5, 1}, {0.5, 0.5}, {1, 1}, {0, 1}};
  const Tangle fine = tangle(open(many.u), open(many.s), options);
  EXPECT_TRUE(fine.boundary->crosses_itself);
  EXPECT_GT(std::fabs(fine.boundary->area - std::fabs(swept_area(fine, fine.boundary->bip).area)), 0.01);
  options.smooth = true;
  expect_covered(tangle(open(pair.u), open(pair.s), options), fine);
}

struct RandomWave {
  std::vector<double> of_u, of_s;
  explicit RandomWave(oracle::Random& random) {
    for (int k = 0; k < 4; ++k) {
      of_u.push_back(random.uniform(-0.3, 0.3));
      of_s.push_back(random.uniform(-0.1, 0.1));
    }
  }
  [[nodiscard]] static double at(const std::vector<double>& wave, double x) {
    double y = 0;
    for (std::size_t k = 0; k < wave.size(); ++k) {
      const auto number = static_cast<double>(2 * k + 1);
      y += wave[k] * std::sin(number * 2.2 * x + number);
    }
    return y;
  }
  [[nodiscard]] ManifoldPair points(std::size_t segments) const {
    ManifoldPair pair;
    for (std::size_t k = 0; k <= segments; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(segments);
      pair.u.push_back({2 * t, at(of_u, 2 * t)});
      pair.s.push_back({2.1 - 2.05 * t, at(of_s, 2.1 - 2.05 * t)});
    }
    return pair;
  }
};

TEST(CrossedBoundary, BarsCoverTheErrorsOfRandomPaths) {
  oracle::Random random(from_environment("LOBER_SEED", 20261129));
  int crossed = 0, polygons = 0, compared = 0;
  for (int round = 0; round < 150; ++round) {
    const RandomWave wave(random);
    const ManifoldPair pair = wave.points(250), many = wave.points(25000);
    TangleOptions options;
    const auto corners = static_cast<int>(random.uniform(0, 11));
    for (int k = 0; k < corners; ++k) options.closure.push_back({random.uniform(-0.1, 2.2), random.uniform(-0.7, 0.7)});
    const Tangle fine = tangle(open(many.u), open(many.s), options);
    options.smooth = true;
    const Tangle found = tangle(open(pair.u), open(pair.s), options);
    if (!fine.boundary || found.lobes.size() != fine.lobes.size()) continue;
    ++compared;
    crossed += found.boundary->crosses_itself;
    polygons += found.boundary->of_polygons;
    SCOPED_TRACE(round);
    expect_covered(found, fine);
  }
  EXPECT_GT(compared, 100);
  EXPECT_GT(crossed, 50);
  EXPECT_LT(polygons, compared);
}

// Three harmonics.
class CalmWave {
 public:
  CalmWave(oracle::Random& random, double most) {
    for (std::size_t k = 0; k < height_.size(); ++k) {
      height_[k] = random.uniform(-most, most) / static_cast<double>(1 + k);
      phase_[k] = random.uniform(0, 6);
    }
  }
  [[nodiscard]] Point operator()(double x) const {
    double y = 0;
    for (std::size_t k = 0; k < height_.size(); ++k)
      y += height_[k] * std::sin(static_cast<double>(2 * k + 1) * 1.5 * x + phase_[k]);
    return {x, y};
  }

 private:
  std::array<double, 3> height_{}, phase_{};
};

// Both curves by 60 to 160 segments, closed by a path of up to two corners near the curves; and the same by twenty
// times as many.
struct SceneOfFewPoints {
  Tangle found, fine;
  explicit SceneOfFewPoints(std::uint64_t seed) {
    oracle::Random random(seed);
    const CalmWave wave_u(random, 0.4), wave_s(random, 0.15);
    const auto points = [&](std::size_t segments) {
      ManifoldPair pair;
      for (std::size_t k = 0; k <= segments; ++k) {
        const double t = static_cast<double>(k) / static_cast<double>(segments);
        pair.u.push_back(wave_u(2 * t));
        pair.s.push_back(wave_s(2.1 - 2.05 * t));
      }
      return pair;
    };
    const auto segments = static_cast<std::size_t>(random.integer(60, 160));
    const ManifoldPair pair = points(segments), many = points(20 * segments);
    TangleOptions options;
    options.smooth = true;
    for (int corners = random.integer(0, 2); corners > 0; --corners) {
      const std::vector<Point>& beside = random.chance(0.5) ? many.u : many.s;
      const Point at = beside[random.index(beside.size() / 2)];
      const double by = random.log_uniform(1e-4, 0.3);
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      options.closure.push_back({at.x + by * x, at.y + by * y});
    }
    // Both keep what they own.
    found = tangle(OpenCurve(pair.u), OpenCurve(pair.s), options);
    fine = tangle(OpenCurve(many.u), OpenCurve(many.s), options);
  }
  [[nodiscard]] bool comparable() const { return fine.boundary && found.lobes.size() == fine.lobes.size(); }
};

// An arc may begin on the other side of the path than its segment: both begin in the fixed point. Or it passes a leg of
// the path on the other side, near a crossing with another leg. Seven of these scenes show either.
TEST(CrossedBoundary, BarsCoverArcsBeyondThePath) {
  int compared = 0, polygons = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const SceneOfFewPoints scene(seed);
    if (!scene.comparable()) continue;
    ++compared;
    polygons += scene.found.boundary->of_polygons;
    SCOPED_TRACE(seed);
    expect_covered(scene.found, scene.fine);
  }
  EXPECT_GT(compared, 250);
  EXPECT_LT(polygons, 30);
}

// Where the path, U and S cross near one point, the smooth curves may have the crossings in another order than the
// polygons, also with one behind the last pip.
TEST(CrossedBoundary, BarsCoverCrossingsThatChangePlaces) {
  for (const std::uint64_t seed : {4306U, 5515U}) {
    const SceneOfFewPoints scene(seed);
    ASSERT_TRUE(scene.comparable());
    EXPECT_FALSE(scene.found.boundary->of_polygons);
    SCOPED_TRACE(seed);
    expect_covered(scene.found, scene.fine);
    for (const Lobe& lobe : scene.found.lobes) EXPECT_LE(lobe.boundary_error, 1e-5);
  }
}

// U leaves its fixed point between the path and its first segment, for a moment.
TEST(CrossedBoundary, BarsCoverTheBeginningOfACurve) {
  const auto curves = [](std::size_t segments) {
    ManifoldPair pair;
    for (std::size_t k = 0; k <= segments; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(segments);
      pair.u.push_back({2.2 * t, (std::sin(3 * 2.2 * t + 0.5) - std::sin(0.5)) / 2});
      pair.s.push_back({2.1 - 2 * t, -0.1 - 0.05 * std::sin(2 * t)});
    }
    return pair;
  };
  const ManifoldPair pair = curves(110), many = curves(4400);
  TangleOptions options;
  options.smooth = true;
  double widest = 0;
  for (int k = 0; k <= 12; ++k) {
    options.closure = {{1.5, 1.5}, {0.5, 0.642 + k * 0.0015}};
    const Tangle found = tangle(open(pair.u), open(pair.s), options),
                 fine = tangle(open(many.u), open(many.s), options);
    SCOPED_TRACE(k);
    expect_covered(found, fine);
    widest = std::max(widest, std::fabs(found.boundary->area - fine.boundary->area));
    // Beside the angle between the segment and the curve nothing is hidden.
    EXPECT_LE(found.boundary->smooth_error, k == 0 || k == 12 ? 6e-7 : 5e-6);
  }
  EXPECT_GT(widest, 1e-6);
}

}  // namespace
}  // namespace lober::detail

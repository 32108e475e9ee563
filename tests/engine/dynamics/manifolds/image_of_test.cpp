#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/views.hpp"
#include "lober/error.hpp"
#include "lober/manifolds.hpp"
#include "tests/engine/dynamics/manifolds/distance.hpp"
#include "tests/engine/dynamics/test_maps.hpp"

namespace lober::detail {
namespace {

using testing::StandardMap;

// The circle with this radius about (pi, 0) under the map.
TEST(ImageOf, SmoothCurveMeetsTheTolerance) {
  const StandardMap map(1.2);
  const CurveFunction circle = [](std::span<const double> parameters, std::span<Point> points) {
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      points[k] = {std::numbers::pi + 2 * std::cos(parameters[k]), 2 * std::sin(parameters[k])};
    }
  };
  const double corners[] = {0, 2 * std::numbers::pi};
  for (const int iterates : {0, 1, 5, -4}) {
    const ImageOptions options{.tolerance = 1e-5};
    const CurveImage image = image_of(map, iterates, circle, corners, options);
    EXPECT_TRUE(image.diagnostics.empty());
    double worst = 0, optimal = 0;
    for (std::size_t i = 0; i < image.points.size(); ++i) {
      const bool last = i + 1 == image.points.size();
      const double from = image.parameters[i], to = last ? corners[1] : image.parameters[i + 1];
      double most = 0;
      for (int j = 1; j < 16; ++j) {
        const double t = from + (to - from) * j / 16;
        Point point;
        circle({&t, 1}, {&point, 1});
        map.iterate({&point, 1}, iterates);
        most = std::max(most, distance_to_segment(point, image.points[i], image.points[last ? 0 : i + 1]));
      }
      worst = std::max(worst, most / options.tolerance);
      optimal += std::sqrt(most / options.tolerance);
    }
    EXPECT_LE(worst, 1) << iterates;
    EXPECT_LE(static_cast<double>(image.points.size()), 1.3 * optimal) << iterates;
    // Area is preserved; the polygon inscribed in the curve misses length times 2/3 of the tolerance at most.
    EXPECT_NEAR(std::fabs(signed_area(image)), 4 * std::numbers::pi, 1e-3) << iterates;
  }
}

TEST(ImageOf, PolygonsKeepTheirVertices) {
  const StandardMap map(1.2);
  const std::vector<Point> square{{1, -1}, {4, -1}, {4, 1}, {1, 1}};
  const CurveImage image = image_of(map, 3, CurveView{square}, {.tolerance = 1e-6});
  ASSERT_GT(image.points.size(), 100U);
  for (std::size_t k = 0; k < square.size(); ++k) {
    Point point = square[k];
    map.iterate({&point, 1}, 3);
    const auto at = std::find(image.parameters.begin(), image.parameters.end(), static_cast<double>(k));
    ASSERT_NE(at, image.parameters.end());
    EXPECT_EQ(image.points[static_cast<std::size_t>(at - image.parameters.begin())], point);
  }
  EXPECT_NEAR(std::fabs(signed_area(image)), 6, 1e-4);
  const CurveImage same = with_threads(7, [&] { return image_of(map, 3, CurveView{square}, {.tolerance = 1e-6}); });
  EXPECT_EQ(image.points, same.points);
  const CurveImage few = image_of(map, 3, CurveView{square}, {.tolerance = 1e-6, .max_points = 50});
  EXPECT_EQ(few.stop, GrowthStop::points);
  EXPECT_LE(few.points.size(), 51U);
  EXPECT_THROW((void)image_of(map, 1, CurveView{square}, {.tolerance = 0}), UsageError);
}

}  // namespace
}  // namespace lober::detail

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/parallel/parallel.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/manifolds.hpp"
#include "tests/distance.hpp"
#include "tests/engine/dynamics/test_maps.hpp"
#include "tests/views.hpp"

namespace lober::detail {
namespace {

using test::StandardMap;

struct ImageDistances {
  double worst, optimal_points;  // the first in tolerances
};

// How far the image of a curve that ends at 2 pi is from its polygon, by `parts` - 1 points of each segment.
ImageDistances distances_of_image(const PlanarMap& map, int iterates, const CurveFunction& curve,
                                  const CurveImage& image, double tolerance, int parts) {
  ImageDistances result{0, 0};
  for (std::size_t i = 0; i < image.points.size(); ++i) {
    const bool last = i + 1 == image.points.size();
    const double from = image.parameters[i], to = last ? 2 * std::numbers::pi : image.parameters[i + 1];
    double most = 0;
    for (int j = 1; j < parts; ++j) {
      const double t = from + (to - from) * j / parts;
      Point point;
      curve({&t, 1}, {&point, 1});
      map.iterate({&point, 1}, iterates);
      most = std::max(most, distance_to_segment(point, image.points[i], image.points[last ? 0 : i + 1]));
    }
    result.worst = std::max(result.worst, most / tolerance);
    result.optimal_points += std::sqrt(most / tolerance);
  }
  return result;
}

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
    const auto [worst, optimal] = distances_of_image(map, iterates, circle, image, options.tolerance, 16);
    EXPECT_LE(worst, 1) << iterates;
    EXPECT_LE(static_cast<double>(image.points.size()), 1.3 * optimal) << iterates;
    // Area is preserved; the polygon inscribed in the curve misses length times 2/3 of the tolerance at most.
    EXPECT_NEAR(std::fabs(signed_area(image)), 4 * std::numbers::pi, 1e-3) << iterates;
  }
}

// A thin image turns back next to where the circle begins, and half a turn on: the first turn was cut off by up to 70
// tolerances.
TEST(ImageOf, FoldsBesideTheStartOfACircleAreFound) {
  struct {
    double k, radius, tolerance;
    int iterates;
  } const cases[] = {{100, 0.01, 1e-6, 1}, {100, 0.01, 1e-5, 1}, {10, 0.01, 1e-4, 1}, {3, 0.001, 1e-4, 2},
                     {6, 0.001, 1e-4, 2},  {6, 0.1, 1e-4, 1},    {1.2, 0.01, 1e-6, 4}};
  const double corners[] = {0, 2 * std::numbers::pi};
  for (const auto& c : cases) {
    const StandardMap map(c.k);
    const CurveFunction circle = [&](std::span<const double> parameters, std::span<Point> points) {
      for (std::size_t k = 0; k < parameters.size(); ++k) {
        points[k] = {c.radius * std::cos(parameters[k]), c.radius * std::sin(parameters[k])};
      }
    };
    const CurveImage image = image_of(map, c.iterates, circle, corners, {.tolerance = c.tolerance});
    const double worst = c.tolerance * distances_of_image(map, c.iterates, circle, image, c.tolerance, 64).worst;
    EXPECT_LE(worst, c.tolerance) << c.k << ' ' << c.radius << ' ' << c.tolerance;
    EXPECT_LE(image.points.size(), 120U) << c.k << ' ' << c.radius << ' ' << c.tolerance;
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

TEST(ImageOf, KeepsToTheNumberOfPoints) {
  const StandardMap map(1.2);
  const std::vector<Point> square{{1, -1}, {4, -1}, {4, 1}, {1, 1}};
  for (const bool closed : {true, false}) {
    for (const std::size_t points : {3U, 4U, 5U, 6U, 7U, 10U, 20U, 51U, 200U, 1000U}) {
      const CurveImage image = image_of(map, 5, CurveView{square, closed}, {.tolerance = 1e-7, .max_points = points});
      EXPECT_EQ(image.stop, GrowthStop::points);
      EXPECT_LE(image.points.size(), points);
      EXPECT_EQ(image.parameters.size(), image.points.size());
    }
    // A limit that is not met cuts nothing.
    const CurveImage whole = image_of(map, 2, CurveView{square, closed}, {.tolerance = 1e-4});
    const CurveImage same =
        image_of(map, 2, CurveView{square, closed}, {.tolerance = 1e-4, .max_points = 2 * whole.points.size()});
    EXPECT_EQ(same.stop, GrowthStop::iterates);
    EXPECT_EQ(same.points, whole.points);
  }
}

TEST(ImagesOf, AreThoseOfImageOf) {
  const StandardMap map(1.2);
  const std::vector<Point> square{{1, -1}, {4, -1}, {4, 1}, {1, 1}};
  const ImageOptions options{.tolerance = 1e-4};
  for (const auto& [first, last] : {std::pair{-3, 2}, {-2, -1}, {1, 3}, {0, 0}, {0, 1}, {-1, 0}, {2, 2}}) {
    for (const bool closed : {true, false}) {
      const std::vector<CurveImage> images = images_of(map, first, last, CurveView{square, closed}, options);
      ASSERT_EQ(images.size(), static_cast<std::size_t>(last - first + 1)) << first << ' ' << last;
      for (int n = first; n <= last; ++n) {
        const CurveImage& image = images[static_cast<std::size_t>(n - first)];
        EXPECT_EQ(image.iterate, n);
        EXPECT_EQ(image.closed, closed);
        EXPECT_EQ(image.points, image_of(map, n, CurveView{square, closed}, options).points) << n;
      }
    }
  }
  const std::vector<CurveImage> same = images_of(map, 0, 0, CurveView{square}, options);
  EXPECT_TRUE(std::equal(square.begin(), square.end(), same[0].points.begin(), same[0].points.end()));
  EXPECT_THROW((void)images_of(map, 2, 1, CurveView{square}, options), UsageError);
}

// The shear (x, y) -> (x, y + x) of the half-planes x < 1 and x > 2; nothing between them has an image.
class ShearWithGap final : public PlanarMap {
 public:
  void iterate(std::span<Point> points, int iterates) const override {
    for (Point& point : points) {
      for (int k = 0; k < std::abs(iterates); ++k) {
        point = point.x > 1 && point.x < 2 ? lost_point : Point{point.x, point.y + (iterates < 0 ? -1 : 1) * point.x};
      }
    }
  }
  Point iterate_with_derivative(Point, int, Matrix2&) const override { throw UsageError("no derivative"); }
};

TEST(ImagesOf, PartsEndWhereTheMapFails) {
  const ShearWithGap map;
  const auto parts = [&](std::vector<Point> curve, bool closed) {
    return parts_of(image_of(map, 1, CurveView{curve, closed}, {.tolerance = 1e-3}));
  };
  const auto expect_within = [](const std::vector<ImagePart>& found, std::size_t count) {
    ASSERT_EQ(found.size(), count);
    for (const ImagePart& part : found) {
      EXPECT_FALSE(part.closed);
      // No segment spans the gap, and both sides reach to its edge.
      const auto [low, high] =
          std::minmax_element(part.points.begin(), part.points.end(), [](Point a, Point b) { return a.x < b.x; });
      EXPECT_TRUE(high->x <= 1 || low->x >= 2) << low->x << ' ' << high->x;
      EXPECT_NEAR(high->x <= 1 ? high->x : low->x, high->x <= 1 ? 1 : 2, 1e-4);
    }
  };
  // A rectangle across the gap, from a corner on the left, on the right, and from two corners in it.
  expect_within(parts({{0, 0}, {3, 0}, {3, 1}, {0, 1}}, true), 2);
  expect_within(parts({{3, 0}, {3, 1}, {0, 1}, {0, 0}}, true), 2);
  expect_within(parts({{1.5, 0}, {3, 0}, {3, 1}, {1.5, 1}, {0, 1}, {0, 0}}, true), 2);
  expect_within(parts({{0, 0}, {3, 0}, {3, 1}, {0, 1}}, false), 3);
  expect_within(parts({{1.5, 0}, {3, 0}}, false), 1);
  const std::vector<ImagePart> whole = parts({{0, 0}, {0.5, 0}, {0.5, 1}}, true);
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_TRUE(whole[0].closed);
  EXPECT_EQ(whole[0].points.size(), 3U);
  EXPECT_TRUE(parts({{1.2, 0}, {1.5, 0}, {1.5, 1}}, true).empty());
}

}  // namespace
}  // namespace lober::detail

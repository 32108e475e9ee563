#include "viewer/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lober::viewer {
namespace {

std::vector<Point> polygon_of(const std::vector<std::vector<Point>>& curves, const std::vector<viewer::Run>& runs,
                              const std::vector<Point>& pool) {
  std::vector<Point> polygon;
  for (const Run& run : runs) {
    const std::vector<Point>& from = run.curve < curves.size() ? curves[run.curve] : pool;
    const int step = run.first <= run.last ? 1 : -1;
    for (std::int64_t k = run.first;; k += step) {
      polygon.push_back(from.at(static_cast<std::size_t>(k)));
      if (k == run.last) break;
    }
  }
  return polygon;
}

TEST(Runs, AnArcThereAndBackIsTwoRunsAndItsCorners) {
  std::vector<std::vector<Point>> curves(2);
  for (int k = 0; k < 100; ++k) {
    curves[0].push_back({0.1 * k, 0});
    curves[1].push_back({0.1 * k, std::sin(0.1 * k)});
  }
  const RunFinder finder({curves[0], curves[1]});
  std::vector<Point> polygon{{0.05, 7}}, pool;
  for (std::size_t k = 3; k < 60; ++k) polygon.push_back(curves[0][k]);
  polygon.push_back({5.97, 7});
  for (std::size_t k = 60; k-- > 3;) polygon.push_back(curves[1][k]);
  const std::vector<viewer::Run> runs = finder.runs(polygon, pool);
  EXPECT_EQ(runs.size(), 4U);
  EXPECT_EQ(pool.size(), 2U);
  EXPECT_EQ(polygon_of(curves, runs, pool), polygon);
}

TEST(Runs, AnyPolygonComesBack) {
  std::mt19937_64 random(3);
  std::vector<std::vector<Point>> curves(3);
  for (auto& curve : curves) {
    for (int k = 0; k < 50; ++k)
      curve.push_back({static_cast<double>(random() % 6), static_cast<double>(random() % 6)});
  }
  curves[2].assign(1000, Point{1, 1});  // stands still
  const RunFinder finder({curves[0], curves[1], curves[2]});
  std::vector<Point> pool;
  for (int round = 0; round < 300; ++round) {
    std::vector<Point> polygon(1 + random() % 40);
    for (Point& point : polygon) point = {static_cast<double>(random() % 7), static_cast<double>(random() % 7)};
    EXPECT_EQ(polygon_of(curves, finder.runs(polygon, pool), pool), polygon);
  }
}

}  // namespace
}  // namespace lober::viewer

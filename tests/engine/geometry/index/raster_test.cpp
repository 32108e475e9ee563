// The promise on which the grid rests: segments with a common point have a cell in common.
#include "engine/geometry/index/raster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "kernels/box.hpp"
#include "tests/engine/geometry/index/scenes.hpp"
#include "tests/engine/geometry/index/search_testing.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

std::vector<std::size_t> cells_of(const Raster& raster, const Ends& segment) {
  std::vector<std::size_t> cells;
  raster.for_each_cell(segment.a, segment.b, [&](std::size_t cell) { cells.push_back(cell); });
  std::sort(cells.begin(), cells.end());
  EXPECT_TRUE(std::adjacent_find(cells.begin(), cells.end()) == cells.end()) << "a cell visited twice";
  EXPECT_TRUE(cells.empty() || cells.back() < raster.cells());
  return cells;
}

bool have_common_cell(const Raster& raster, const Ends& s, const Ends& t) {
  const auto a = cells_of(raster, s), b = cells_of(raster, t);
  std::vector<std::size_t> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return !common.empty();
}

Box intersection_of(const Box& a, const Box& b) {
  Box result;
  for (std::size_t lane = 0; lane < 4; ++lane) result.lane[lane] = std::max(a.lane[lane], b.lane[lane]);
  return result;
}

class RasterOf : public ::testing::TestWithParam<SceneKind> {};

TEST_P(RasterOf, GivesSegmentsWithACommonPointACommonCell) {
  Random random(seed());
  for (int k = 0; k < 12; ++k) {
    const Scene made = GetParam().make(random, 60);
    const IndexedCurve first(made.first), second(made.second);
    if (!meet(first.tree().box(), second.tree().box())) continue;
    const Box window = intersection_of(first.tree().box(), second.tree().box());
    const auto side = [&] { return static_cast<std::uint32_t>(1) << random.integer(0, 5); };
    const Raster raster(window, side() + (k % 2 == 0 ? 0U : 3U), side());
    for (const SegmentPair& pair : pairs_with_common_point(made.first, made.second)) {
      const Ends s = ends_of(made.first, pair.first), t = ends_of(made.second, pair.second);
      ASSERT_TRUE(have_common_cell(raster, s, t)) << "try " << k << ", segments " << pair.first << ' ' << pair.second;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, RasterOf, ::testing::ValuesIn(scene_kinds()),
                         [](const auto& kind) { return std::string(kind.param.name); });

TEST(Raster, EntersLongSegmentsAlongTheirLine) {
  Random random(seed());
  const Raster raster(Box::of({0, 0}, {1, 1}), 100, 100);
  for (int k = 0; k < 1000; ++k) {
    const Ends segment{{random.unit(), random.unit()}, {random.unit(), random.unit()}};
    const double crossed = 100 * (std::fabs(segment.b.x - segment.a.x) + std::fabs(segment.b.y - segment.a.y));
    EXPECT_LT(static_cast<double>(cells_of(raster, segment).size()), crossed + 4);
  }
}

TEST(Raster, LeavesOutWhatIsOutsideTheWindow) {
  const Raster raster(Box::of({0, 0}, {1, 1}), 10, 10);
  EXPECT_TRUE(cells_of(raster, {{2, 0}, {3, 1}}).empty());
  EXPECT_LT(cells_of(raster, {{-5, 0.9}, {0.1, 6}}).size(), 3U) << "passes a corner outside";
  EXPECT_LT(cells_of(raster, {{-1e6, -1e6 + 0.5}, {1e6, 1e6 + 0.5}}).size(), 25U) << "long, but a line all the same";
}

TEST(Raster, FitsAboutTwoEntriesToACellAndKeepsToItsLimit) {
  Random random(seed());
  const Scene made = scene::scattered(random, 5000);
  const IndexedCurve curve(made.first);
  for (const std::uint64_t limit : {20000U, 100000U, 100000000U}) {
    const Raster raster = Raster::fitted(curve.tree(), curve.tree().box(), limit, 10000);
    std::size_t entries = 0;
    for (std::size_t k = 0; k < curve.segments(); ++k) entries += cells_of(raster, ends_of(made.first, k)).size();
    EXPECT_LT(static_cast<double>(entries), 1.3 * static_cast<double>(limit));
    if (limit > 1000000) {
      EXPECT_NEAR(static_cast<double>(entries) / static_cast<double>(raster.cells()), 2, 0.5);
    }
  }
}

}  // namespace
}  // namespace lober::test

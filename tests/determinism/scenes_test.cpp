// The scenes of the benchmark: the same bits whatever the threads, the index, the instruction set. LOBER_SCENE_POINTS
// sets their size; scripts/ci.sh and scripts/stress.sh run a million points.
#include <gtest/gtest.h>

#include <string>

#include "bench/scenes/scenes.hpp"
#include "tests/determinism/results.hpp"
#include "tests/determinism/variations.hpp"
#include "tests/environment.hpp"

namespace lober::detail {
namespace {

class Scenes : public testing::TestWithParam<bench::SceneKind> {
 protected:
  [[nodiscard]] static bench::Scene scene(std::size_t points) {
    return GetParam().make(from_environment("LOBER_SCENE_POINTS", points));
  }
  // A uniform grid has one cell for nearly all segments whose lengths span twelve decades: quadratic.
  [[nodiscard]] static IndexKind in_time(IndexKind index, const bench::Scene& pair) {
    if (index != IndexKind::grid || GetParam().name != "geometric" || pair.first.size() <= 200'000) return index;
    std::printf("left out: the grid, quadratic on a geometric spacing; the tree in its place\n");
    return IndexKind::tree;
  }
};

TEST_P(Scenes, Overlay) {
  const bench::Scene pair = scene(200'000);
  expect_same(true, [&](IndexKind index) {
    return overlay_hash(CurveView{pair.first}, CurveView{pair.second}, in_time(index, pair));
  });
}

TEST_P(Scenes, Interior) {
  const bench::Scene pair = scene(100'000);
  expect_same(true, [&](IndexKind index) {
    return interior_hash(CurveView{pair.first}, CurveView{pair.second}, in_time(index, pair));
  });
}

TEST_P(Scenes, Regions) {
  const bench::Scene pair = scene(50'000);
  expect_same(true, [&](IndexKind index) {
    return regions_hash(CurveView{pair.first}, CurveView{pair.second}, in_time(index, pair));
  });
}

TEST_P(Scenes, Densify) {
  const bench::Scene pair = scene(50'000);
  expect_same(false, [&](IndexKind) { return densify_hash(CurveView{pair.first}, CurveView{pair.second}); });
}

INSTANTIATE_TEST_SUITE_P(Determinism, Scenes, testing::ValuesIn(bench::scenes().begin(), bench::scenes().end()),
                         [](const testing::TestParamInfo<bench::SceneKind>& scene) {
                           std::string name;
                           for (const char letter : scene.param.name) {
                             if (letter != '-') name += letter;
                           }
                           return name;
                         });

}  // namespace
}  // namespace lober::detail

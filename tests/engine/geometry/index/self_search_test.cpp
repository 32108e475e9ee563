// The search of a curve against itself, monotone runs left out, against brute force.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <string>

#include "engine/base/parallel/parallel.hpp"
#include "tests/engine/geometry/index/scenes.hpp"
#include "tests/engine/geometry/index/search_testing.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

void expect_all_pairs(const Curve& curve) {
  const IndexedCurve indexed(curve);
  Recorder recorder(curve, curve);
  const SearchCounts counts = find_self_pairs(indexed, recorder);
  const std::vector<SegmentPair> found = recorder.sorted();
  EXPECT_EQ(counts.pairs_proposed, found.size());
  const std::vector<SegmentPair> wanted = pairs_beyond_joints(curve);
  const auto lost = missing(wanted, found);
  ASSERT_TRUE(lost.empty()) << listed(lost);
  for (const SegmentPair& pair : found) ASSERT_LT(pair.first, pair.second);
}

class SelfSearch : public ::testing::TestWithParam<SceneKind> {};

TEST_P(SelfSearch, ProposesEveryPairThatMeetsBeyondAJoint) {
  Random random(seed());
  for (const std::size_t size : {3U, 4U, 31U, 32U, 33U, 64U, 65U, 130U, 300U, 2048U, 2049U}) {
    if (size > GetParam().largest) break;
    SCOPED_TRACE(size);
    const Scene made = GetParam().make(random, size);
    expect_all_pairs(made.first);
    expect_all_pairs(made.second);
  }
}

TEST_P(SelfSearch, DoesTheSameForAnyNumberOfThreads) {
  const tbb::global_control at_most(tbb::global_control::max_allowed_parallelism, 7);
  Random random(seed());
  const Scene made = GetParam().make(random, GetParam().size_for_threads());
  const IndexedCurve curve(made.first);
  Recorder expected(made.first, made.first);
  const SearchCounts counts = with_threads(1, [&] { return find_self_pairs(curve, expected); });
  for (const int threads : {2, 7}) {
    Recorder recorder(made.first, made.first);
    EXPECT_TRUE(same(counts, with_threads(threads, [&] { return find_self_pairs(curve, recorder); })));
    ASSERT_EQ(recorder.by_block(), expected.by_block()) << threads << " threads";
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SelfSearch, ::testing::ValuesIn(scene_kinds()),
                         [](const auto& kind) { return std::string(kind.param.name); });

// A walk of monotone chains that turn back and cross what came before, or fold back onto it.
Curve monotone_chains(Random& random, int shortest, int longest) {
  Curve curve;
  Point at{0, 0};
  curve.points.push_back(at);
  while (curve.points.size() < 704) {
    const double dx = random.integer(-1, 1), dy = random.integer(-1, 1);
    for (int left = random.integer(shortest, longest); left > 0; --left) {
      const double noise = random.chance(0.5) ? random.unit() : 0;
      curve.points.push_back(at = {at.x + dx * (1 + noise), at.y + dy + noise * 0.5});
    }
  }
  curve.points.resize(704);  // a whole number of leaves
  curve.closed = random.chance(0.7);
  return curve;
}

TEST(SelfSearchOfMonotoneRuns, LosesNothingWhereverRunsEnd) {
  Random random(seed());
  for (int k = 0; k < 40; ++k) {
    SCOPED_TRACE(k);
    expect_all_pairs(monotone_chains(random, 1, 150));
  }
}

TEST(SelfSearchOfMonotoneRuns, LosesNothingWhenRunsAreLeaves) {
  Random random(seed());
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE(k);
    expect_all_pairs(monotone_chains(random, leaf_size, leaf_size));
  }
}

TEST(SelfSearchOfMonotoneRuns, SkipsASimpleConvexCurve) {
  const Curve curve = scene::circle(100000, {0, 0}, 1);
  Recorder recorder(curve, curve);
  const SearchCounts counts = find_self_pairs(IndexedCurve(curve), recorder);
  EXPECT_LT(counts.pairs_proposed, 3000U) << "only near the turns in x and in y that no leaf border hits";
}

// A drifter that lies still for a week: each of its segments would meet each.
TEST(SearchOfStalls, CostsWhatTheCurveWithoutThemCosts) {
  Curve plain = scene::circle(20000, {0, 0}, 1), stalled = plain, across = scene::circle(20000, {0, 0}, 1);
  for (Point& point : across.points) point.x += plain.points[700].x - across.points[15000].x;
  for (Point& point : across.points) point.y += plain.points[700].y - across.points[15000].y;
  across.points[15000] = plain.points[700];
  Curve both = across;
  stalled.points.insert(stalled.points.begin() + 700, 200000, plain.points[700]);
  both.points.insert(both.points.begin() + 15000, 200000, across.points[15000]);
  const auto cost = [](const Curve& first, const Curve& second) {
    Recorder recorder(first, second);
    const IndexedCurve one(first), other(second);
    SearchCounts counts = find_pairs(one, other, IndexKind::tree, recorder);
    Recorder alone(first, first);
    counts += find_self_pairs(one, alone);
    return counts.boxes_tested + counts.pairs_proposed;
  };
  const std::uint64_t usual = cost(plain, across) + 4 * stalled.points.size() / leaf_size;
  EXPECT_LT(cost(stalled, across), 2 * usual);
  EXPECT_LT(cost(across, stalled), 2 * usual);
  EXPECT_LT(cost(stalled, both), 2 * usual);
  EXPECT_LT(cost(Curve{std::vector<Point>(5000, Point{1, 1}), true, ""}, both), 2 * usual);
}

TEST(SelfSearchOfMonotoneRuns, FindsNeighboursThatFoldBack) {
  const Curve spike{{{0, 0}, {2, 0}, {1, 0}, {1, 1}}, true, ""};
  Recorder recorder(spike, spike);
  find_self_pairs(IndexedCurve(spike), recorder);
  const auto found = recorder.sorted();
  EXPECT_TRUE(std::binary_search(found.begin(), found.end(), SegmentPair{0, 1}));
}

}  // namespace
}  // namespace lober::test

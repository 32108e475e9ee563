// Tree, grid and k-d search against brute force on every kind of scene.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <string>
#include <tuple>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/box.hpp"
#include "tests/engine/geometry/index/scenes.hpp"
#include "tests/engine/geometry/index/search_testing.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

// Around the sizes of leaves and blocks, and the smallest.
constexpr std::size_t search_sizes[] = {3, 4, 5, 31, 32, 33, 64, 65, 97, 130, 300, 2047, 2048, 2049};
constexpr std::size_t few_sizes[] = {65, 150, 2100};

class Search : public ::testing::TestWithParam<std::tuple<IndexKind, SceneKind>> {
 protected:
  static IndexKind index() { return std::get<0>(GetParam()); }
  static const SceneKind& scene() { return std::get<1>(GetParam()); }
};

TEST_P(Search, ProposesEveryPairWithACommonPointOnce) {
  Random random(seed());
  for (const std::size_t size : search_sizes) {
    if (size > scene().largest) break;
    for (int k = 0; k < (size < 200 ? 6 : 1); ++k) {
      SCOPED_TRACE(::testing::Message() << "size " << size << ", try " << k);
      const Scene made = scene().make(random, size);
      const IndexedCurve first(made.first), second(made.second);
      Recorder recorder(made.first, made.second);
      const SearchCounts counts = find_pairs(first, second, index(), recorder);
      const std::vector<SegmentPair> found = recorder.sorted();
      EXPECT_EQ(counts.pairs_proposed, found.size());
      EXPECT_EQ(counts.blocks_searched + counts.blocks_skipped,
                (first.segments() + block_segments - 1) / block_segments);
      const auto lost = missing(pairs_with_common_point(made.first, made.second), found);
      ASSERT_TRUE(lost.empty()) << listed(lost);
      for (const SegmentPair& pair : found) {
        const Ends s = ends_of(made.first, pair.first), t = ends_of(made.second, pair.second);
        ASSERT_TRUE(meet(Box::of(s.a, s.b), Box::of(t.a, t.b))) << "boxes that do not meet";
      }
    }
  }
}

TEST_P(Search, DoesTheSameForAnyNumberOfThreads) {
  const tbb::global_control at_most(tbb::global_control::max_allowed_parallelism, 7);
  Random random(seed());
  const Scene made = scene().make(random, scene().size_for_threads());
  const IndexedCurve first(made.first), second(made.second);
  Recorder expected(made.first, made.second);
  const SearchCounts counts = with_threads(1, [&] { return find_pairs(first, second, index(), expected); });
  for (const int threads : {2, 7}) {
    Recorder recorder(made.first, made.second);
    const SearchCounts again = with_threads(threads, [&] { return find_pairs(first, second, index(), recorder); });
    EXPECT_TRUE(same(counts, again));
    ASSERT_EQ(recorder.by_block(), expected.by_block()) << threads << " threads";
  }
}

// After every fourth leaf that has pairs the next one, and a bit of the one behind it, are of no interest.
class SkippingRecorder final : public Recorder {
 public:
  using Recorder::Recorder;
  static bool may_be_skipped(const SegmentPair& pair) {
    const std::size_t leaf = pair.first / leaf_size;
    return leaf % 4 == 2 || (leaf % 4 == 3 && pair.first % leaf_size < 7);
  }

 private:
  std::uint32_t skip_before(std::uint32_t leaf) override {
    return leaf % 4 == 1 ? static_cast<std::uint32_t>((leaf + 2) * leaf_size + 7) : 0;
  }
};

TEST_P(Search, SkipsOnlyWhatTheConsumerDoesNotWant) {
  Random random(seed());
  for (const std::size_t size : few_sizes) {
    if (size > scene().largest) break;
    const Scene made = scene().make(random, size);
    SkippingRecorder recorder(made.first, made.second);
    find_pairs(IndexedCurve(made.first), IndexedCurve(made.second), index(), recorder);
    auto lost = missing(pairs_with_common_point(made.first, made.second), recorder.sorted());
    std::erase_if(lost, SkippingRecorder::may_be_skipped);
    ASSERT_TRUE(lost.empty()) << listed(lost);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Search,
                         ::testing::Combine(::testing::Values(IndexKind::tree, IndexKind::grid, IndexKind::kd),
                                            ::testing::ValuesIn(scene_kinds())),
                         [](const auto& kind) {
                           return std::string(name(std::get<0>(kind.param))) + "_" + std::get<1>(kind.param).name;
                         });

TEST(SearchKinds, HaveNamesAndAutomaticIsNone) {
  EXPECT_EQ(name(IndexKind::automatic), "auto");
  const Curve curve = scene::circle(10, {0, 0}, 1);
  const IndexedCurve indexed(curve);
  Recorder recorder(curve, curve);
  EXPECT_THROW(find_pairs(indexed, indexed, IndexKind::automatic, recorder), UsageError);
}

}  // namespace
}  // namespace lober::test

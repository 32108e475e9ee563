#include "engine/batch/store/store.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "engine/batch/export/export.hpp"
#include "engine/batch/store/result_writer.hpp"
#include "tests/engine/batch/scratch_folder.hpp"
#include "tests/engine/batch/stored_plan.hpp"

namespace lober::detail {
namespace {

class StoreTest : public ScratchFolder {
 protected:
  Store started(const std::string& name, const Plan& plan) const {
    Store store = Store::create(path(name));
    store.begin_run(provenance(), 2, {"job.toml", "text", {}}, "1/1", plan);
    return store;
  }
  static double first_value(const Store& store, int key) {
    return store.result(*store.stored().find(key_of(key)))->values[0];
  }
  Plan plan_ = plan_of_pairs(20);
};

TEST_F(StoreTest, WhatIsAppendedIsThereAfterwards) {
  {
    Store store = started("s", plan_);
    store.append(std::vector{done(1, 1.5), failure(2, "two")}, {{"curve", "digest"}});
    store.end_run("complete");
  }
  const Store store = Store::open(path("s"));
  ASSERT_EQ(store.stored().size(), 2U);
  EXPECT_EQ(first_value(store, 1), 1.5);
  EXPECT_EQ(store.result(*store.stored().find(key_of(1)))->seconds, 0.5);
  EXPECT_TRUE(store.stored().find(key_of(2))->failed);
  EXPECT_EQ(store.result(*store.stored().find(key_of(2)))->error, "two");
  EXPECT_EQ(store.digests().at("curve"), "digest");
  ASSERT_EQ(store.runs().size(), 1U);
  EXPECT_EQ(store.runs()[0].manifest, "text");
  EXPECT_EQ(store.runs()[0].how, "complete");
  EXPECT_FALSE(store.runs()[0].commit.empty());
}

TEST_F(StoreTest, NumbersComeBackBitForBit) {
  Store store = started("s", plan_);
  Result given = done(0, -0.0);
  const double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; const double value : {5e-324, -infinity, 0.1, 9007199254740993.0, 3.0}) {
    given.values[++k] = value;
  }
  given.values[6] = std::nan("");
  given.values[21] = 123456789012;  // a count
  given.lists = {{}, {-0.0, std::nan(""), 1e300, 2, 5e-324, 0.1, infinity, -infinity}};
  store.append(std::vector{given}, {});
  const std::optional<Result> found = Store::open(path("s")).result(*store.stored().find(given.key));
  ASSERT_TRUE(found);
  const auto same = [](double a, double b) {
    return std::isnan(a) ? std::isnan(b) : std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  };
  ASSERT_EQ(found->values.size(), given.values.size());
  for (std::size_t k = 0; k < given.values.size(); ++k) EXPECT_PRED2(same, given.values[k], found->values[k]) << k;
  ASSERT_EQ(found->lists.size(), 2U);
  EXPECT_TRUE(found->lists[0].empty());
  ASSERT_EQ(found->lists[1].size(), given.lists[1].size());
  for (std::size_t k = 0; k < given.lists[1].size(); ++k)
    EXPECT_PRED2(same, given.lists[1][k], found->lists[1][k]) << k;
}

TEST_F(StoreTest, NothingIsStoredTwiceAndFailuresGiveWay) {
  Store first = started("s", plan_), second = started("s", plan_);
  first.append(std::vector{done(1, 1), failure(2, "two")}, {});
  second.append(std::vector{done(1, 10), done(2, 2), done(3, 3)}, {});
  EXPECT_EQ(first.stored_meanwhile(), 0U);
  EXPECT_EQ(second.stored_meanwhile(), 1U);
  first.append(std::vector{failure(2, "worse"), failure(3, "worse")}, {});
  const Store store = Store::open(path("s"));
  EXPECT_EQ(store.stored().size(), 3U);
  EXPECT_EQ(first_value(store, 1), 1);
  EXPECT_EQ(first_value(store, 2), 2);
  EXPECT_EQ(first_value(store, 3), 3);
  EXPECT_EQ(asked(path("s"), "SELECT job, c1 FROM overlaps ORDER BY job"),
            (std::vector<std::string>{"1 1.0", "2 2.0", "3 3.0"}));
}

TEST_F(StoreTest, OtherFilesAreRefused) {
  write("text", std::string(5000, 'x'));
  EXPECT_THROW((void)Store::open(path("text")), DataError);
  EXPECT_THROW((void)Store::create(path("text")), DataError);
  EXPECT_THROW((void)Store::open(path("none")), DataError);
  EXPECT_FALSE(std::filesystem::exists(path("none")));
}

TEST_F(StoreTest, MergeJoinsAndRefusesOtherPlans) {
  Store a = started("a", plan_), b = started("b", plan_), c = started("c", plan_of_pairs(21));
  a.append(std::vector{done(1, 1), failure(2, "two")}, {{"x", "1"}});
  b.append(std::vector{done(2, 2), done(3, 3)}, {{"x", "1"}, {"y", "2"}});
  Store all = Store::create(path("all"));
  all.merge({&a, 1});
  all.merge({&b, 1});
  all.merge({&b, 1});
  EXPECT_EQ(all.stored().size(), 3U);
  EXPECT_EQ(first_value(all, 2), 2);
  EXPECT_EQ(all.digests().size(), 2U);
  EXPECT_THROW(all.merge({&c, 1}), DataError);
  b.append({}, {{"x", "9"}});
  EXPECT_THROW(all.merge({&b, 1}), DataError);
}

TEST_F(StoreTest, MergeThatFailsChangesNothing) {
  std::vector<Store> others;
  others.push_back(started("a", plan_));
  others.push_back(started("c", plan_of_pairs(21)));
  others[0].append(std::vector{done(1, 1)}, {{"x", "1"}});
  Store all = Store::create(path("all"));
  EXPECT_THROW(all.merge(others), DataError);
  const Store again = Store::open(path("all"));
  EXPECT_EQ(again.stored().size(), 0U);
  EXPECT_TRUE(again.runs().empty());
  EXPECT_FALSE(again.plan());
}

TEST_F(StoreTest, WriterStoresFromManyThreads) {
  Store store = started("s", plan_);
  ResultWriter writer(store, [] {});
  std::vector<std::thread> threads;
  for (std::uint32_t t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (std::uint32_t k = 0; k < 40; ++k) writer.add(done(t * 40 + k, 1));
    });
  }
  for (std::thread& thread : threads) thread.join();
  writer.finish();
  EXPECT_EQ(Store::open(path("s")).stored().size(), 160U);
}

TEST(Results, ComeBackFromTheirBytes) {
  std::vector<Result> given{done(3, -0.0), failure(4, "no \xff luck")};
  given[0].lists = {{}, {1, 1e-310, std::nan("")}};
  given[0].digests = {"one", "two"};
  const std::string bytes = encoded(given);
  const DecodedResults decoded = decoded_results(bytes);
  const std::vector<Result>& found = decoded.results;
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].values, given[0].values);
  EXPECT_TRUE(std::signbit(found[0].values[0]));
  EXPECT_EQ(found[0].lists.size(), 2U);
  EXPECT_TRUE(std::isnan(found[0].lists[1][2]));
  EXPECT_EQ(found[0].key, given[0].key);
  EXPECT_EQ(found[0].digests, given[0].digests);
  EXPECT_EQ(found[1].error, given[1].error);
  EXPECT_EQ(encoded(found), bytes);
  EXPECT_THROW((void)decoded_results(bytes + "x"), DataError);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW((void)decoded_results(std::string_view(bytes).substr(0, size)), DataError) << size;
  }
}

}  // namespace
}  // namespace lober::detail

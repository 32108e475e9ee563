#include "engine/batch/store.hpp"

#include "engine/batch/export.hpp"
#include "engine/batch/result_writer.hpp"
#include "tests/engine/batch/scratch_folder.hpp"

namespace lober {
namespace {

JobKey key(int number) {
  JobKey made{};
  made[0] = static_cast<std::byte>(number);
  made[31] = std::byte{1};
  return made;
}

StoredResult done(int number, const std::string& value) {
  return {key(number), false, 0.5, value};
}
StoredResult failure(int number, const std::string& message) {
  return {key(number), true, 0.5, message};
}

class StoreTest : public ScratchFolder {
 protected:
  Plan plan_;
};

TEST_F(StoreTest, WhatIsAppendedIsThereAfterwards) {
  {
    Store store = Store::create(path("s"));
    store.begin_run(provenance(), 2, "text", "1/1", plan_);
    store.append(std::vector{done(1, "one"), failure(2, "two")}, {{"curve", "digest"}});
    store.end_run("complete");
  }
  const Store store = Store::open(path("s"));
  ASSERT_EQ(store.stored().size(), 2U);
  EXPECT_EQ(store.result(store.stored().at(key(1)))->value, "one");
  EXPECT_EQ(store.result(store.stored().at(key(1)))->seconds, 0.5);
  EXPECT_TRUE(store.stored().at(key(2)).failed);
  EXPECT_EQ(store.digests().at("curve"), "digest");
  ASSERT_EQ(store.runs().size(), 1U);
  EXPECT_EQ(store.runs()[0].manifest, "text");
  EXPECT_EQ(store.runs()[0].how, "complete");
  EXPECT_FALSE(store.runs()[0].commit.empty());
}

TEST_F(StoreTest, NothingIsStoredTwiceAndFailuresGiveWay) {
  Store first = Store::create(path("s")), second = Store::create(path("s"));
  first.append(std::vector{done(1, "one"), failure(2, "two")}, {});
  second.append(std::vector{done(1, "other"), done(2, "better"), done(3, "three")}, {});
  first.append(std::vector{failure(2, "worse"), failure(3, "worse")}, {});
  const Store store = Store::open(path("s"));
  EXPECT_EQ(store.stored().size(), 3U);
  EXPECT_EQ(store.result(store.stored().at(key(1)))->value, "one");
  EXPECT_EQ(store.result(store.stored().at(key(2)))->value, "better");
  EXPECT_EQ(store.result(store.stored().at(key(3)))->value, "three");
}

TEST_F(StoreTest, OtherFilesAreRefused) {
  write("text", std::string(5000, 'x'));
  EXPECT_THROW((void)Store::open(path("text")), DataError);
  EXPECT_THROW((void)Store::create(path("text")), DataError);
  EXPECT_THROW((void)Store::open(path("none")), DataError);
  EXPECT_FALSE(std::filesystem::exists(path("none")));
}

TEST_F(StoreTest, MergeJoinsAndRefusesOtherPlans) {
  Plan other = plan_;
  other.sources.push_back({"more"});
  Store a = Store::create(path("a")), b = Store::create(path("b")), c = Store::create(path("c"));
  a.begin_run(provenance(), 1, "", "1/2", plan_);
  a.append(std::vector{done(1, "one"), failure(2, "two")}, {{"x", "1"}});
  b.begin_run(provenance(), 1, "", "2/2", plan_);
  b.append(std::vector{done(2, "better"), done(3, "three")}, {{"x", "1"}, {"y", "2"}});
  c.begin_run(provenance(), 1, "", "1/1", other);
  Store all = Store::create(path("all"));
  all.merge(a);
  all.merge(b);
  all.merge(b);
  EXPECT_EQ(all.stored().size(), 3U);
  EXPECT_EQ(all.result(all.stored().at(key(2)))->value, "better");
  EXPECT_EQ(all.digests().size(), 2U);
  EXPECT_THROW(all.merge(c), DataError);
  b.append({}, {{"x", "9"}});
  EXPECT_THROW(all.merge(b), DataError);
}

TEST_F(StoreTest, WriterStoresFromManyThreads) {
  Store store = Store::create(path("s"));
  ResultWriter writer(store, [] {});
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int k = 0; k < 50; ++k) writer.add(done(t * 50 + k, "value"));
    });
  }
  for (std::thread& thread : threads) thread.join();
  writer.finish();
  EXPECT_EQ(Store::open(path("s")).stored().size(), 200U);
}

TEST(Record, ComesBackBitForBit) {
  const Record record{{1.5, -0.0, 1e-310, 7}, {{}, {2.5, 3.5}}};
  const std::string bytes = encode(record);
  EXPECT_EQ(decode(bytes), record);
  EXPECT_TRUE(std::signbit(decode(bytes).values[1]));
  EXPECT_THROW((void)decode(bytes.substr(1)), DataError);
  EXPECT_THROW((void)decode(bytes + "x"), DataError);
}

}  // namespace
}  // namespace lober

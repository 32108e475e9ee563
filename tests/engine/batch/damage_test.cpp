// A store whose bytes are not what was written: what it still gives is right, the rest counts as missing.

#include <sqlite3.h>

#include <map>
#include <random>
#include <sstream>

#include "engine/batch/batch.hpp"
#include "engine/batch/export/export.hpp"
#include "lober/curve/files.hpp"
#include "tests/engine/batch/scratch_folder.hpp"
#include "tests/engine/batch/stored_plan.hpp"

namespace lober::detail {
namespace {

std::string bytes_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

class DamagedStore : public ScratchFolder {
 protected:
  DamagedStore() {
    for (int k = 0; k < 10; ++k) write_npy(path("c." + std::to_string(k)), wavy(40, k));
    write("bad.txt", "0 0\n1 1\n1 0\n0 1\n");
    write("job.toml", "operation = \"overlay\"\ncurves = [\"c.*\", \"bad.txt\"]\noptions = { lobes = true }\n");
    EXPECT_EQ(ran("whole").queue.jobs, 55U);
    rows_ = exported("whole");
    bytes_ = bytes_of(path("whole"));
  }

  BatchReport ran(const std::string& store) const {
    return run_batch(read_manifest(path("job.toml")), {path(store), {}, {.threads = 1}, {}});
  }
  // The lines of an export, by the number of the job.
  std::map<std::string, std::string> exported(const std::string& store) const {
    export_results(Store::open(path(store)), path("out.jsonl"), ExportFormat::json_lines);
    std::map<std::string, std::string> rows;
    std::ifstream lines(path("out.jsonl"));
    for (std::string line; std::getline(lines, line);) rows.emplace(line.substr(0, line.find(',')), line);
    return rows;
  }
  void execute(const std::string& store, const std::string& sql) const {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(path(store).c_str(), &database), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(database);
    sqlite3_close(database);
  }

  std::map<std::string, std::string> rows_;
  std::string bytes_;
};

// Whatever byte is changed, every row that is exported is one of the original, and a run, where the file can be written
// to at all, gives all of them; where it cannot, what is taken over into a new store is completed there.
TEST_F(DamagedStore, RandomBytesChanged) {
  std::mt19937 random(11);
  std::uniform_int_distribution<std::size_t> offset(0, bytes_.size() - 1);
  std::size_t unreadable = 0, incomplete = 0, untouched = 0, rescued = 0;
  for (int round = 0; round < 300; ++round) {
    std::string bytes = bytes_;
    for (int k = 0; k <= round % 3; ++k) {
      bytes[offset(random)] ^= static_cast<char>(1U << random() % 8);
    }
    for (const char* const end : {"-wal", "-shm"}) std::filesystem::remove(path(std::string("s") + end));
    write("s", bytes);
    try {
      const std::map<std::string, std::string> rows = exported("s");
      for (const auto& [job, row] : rows) ASSERT_EQ(row, rows_.at(job)) << "round " << round;
      ++(rows.size() == rows_.size() ? untouched : incomplete);
      if (rows.size() == rows_.size()) continue;
      EXPECT_EQ(survey(Store::open(path("s"))).counts.missing, rows_.size() - rows.size());
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("/s"), std::string::npos) << error.what();
      ++unreadable;
    }
    std::filesystem::remove(path("next"));
    std::string target = "s";
    try {
      ran("s");
    } catch (const Error& error) {
      const std::string message = error.what();
      if (message.find("lober batch merge NEW") == std::string::npos) continue;  // not even to be opened
      try {
        const Store damaged = Store::open(path("s"));
        Store::create(path("next")).merge({&damaged, 1});
        ++rescued;
      } catch (const DataError&) {  // the plan is lost too
      }
      target = "next";
      ran("next");
    }
    ASSERT_EQ(exported(target), rows_) << "round " << round;
  }
  EXPECT_GT(incomplete, 30U);
  EXPECT_GT(rescued, 0U);
  EXPECT_GT(untouched, 10U);
  EXPECT_LT(unreadable, 150U);
}

TEST_F(DamagedStore, AChangedValueIsNamedAndComputedAgain) {
  execute("whole", "UPDATE results_overlay SET crossings = crossings + 2 WHERE id = 3");
  const StoreSurvey found = survey(Store::open(path("whole")));
  ASSERT_EQ(found.counts.damaged.size(), 1U);
  const std::string& line = found.counts.damaged[0];
  EXPECT_EQ(line.substr(0, path("whole").size() + 20), path("whole") + ": the result of job ") << line;
  EXPECT_NE(line.find("(c."), std::string::npos) << line;
  EXPECT_EQ(found.counts.missing, 1U);
  EXPECT_EQ(exported("whole").size(), rows_.size() - 1);
  const BatchReport again = ran("whole");
  EXPECT_EQ(again.queue.jobs, 1U + 10U);  // and those that failed
  EXPECT_EQ(again.damaged, found.counts.damaged);
  EXPECT_EQ(exported("whole"), rows_);
  EXPECT_EQ(survey(Store::open(path("whole"))).counts.damaged.size(), 0U);
}

TEST_F(DamagedStore, EveryColumnIsVerified) {
  for (const std::string column : {"key", "run", "seconds", "lists", "sum", "c1", "orientation2"}) {
    write("s", bytes_);
    execute("s", "UPDATE results_overlay SET \"" + column + "\" = CASE typeof(\"" + column +
                     "\") WHEN 'blob' THEN zeroblob(32) ELSE coalesce(\"" + column + "\", 0) + 1 END WHERE id = 2");
    EXPECT_EQ(survey(Store::open(path("s"))).counts.missing, 1U) << column;
    ran("s");
    EXPECT_EQ(exported("s"), rows_) << column;
  }
}

TEST_F(DamagedStore, AFailureIsNotTurnedIntoAResultNorTheOtherWayRound) {
  execute("whole", "UPDATE results_overlay SET message = CASE WHEN message IS NULL THEN 'failed' END");
  EXPECT_EQ(survey(Store::open(path("whole"))).counts.damaged.size(), rows_.size());
  EXPECT_TRUE(exported("whole").empty());
  ran("whole");
  EXPECT_EQ(exported("whole"), rows_);
}

TEST_F(DamagedStore, ADamagedPlanIsSaidAndWrittenAgain) {
  execute("whole", "UPDATE plan SET body = substr(body, 1, length(body) - 4) || zeroblob(4)");
  try {
    (void)survey(Store::open(path("whole")));
    ADD_FAILURE() << "the plan was believed";
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("its plan is damaged"), std::string::npos) << error.what();
  }
  EXPECT_EQ(ran("whole").queue.jobs, 10U);
  EXPECT_EQ(exported("whole"), rows_);
}

TEST_F(DamagedStore, StoresOfOtherVersionsAreNamed) {
  execute("whole", "PRAGMA user_version = 3");
  try {
    (void)Store::open(path("whole"));
    ADD_FAILURE() << "another format was read";
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("is a store of format 3, as older versions of lober have it"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(DamagedStore, PlansThatNameWhatTheyDoNotHaveAreRefused) {
  const Plan plan = make_plan(read_manifest(path("job.toml")));
  EXPECT_EQ(Plan::decoded(plan.encoded()).encoded(), plan.encoded());
  Plan groups = plan, curves = plan, sources = plan;
  groups.jobs[3].group = 1;
  curves.jobs[3].second = static_cast<CurveId>(plan.curves.size());
  sources.curves[2].file.clear();
  for (const Plan& bad : {groups, curves, sources}) EXPECT_THROW((void)Plan::decoded(bad.encoded()), DataError);
  const std::string bytes = plan.encoded();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW((void)Plan::decoded(std::string_view(bytes).substr(0, size)), DataError);
  }
}

class StoreInPlace : public ScratchFolder {
 protected:
  // The message of `append` when the second of two results is committed after `between`.
  template <typename Between>
  std::string message_after(const Between& between) const {
    Store store = Store::create(path("s"));
    store.begin_run(provenance(), 1, {}, "1/1", plan_of_pairs(3));
    store.append(std::vector{done(1, 1)}, {});
    between();
    try {
      store.append(std::vector{done(2, 2)}, {});
    } catch (const DataError& error) {
      return error.what();
    }
    return "nothing";
  }
  void expect_both_in(const std::string& name, const std::string& message) const {
    EXPECT_NE(message.find(path(name)), std::string::npos) << message;
    EXPECT_EQ(Store::open(path(name)).stored().size(), 2U);
  }
};

TEST_F(StoreInPlace, DeletedWhileInUse) {
  const std::string message = message_after([&] { std::filesystem::remove(path("s")); });
  expect_both_in("s.rescued", message);
}

TEST_F(StoreInPlace, MovedWhileInUse) {
  const std::string message = message_after([&] { std::filesystem::rename(path("s"), path("elsewhere")); });
  expect_both_in("elsewhere", message);
}

TEST_F(StoreInPlace, ReplacedWhileInUse) {
  const std::string message = message_after([&] {
    std::filesystem::remove(path("s"));
    write("s", "something else");
  });
  expect_both_in("s.rescued", message);
  EXPECT_EQ(bytes_of(path("s")), "something else");
}

TEST_F(StoreInPlace, DeletedBeforeTheEnd) {
  Store store = Store::create(path("s"));
  store.begin_run(provenance(), 1, {}, "1/1", {});
  std::filesystem::remove(path("s"));
  EXPECT_THROW(store.end_run("complete"), DataError);
}

TEST_F(StoreInPlace, NamesThatAreNoFiles) {
  EXPECT_THROW((void)Store::create(":memory:"), UsageError);
  EXPECT_THROW((void)Store::create(""), UsageError);
  EXPECT_THROW((void)Store::create("/dev/null"), DataError);
  EXPECT_THROW((void)Store::create(path("")), DataError);
}

TEST_F(StoreInPlace, AFileTooShortToBeADatabaseIsNotFilled) {
  for (const std::size_t size : {1U, 100U, 511U}) {
    write("short", std::string(size, 'x'));
    EXPECT_THROW((void)Store::create(path("short")), DataError);
    EXPECT_EQ(bytes_of(path("short")), std::string(size, 'x'));
  }
  write("empty", "");
  EXPECT_EQ(Store::create(path("empty")).stored().size(), 0U);
}

}  // namespace
}  // namespace lober::detail

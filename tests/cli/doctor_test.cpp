// `lober doctor`.

#include <filesystem>
#include <fstream>

#include "cli/doctor/machine.hpp"
#include "lober/base/version.hpp"
#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

class Doctor : public ProgramTest {
 protected:
  [[nodiscard]] Json report() const {
    const Outcome outcome = run({"doctor", "--json", "-"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(outcome.out)["report"];
  }
};

TEST_F(Doctor, FindsNothingWrong) {
  const Outcome outcome = run({"doctor"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(outcome.out.starts_with(std::string("lober       ") + version())) << outcome.out;
  for (const char* const name : {"libraries", "system", "processor", "threads", "memory", "parts", "progress",
                                 "temporary", "self-test   passed"}) {
    EXPECT_NE(outcome.out.find(std::string("\n") + name), std::string::npos) << name << "\n" << outcome.out;
  }
  EXPECT_LE(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 16);
}

TEST_F(Doctor, ReportsAsJson) {
  const Json found = report();
  EXPECT_EQ(found["self_test"]["passed"], true);
  EXPECT_EQ(found["self_test"]["crossings"], 40000);
  EXPECT_EQ(found["self_test"]["pieces"], 30002);
  EXPECT_LT(found["self_test"]["seconds"].get<double>(), 10);
  EXPECT_EQ(found["temporary"]["writable"], true);
  EXPECT_GT(found["memory"].get<std::uint64_t>(), std::uint64_t{1} << 28);
  EXPECT_GE(found["threads"], 1);
  EXPECT_EQ(found["progress"], false);
  EXPECT_TRUE(found["parts"].is_array());
  EXPECT_EQ(found["libraries"][0]["name"], "TBB");
  for (const Json& library : found["libraries"]) EXPECT_NE(library["version"], "") << library;
  EXPECT_GE(found["libraries"].size(), 9U);
}

TEST_F(Doctor, NamesTheInstructionSetInUse) {
  const Environment environment("LOBER_ISA", "baseline");
  EXPECT_EQ(report()["instruction_set"], "baseline");
}

TEST_F(Doctor, FailsWhereTemporaryFilesCannotBeWritten) {
  const Environment environment("TMPDIR", "/nonexistent");
  const Outcome outcome = run({"doctor"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.out.find("self-test   passed"), std::string::npos);
  EXPECT_EQ(outcome.err,
            "lober: /nonexistent cannot be written: No such file or directory; set TMPDIR to a folder that can\n");
}

TEST_F(Doctor, ReadsLimitsOfControlGroups) {
  namespace fs = std::filesystem;
  fs::create_directories(folder() / "two/a/b");
  write("two/a/memory.max", "2147483648\n");
  write("two/a/b/memory.max", "max\n");
  write("two/a/cpu.max", "max 100000\n");
  write("two/a/b/cpu.max", "150000 100000\n");
  const GroupLimits second = group_limits(folder() / "two", "0::/a/b\n");
  EXPECT_EQ(second.memory, std::uint64_t{1} << 31);
  EXPECT_EQ(second.processors, 1.5);
  fs::create_directories(folder() / "one/memory/job");
  fs::create_directories(folder() / "one/cpu");
  write("one/memory/memory.limit_in_bytes", "9223372036854771712\n");
  write("one/memory/job/memory.limit_in_bytes", "1048576\n");
  write("one/cpu/cpu.cfs_quota_us", "-1\n");
  write("one/cpu/cpu.cfs_period_us", "100000\n");
  const GroupLimits first = group_limits(folder() / "one", "4:memory:/job\n1:cpu:/\n0::/\n");
  EXPECT_EQ(first.memory, std::uint64_t{1} << 20);
  EXPECT_EQ(first.processors, std::nullopt);
  const GroupLimits none = group_limits(folder() / "nowhere", "0::/a/b\nnonsense\n5:cpu:odd\n");
  EXPECT_EQ(none.memory, std::nullopt);
}

}  // namespace
}  // namespace lober::cli

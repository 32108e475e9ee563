// `lober_mpi`: several ranks, and one that is killed.

#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <random>
#include <thread>

#include "tests/cli/background.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/programs.hpp"

namespace lober::cli {
namespace {

class BatchMpi : public ProgramTest {
 protected:
  void SetUp() override {
    if (std::string(LOBER_MPI_PROGRAM).empty() || !std::filesystem::exists(LOBER_MPIRUN)) {
      GTEST_SKIP() << "there is no MPI here";
    }
    setenv("ASAN_OPTIONS", "detect_leaks=0", 1);  // those of the MPI library
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    for (int k = 0; k < 30; ++k) {
      write_curve("separ." + std::to_string(k), flower(5000, 60 + k, 0.3, {0.001 * k, 0.002 * k}));
    }
    write("job.toml", "operation = \"overlay\"\ncurves = \"separ.*\"\noptions = { lobes = true }\n");
    EXPECT_EQ(run({"batch", "run", "job.toml", "--store", "whole"}).status, 0);
    expected_ = exported("whole");
  }
  pid_t start(int ranks, const std::string& store) const {
    return start_in(folder(), {LOBER_MPIRUN, "--oversubscribe", "-n", std::to_string(ranks), LOBER_MPI_PROGRAM,
                               "job.toml", "--store", store, "--threads", "1"});
  }
  std::string exported(const std::string& store) const {
    const Outcome outcome = run({"batch", "export", store, "--format", "jsonl"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  }
  std::string expected_;
};

TEST_F(BatchMpi, SameBytesAsOneProcess) {
  EXPECT_EQ(wait_for(start(3, "ranks3")), 0);
  EXPECT_EQ(exported("ranks3"), expected_);
  EXPECT_EQ(run({"batch", "status", "ranks3"}).out.substr(0, 27), "435 done, 0 failed, 0 to do");
}

TEST_F(BatchMpi, OutputsStayBelowTheirFolder) {
  std::filesystem::create_directory(folder() / "out");
  const auto status_of = [&](const std::string& output) {
    write("job.toml", "operation = \"densify\"\ncurves = \"separ.*\"\noptions = { output = \"" + output + "\" }\n");
    return wait_for(start_in(folder(), {LOBER_MPIRUN, "--oversubscribe", "-n", "3", LOBER_MPI_PROGRAM, "job.toml",
                                        "--store", "s", "--output-root", "out"}));
  };
  for (const char* const bad : {"../{name}", "x.npy"}) EXPECT_EQ(status_of(bad), 2) << bad;
  EXPECT_FALSE(exists("s"));
  EXPECT_EQ(status_of("{name}"), 0);
  for (int k = 0; k < 30; ++k) EXPECT_TRUE(exists("out/separ." + std::to_string(k))) << k;
}

TEST_F(BatchMpi, FailedJobsShowInTheExitStatus) {
  write("separ.3", "0 0\n1 1\n1 0\n0 1\n");
  EXPECT_EQ(wait_for(start(2, "failed")), 1);
  EXPECT_EQ(run({"batch", "status", "failed"}).out.substr(0, 28), "406 done, 29 failed, 0 to do");
}

TEST_F(BatchMpi, KilledRanksLoseNothingThatWasStored) {
  const char* const wanted = std::getenv("LOBER_MPI_KILLS");
  const int kills = wanted != nullptr ? std::atoi(wanted) : 1;
  std::mt19937 random(7);
  for (int k = 0; k < kills; ++k) {
    const std::string store = "store" + std::to_string(k);
    const pid_t mpirun = start(2, store);
    // The moment counts from when the store is there: starting takes MPI a while.
    for (int wait = 0; wait < 500 && !exists(store); ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::this_thread::sleep_for(std::chrono::milliseconds(std::uniform_int_distribution<>(0, 400)(random)));
    const std::vector<pid_t> ranks = children_of(mpirun);
    if (!ranks.empty()) kill(ranks[static_cast<std::size_t>(k) % ranks.size()], SIGKILL);
    wait_for(mpirun);
    EXPECT_EQ(wait_for(start(2, store)), 0);
    ASSERT_EQ(exported(store), expected_);
  }
}

// A rank that fails ends the run, and soon: nobody waits for it.
TEST_F(BatchMpi, RanksThatFailEndTheRun) {
  const std::string program = LOBER_MPI_PROGRAM,
                    head = std::string("exec timeout 60 ") + LOBER_MPIRUN + " --oversubscribe ";
  const std::string good = program + " job.toml --threads 1 --store failing ";
  for (const std::string& line : {
           head + "-n 1 " + good + ": -n 1 " + good + "--memory much",  // each alone would know what is wrong
           head + "-n 1 " + good + "--shard 3/2 : -n 1 " + good,
           head + "-n 1 " + program + " nowhere.toml : -n 2 " + good,
       }) {
    std::filesystem::remove(folder() / "failing");
    const int status = wait_for(start_in(folder(), {"sh", "-c", line}));
    EXPECT_NE(status, 124) << "hangs: " << line;
    EXPECT_NE(status, 0) << line;
    EXPECT_EQ(wait_for(start(2, "failing")), 0);
    EXPECT_EQ(exported("failing"), expected_);
  }
}

// The store goes while the ranks work: once it has results, and long before it has all of them.
TEST_F(BatchMpi, AStoreThatVanishesEndsTheRun) {
  for (int k = 0; k < 150; ++k) {
    write_curve("many." + std::to_string(k), flower(5000, 60 + k, 0.3, {0.001 * k, 0.002 * k}));
  }
  write("many.toml", "operation = \"overlay\"\ncurves = \"many.*\"\noptions = { lobes = true }\n");
  const std::string line = std::string("exec timeout 60 ") + LOBER_MPIRUN + " --oversubscribe -n 3 " +
                           LOBER_MPI_PROGRAM + " many.toml --threads 1 --store gone";
  const pid_t mpirun = start_in(folder(), {"sh", "-c", line});
  std::string status;
  for (int wait = 0; wait < 3000; ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (!exists("gone")) continue;
    const Outcome outcome = run({"batch", "status", "gone"});
    status = outcome.out + outcome.err;
    if (outcome.status == 0 && status.rfind("0 done", 0) != 0) break;
  }
  ASSERT_EQ(status.find(" 0 to do"), std::string::npos) << "too late: " << status;
  std::filesystem::remove(folder() / "gone");
  EXPECT_EQ(wait_for(mpirun), 1) << status;
  EXPECT_TRUE(exists("gone.rescued")) << status;
}

// Messages that are longer than what MPI sends at once; with pieces of a few bytes.
TEST_F(BatchMpi, MessagesOfAnyLength) {
  EXPECT_EQ(wait_for(start_in(folder(), {LOBER_MPIRUN, "--oversubscribe", "-n", "3", LOBER_MPI_MESSAGES})), 0);
}

}  // namespace
}  // namespace lober::cli

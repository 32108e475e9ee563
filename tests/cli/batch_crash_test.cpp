// Nothing that was stored is lost: kill -9 at any moment, interrupts, a full disk, two processes on one store.

#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdlib>
#include <random>
#include <thread>

#include "tests/cli/background.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/programs.hpp"

namespace lober::cli {
namespace {

class BatchCrash : public ProgramTest {
 protected:
  BatchCrash() {
    // A few hundred pairs that cross often, so that a run takes a while.
    for (int k = 0; k < 30; ++k) {
      write_curve("separ." + std::to_string(k), flower(5000, 60 + k, 0.3, {0.001 * k, 0.002 * k}));
    }
    write("job.toml", "operation = \"overlay\"\ncurves = \"separ.*\"\noptions = { lobes = true }\n");
  }

  // Starts lober and does not wait.
  pid_t start(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), LOBER_PROGRAM);
    return start_in(folder(), arguments);
  }
  std::string exported(const std::string& store) const {
    const Outcome outcome = run({"batch", "export", store, "--format", "jsonl"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  }
  // Runs undisturbed; returns how long that took.
  Seconds run_undisturbed() const {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(run({"batch", "run", "job.toml", "--store", "whole"}).status, 0);
    return std::chrono::steady_clock::now() - begin;
  }
};

int kills() {
  const char* const wanted = std::getenv("LOBER_KILLS");
  return wanted != nullptr ? std::atoi(wanted) : 10;
}

TEST_F(BatchCrash, KilledAtAnyMomentAndResumed) {
  const Seconds whole = run_undisturbed();
  const std::string expected = exported("whole");
  std::mt19937 random(static_cast<unsigned>(kills()));
  std::uniform_real_distribution<double> moment(0, 1);
  int killed = 0, rounds = 0;
  while (killed < kills() && rounds < 20 * kills()) {
    const std::string store = "store" + std::to_string(rounds++);
    // Killed over and over until it comes to its end.
    for (;;) {
      const pid_t process = start({"batch", "run", "job.toml", "--store", store});
      std::this_thread::sleep_for(whole * moment(random) * 1.2);
      kill(process, SIGKILL);
      if (wait_for(process) != -1) break;
      ++killed;
      if (killed % 5 == 0) break;  // the rest undisturbed
    }
    EXPECT_EQ(run({"batch", "run", "job.toml", "--store", store}).status, 0);
    ASSERT_EQ(exported(store), expected);
  }
  EXPECT_GE(killed, kills());
}

TEST_F(BatchCrash, FirstInterruptStoresWhatRuns) {
  const Seconds whole = run_undisturbed();
  const pid_t process = start({"batch", "run", "job.toml", "--store", "stopped"});
  std::this_thread::sleep_for(whole * 0.4);
  kill(process, SIGINT);
  const int status = wait_for(process);
  // It may have been too late, or so early that the handler was not there yet.
  EXPECT_TRUE(status == 130 || status == 0 || status == -1) << status;
  EXPECT_EQ(run({"batch", "run", "job.toml", "--store", "stopped"}).status, 0);
  EXPECT_EQ(exported("stopped"), exported("whole"));
}

TEST_F(BatchCrash, TwoProcessesOnOneStore) {
  run_undisturbed();
  const pid_t first = start({"batch", "run", "job.toml", "--store", "shared"});
  const pid_t second = start({"batch", "run", "job.toml", "--store", "shared"});
  EXPECT_EQ(wait_for(first), 0);
  EXPECT_EQ(wait_for(second), 0);
  EXPECT_EQ(exported("shared"), exported("whole"));
  const Outcome again = run({"batch", "run", "job.toml", "--store", "shared", "--json", "-"});
  EXPECT_EQ(nlohmann::json::parse(again.out)["run"], 0);
}

// A limit on the size of files stands for the full disk.
TEST_F(BatchCrash, FullDiskLosesNothingThatWasStored) {
  run_undisturbed();
  const std::string command = std::string("trap '' XFSZ; ulimit -f 200; exec ") + LOBER_PROGRAM +
                              " batch run job.toml --store full 2> err > /dev/null";
  const std::string in_folder = "cd '" + folder().string() + "' && sh -c \"" + command + "\"";
  const int status = std::system(in_folder.c_str());  // NOLINT(concurrency-mt-unsafe): one thread
  EXPECT_EQ(WEXITSTATUS(status), 1) << read("err");
  EXPECT_NE(read("err").find("full:"), std::string::npos) << read("err");
  EXPECT_EQ(run({"batch", "run", "job.toml", "--store", "full"}).status, 0);
  EXPECT_EQ(exported("full"), exported("whole"));
}

}  // namespace
}  // namespace lober::cli

// The first interrupt ends every command soon, whatever it is doing; and only people see how far it is.

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <thread>

#include "cli/program/progress.hpp"
#include "tests/cli/background.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/programs.hpp"
#include "tests/cli/pseudo_terminal.hpp"

namespace lober::cli {
namespace {

// The machine may be slow and busy; by itself it takes a tenth of that.
constexpr double longest_end = 4;

// Whether the process catches SIGINT by now: a busy machine may take longer to start it than the test waits.
bool listens(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    constexpr std::string_view caught = "SigCgt:";
    if (line.starts_with(caught))
      return (std::stoull(line.substr(caught.size()), nullptr, 16) >> (SIGINT - 1) & 1) != 0;
  }
  return false;
}

class Interrupt : public ProgramTest {
 protected:
  void write_raw(const std::string& name, const std::vector<Point>& points) const {
    std::ofstream file(folder() / name, std::ios::binary);
    file.write(reinterpret_cast<const char*>(points.data()),
               static_cast<std::streamsize>(points.size() * sizeof(Point)));
  }

  void TearDown() override {
    EXPECT_TRUE(interrupted_ > 0 || !asked_) << "all work was too short to be interrupted";
    ProgramTest::TearDown();
  }

  // Interrupts the command at a random instant of its first second, a few times over.
  void ends_soon(const std::vector<std::string>& arguments, double latest = 1.0) {
    std::vector<std::string> command = arguments;
    command.insert(command.begin(), LOBER_PROGRAM);
    std::mt19937 random(static_cast<unsigned>(arguments.size() + arguments[0].size()));
    std::uniform_real_distribution<double> moment(0.1, latest);
    double longest = 0;
    int interrupted = 0;
    asked_ = true;
    for (int round = 0; round < 2; ++round) {
      const pid_t process = start_in(folder(), command);
      for (int k = 0; k < 500 && !listens(process); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
      std::this_thread::sleep_for(Seconds(moment(random)));
      const auto begin = std::chrono::steady_clock::now();
      kill(process, SIGINT);
      const int status = wait_for(process);
      longest = std::max(longest, Seconds(std::chrono::steady_clock::now() - begin).count());
      EXPECT_TRUE(status == 130 || status == 0) << arguments[0] << ": " << status;
      interrupted += status == 130 ? 1 : 0;
    }
    std::printf("%s %s: %d interrupted, at most %.3f s from signal to end\n", arguments[0].c_str(),
                arguments[1].c_str(), interrupted, longest);
    EXPECT_LT(longest, longest_end) << arguments[0] << ' ' << arguments[1];
    // How long the work takes depends on the machine; some of it is always long enough (see TearDown).
    interrupted_ += interrupted;
  }

 private:
  int interrupted_ = 0;
  bool asked_ = false;
};

TEST_F(Interrupt, EndsCommandsOnCurvesSoon) {
  // Two curves that cross thousands of times.
  write_raw("a.raw", flower(3'000'000, 2000, 0.3, {0, 0}));
  write_raw("b.raw", flower(3'000'000, 2001, 0.3, {0.01, 0.003}));
  // Soon enough that a quiet machine of today is not done, and has written nothing.
  ends_soon({"overlay", "a.raw", "b.raw", "--json", "o.json", "--lobes", "l.dat"}, 0.3);
  ends_soon({"overlay", "a.raw", "b.raw", "--rule", "nonzero"}, 0.3);
  ends_soon({"interior", "a.raw", "b.raw"});
  ends_soon({"densify", "a.raw", "-o", "d.csv", "--max-length", "1e-8"});
  ends_soon({"a.raw", "b.raw", "result"});
  ends_soon({"-light", "a.raw", "b.raw", "result", "-DENS", "2", "100"});
  EXPECT_FALSE(exists("o.json"));
  EXPECT_FALSE(exists("result"));
}

TEST_F(Interrupt, EndsCommandsOnSystemsSoon) {
  ends_soon({"grow", "duffing", "--unstable", "--tolerance", "1e-9", "--iterates", "40", "-o", "u.npy"});
  ends_soon({"grow", "standard", "--unstable", "--tolerance", "1e-10", "--iterates", "100", "--max-points", "100000000",
             "-o", "s.npy"});
  EXPECT_TRUE(exists("s.npy")) << "what was grown is kept";
  ends_soon({"tangle", "--system", "duffing", "--after", "4", "--tolerance", "1e-9", "--budget", "60"}, 0.4);
  ends_soon({"transport", "double-gyre", "--tolerance", "1e-9"}, 0.4);
  ends_soon({"transport", "duffing", "--sweep", "eps=0.1:0.5:0.0001"});
  ends_soon({"escape", "capsize", "--tolerance", "1e-9", "--crossings", "8"});
  ends_soon({"escape", "capsize", "--crossings", "1", "--tolerance", "1e-3", "--monte-carlo", "100000000"});
}

TEST_F(Interrupt, EndsABatchOfLongJobsSoon) {
  std::string values = "0.1";
  for (int k = 1; k < 100; ++k) values += ", " + std::to_string(0.1 + 0.001 * k);
  write("long.toml",
        "operation = \"transport\"\noptions = { system = \"duffing\", iterates = 2, tolerance = 1e-8 }\n"
        "grid = { parameters.eps = [" +
            values + "] }\n");
  ends_soon({"batch", "run", "long.toml", "--store", "long"});
  // Nothing of what was broken off is in the store.
  const Outcome status = run({"batch", "status", "long"});
  EXPECT_EQ(status.status, 0) << status.err;
  int done = -1, failed = -1, to_do = -1;
  ASSERT_EQ(std::sscanf(status.out.c_str(), "%d done, %d failed, %d to do", &done, &failed, &to_do), 3) << status.out;
  EXPECT_EQ(done + to_do, 100) << status.out;
  EXPECT_EQ(failed, 0) << status.out;
  EXPECT_GT(to_do, 0) << status.out;
}

TEST_F(Interrupt, IsAnsweredAtOnceByOneLine) {
  const std::string command = std::string(LOBER_PROGRAM) +
                              " grow duffing --unstable --tolerance 1e-9 --iterates 40 2> err > /dev/null & p=$!; " +
                              "sleep 0.5; kill -INT $p; sleep 0.3; cp err early; wait $p; exit $?";
  const int status =  // NOLINTNEXTLINE(concurrency-mt-unsafe): one thread
      std::system(("cd '" + folder().string() + "' && exec bash -m -c '" + command + "'").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_TRUE(read("early").starts_with("lober: interrupted")) << read("early");
  EXPECT_EQ(read("err").find('%'), std::string::npos) << "no progress where nobody looks: " << read("err");
}

TEST_F(Interrupt, ProgressIsToBeSeenOnATerminal) {
  const Terminal terminal;
  const int keep_open = open(terminal.name().c_str(), O_RDWR | O_NOCTTY);
  const std::string command = std::string("exec ") + LOBER_PROGRAM +
                              " grow duffing --unstable --tolerance 1e-9 --iterates 40 --max-work 1e12 2> " +
                              terminal.name();
  const pid_t process = start_in(folder(), {"sh", "-c", command});
  const std::string seen = terminal.read_for(3.5);
  kill(process, SIGINT);
  EXPECT_EQ(wait_for(process), 130);
  close(keep_open);
  EXPECT_NE(seen.find("growing:"), std::string::npos) << seen;
  EXPECT_NE(seen.find("points/s"), std::string::npos) << seen;
  EXPECT_NE(seen.find(" left"), std::string::npos) << seen;
}

// Rows are shown when they are ready, and an interrupt keeps them.
TEST_F(Interrupt, KeepsTheRowsOfTransport) {
  const Terminal terminal;
  const int keep_open = open(terminal.name().c_str(), O_RDWR | O_NOCTTY);
  const std::string command = std::string("exec ") + LOBER_PROGRAM +
                              " transport duffing --iterates 20 --tolerance 1e-7 --budget 100 > out 2> " +
                              terminal.name();
  const pid_t process = start_in(folder(), {"sh", "-c", command});
  std::string seen;
  // The line of progress may begin with "n = 1: " too.
  for (int seconds = 0; seconds < 120 && seen.find("n = 1: T12 ") == std::string::npos; ++seconds) {
    seen += terminal.read_for(1);
  }
  kill(process, SIGINT);
  EXPECT_EQ(wait_for(process), 130);
  close(keep_open);
  EXPECT_NE(seen.find("n = 1: T12 0.35370952644"), std::string::npos) << seen;
  const std::string kept = read("out");
  EXPECT_NE(kept.find("T12 by boundaries"), std::string::npos) << kept;
  EXPECT_NE(kept.find(" of 20: interrupted"), std::string::npos) << kept;
}

TEST(ProgressLine, SaysWhatHowMuchAndHowLong) {
  EXPECT_EQ(progress_line({"tubes", 0.25, 5000, "points", 10, 0}),
            "tubes: 25 %, 5e+03 points, 500 points/s, 10 s, about 30 s left");
  EXPECT_EQ(progress_line({"reading", 0.5, 0, "", 600, 0}), "reading: 50 %, 10 min, about 10 min left");
  EXPECT_EQ(progress_line({"U to 3", 0, 0, "", 5, 8}), "U to 3: 5 s, next step in about 8 s");
  EXPECT_EQ(progress_line({"U", 0, 0, "", 5, 0}), "U: 5 s, time left not known yet");
}

}  // namespace
}  // namespace lober::cli

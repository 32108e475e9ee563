// Curves that are computed instead of read keep to the memory of the queue, and end soon when they are stopped.

#include <sys/stat.h>

#include <chrono>
#include <map>
#include <thread>

#include "engine/batch/plan_runner.hpp"
#include "lober/curve/files.hpp"
#include "tests/engine/batch/scratch_folder.hpp"

namespace lober::detail {
namespace {

using namespace std::string_literals;

class Generated : public ScratchFolder {
 protected:
  Generated() {
    write_npy(path("ring.npy"), wavy(200, 1));
    write_npy(path("other.npy"), wavy(200, 2));
  }
  // The message of each job that failed, by job; "" for one that did not.
  std::map<std::size_t, std::string> messages(const std::string& text, std::size_t memory, bool stop = false) {
    write("job.toml", text);
    const Plan plan = make_plan(read_manifest(path("job.toml")));
    const std::vector<std::uint32_t> jobs = jobs_of(plan, {});
    PlanRunner runner(plan, path("job.toml"), jobs, {.threads = 2, .memory = memory});
    std::map<std::size_t, std::string> found;
    std::thread stopper;
    if (stop) {
      stopper = std::thread([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        stopped_at_ = std::chrono::steady_clock::now();
        runner.stop();
      });
    }
    report_ = runner.run(jobs, [&](const Result& result) { found[result.job] = result.error; });
    if (stop) stopper.join();
    return found;
  }
  QueueReport report_;
  std::chrono::steady_clock::time_point stopped_at_;
};

constexpr std::size_t mebibytes = std::size_t{1} << 20;

TEST_F(Generated, ImagesThatExplodeStopAtTheBudget) {
  for (const char* const recipe :
       {"parameters = { K = 1e308 }, iterates = 3", "parameters = { K = 1.2 }, iterates = 59"}) {
    const auto found = messages(
        "operation = \"overlay\"\npairs = \"product\"\nwith = \"other.npy\"\n"
        "curves = [\"ring.npy\", { system = \"standard\", image_of = \"ring.npy\", tolerance = "
        "1e-5, "s +
            recipe + " }]\n",
        48 * mebibytes);
    ASSERT_EQ(found.size(), 2U) << recipe;
    EXPECT_EQ(found.at(0), "");
    EXPECT_NE(found.at(1).find("stopped early: needs more points than 48 MiB of memory have room for"),
              std::string::npos)
        << found.at(1);
    EXPECT_LE(report_.cache.peak_bytes, 49 * mebibytes);  // with what the job itself was given before
    EXPECT_GT(report_.cache.peak_bytes, 8 * mebibytes) << "what grows is not booked";
  }
}

TEST_F(Generated, ManifoldsThatGrowTooLongStopAtTheBudget) {
  const auto found = messages(
      "operation = \"tangle\"\npairs = [[{ system = \"henon\", manifold = \"unstable\", iterates = 60, tolerance = "
      "1e-6 }, "
      "{ system = \"henon\", manifold = \"stable\", iterates = 3, tolerance = 1e-6 }]]\n",
      48 * mebibytes);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found.at(0).find("needs more points"), std::string::npos) << found.at(0);
  // The other manifold of the job has its share, 120 bytes for each of 100 000 points, booked already.
  EXPECT_LE(report_.cache.peak_bytes, 64 * mebibytes);
}

TEST_F(Generated, CriteriaThatAskForTooManyPointsAreRefused) {
  for (const char* const options : {"max_length = 1e-300", "max_length = 1e-9", "angle = 1e-7, min_length = 1e-12"}) {
    const auto found =
        messages("operation = \"densify\"\ncurves = \"*.npy\"\noptions = { "s + options + " }\n", 48 * mebibytes);
    ASSERT_EQ(found.size(), 2U);
    for (const auto& [job, message] : found) {
      EXPECT_NE(message.find("the number that there is memory for"), std::string::npos) << options << ": " << message;
    }
    EXPECT_LE(report_.cache.peak_bytes, 49 * mebibytes);
  }
  EXPECT_EQ(
      messages("operation = \"densify\"\ncurves = \"*.npy\"\noptions = { max_length = 1e-4 }\n", 48 * mebibytes).at(0),
      "");
}

// Half a second is what a user waits; the test only wants that it is not the minutes that the whole would take.
TEST_F(Generated, StopsInTheMiddle) {
  const auto found = messages(
      "operation = \"densify\"\noptions = { max_length = 1 }\ncurves = { system = \"duffing\", image_of = "
      "\"ring.npy\", "
      "iterates = "
      "40, tolerance = 1e-9 }\n",
      std::size_t{4} << 30, true);
  const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - stopped_at_;
  EXPECT_TRUE(found.empty());
  EXPECT_TRUE(report_.stopped);
  EXPECT_LT(waited.count(), 10);
}

TEST_F(Generated, WhatHasNoEndIsNoInput) {
  for (const char* const input : {"/dev/zero", "pipe"}) {
    if (input[0] != '/') {
      ASSERT_EQ(mkfifo(path(input).c_str(), 0600), 0);
    }
    const auto found =
        messages("operation = \"densify\"\noptions = { max_length = 1 }\ncurves = [\"ring.npy\", \""s + input + "\"]\n",
                 48 * mebibytes);
    ASSERT_EQ(found.size(), 2U) << input;
    EXPECT_EQ(found.at(0), "");
    EXPECT_NE(found.at(1).find("is not a regular file"), std::string::npos) << found.at(1);
  }
}

}  // namespace
}  // namespace lober::detail

// A batch whose portions are computed as other processes would compute them.
#include "engine/batch/shared_run.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <sstream>

#include "engine/batch/export/export.hpp"
#include "lober/curve/files.hpp"
#include "tests/engine/batch/scratch_folder.hpp"
#include "tests/refusal.hpp"

namespace lober::detail {
namespace {

class SharedRunTest : public ScratchFolder {
 protected:
  SharedRunTest() {
    for (int k = 0; k < 20; ++k) write_npy(path("c." + std::to_string(k)), wavy(4000, k));
    write("c.bad", "0 0\n1 1\n1 0\n0 1\n");  // crosses itself
    write("job.toml", R"(curves = "c.*"
[[group]]
operation = "overlay"
options = { lobes = true }
[[group]]
operation = "interior"
)");
  }
  SharedRun started(const std::string& store) const {
    return {read_manifest(path("job.toml")), {path(store), {}, {}, {}}};
  }
  PortionOptions here() const { return {.manifest_path = path("job.toml")}; }
  std::string exported(const std::string& store) const {
    export_results(Store::open(path(store)), path("out.jsonl"), ExportFormat::json_lines);
    std::stringstream text;
    text << std::ifstream(path("out.jsonl")).rdbuf();
    return text.str();
  }
  std::string expected(std::size_t failed) const {
    EXPECT_EQ(run_batch(read_manifest(path("job.toml")), {path("whole"), {}, {.threads = 2}, {}}).queue.failed, failed);
    return exported("whole");
  }
};

TEST_F(SharedRunTest, PortionsInAnyOrderGiveTheBytesOfOneProcess) {
  SharedRun run = started("s");
  // Smaller ones than the queue gives, so that there are many.
  constexpr std::size_t max_jobs = 37;
  std::vector<std::vector<std::uint32_t>> portions;
  for (auto jobs = run.next_portion(1); !jobs.empty(); jobs = run.next_portion(1)) {
    for (std::size_t begin = 0; begin < jobs.size(); begin += max_jobs) {
      const auto first = jobs.begin() + static_cast<std::ptrdiff_t>(begin);
      portions.emplace_back(first, first + static_cast<std::ptrdiff_t>(std::min(max_jobs, jobs.size() - begin)));
    }
  }
  EXPECT_GE(portions.size(), 12U);
  std::shuffle(portions.begin(), portions.end(), std::mt19937(1));
  for (const auto& jobs : portions) run.add(jobs, run_portion(run.encoded(jobs), here()).results);
  run.finish("complete");
  EXPECT_EQ(run.report().queue.jobs, 420U);
  EXPECT_EQ(run.report().queue.failed, 40U);
  EXPECT_FALSE(run.report().queue.stopped);
  EXPECT_EQ(exported("s"), expected(40));
  EXPECT_EQ(started("s").pending(), 40U);  // those that failed are tried again
}

// Files elsewhere: below another folder, with the names of the manifest in messages and keys.
TEST_F(SharedRunTest, FilesMayLieElsewhereThere) {
  write("job.toml", "operation = \"overlay\"\ncurves = [\"c.*\", \"" + path("d.bad") + "\"]\n");
  write("d.bad", "0 0\n1 1\n1 0\n0 1\n0 0.5\n");
  const std::string whole = expected(41);
  EXPECT_NE(whole.find("d.bad: "), std::string::npos);
  const std::string root = path("copy"), folder = std::filesystem::path(path("job.toml")).parent_path();
  std::filesystem::create_directories(root + folder);
  SharedRun run = started("s");
  auto jobs = run.next_portion(1);
  for (auto more = run.next_portion(1); !more.empty(); more = run.next_portion(1)) {
    jobs.insert(jobs.end(), more.begin(), more.end());
  }
  EXPECT_EQ(run.files(jobs).size(), 22U);
  for (const std::string& file : run.files(jobs)) {
    const std::string from = located(path("job.toml"), file);
    std::filesystem::rename(from, root + from);
  }
  PortionOptions there{.manifest_path = root + path("job.toml"), .files_root = root};
  there.names = {{root + folder + "/", folder + "/"}, {root, ""}};
  const std::string portion = run.encoded(jobs);
  run.add(jobs, run_portion(portion, there).results);
  run.finish("complete");
  for (const std::string& file : run.files(jobs)) {
    const std::string back = located(path("job.toml"), file);
    std::filesystem::rename(root + back, back);
  }
  EXPECT_EQ(exported("s"), whole);
}

TEST_F(SharedRunTest, PortionsOfAllPairsShareCurves) {
  for (int k = 0; k < 100; ++k) write("many." + std::to_string(k), "0 0\n1 0\n0 1\n");
  write("job.toml", "operation = \"overlay\"\ncurves = \"many.*\"\n");
  SharedRun run = started("s");
  std::set<std::uint32_t> seen;
  for (auto jobs = run.next_portion(4); !jobs.empty(); jobs = run.next_portion(4)) {
    for (const std::uint32_t job : jobs) EXPECT_TRUE(seen.insert(job).second);
    const double most = 4 * std::sqrt(static_cast<double>(jobs.size())) + 2;
    EXPECT_LE(static_cast<double>(run.files(jobs).size()), most) << jobs.size();
  }
  EXPECT_EQ(seen.size(), 4950U);
}

TEST_F(SharedRunTest, ResultsOfOtherContentsAreNotStored) {
  SharedRun run = started("s");
  const auto first = run.next_portion(4), second = run.next_portion(4);
  run.add(first, run_portion(run.encoded(first), here()).results);
  const std::size_t failed = run.report().queue.failed;
  for (const std::string& file : run.files(first)) write_npy(path(file), wavy(4000, 77));
  run.add(first, run_portion(run.encoded(first), here()).results);
  EXPECT_EQ(run.report().queue.failed, failed + first.size());
  run.finish("stopped");
}

TEST_F(SharedRunTest, OtherBytesAreRefused) {
  SharedRun run = started("s");
  const auto jobs = run.next_portion(4);
  const std::string results = run_portion(run.encoded(jobs), here()).results;
  EXPECT_THROW(run.add(jobs, results.substr(0, results.size() / 2)), DataError);
  EXPECT_THROW(run.add(std::span(jobs).first(1), results), DataError);
  const std::vector<std::uint32_t> two(jobs.begin(), jobs.begin() + 2);
  const std::string one = run_portion(run.encoded(std::span(two).first(1)), here()).results;
  EXPECT_EQ(test::refusal<DataError>([&] { run.add(two, one); }),
            "the bytes that came back are not the results of their jobs");
  EXPECT_THROW((void)run_portion("plan", here()), DataError);
  run.add(jobs, results);
  run.finish("stopped");
  EXPECT_TRUE(run.report().queue.stopped);
}

TEST_F(SharedRunTest, JobsThatNobodyCouldComputeAreNotedAndRunAgain) {
  {
    SharedRun run = started("s");
    for (const std::uint32_t job : {0U, 1U}) run.fail(job, "four workers ended");
    run.finish("stopped");
    EXPECT_EQ(run.report().queue.failed, 2U);
  }
  EXPECT_NE(exported("s").find("four workers ended"), std::string::npos);
  SharedRun again = started("s");
  EXPECT_EQ(again.pending(), 420U);
  for (auto jobs = again.next_portion(1); !jobs.empty(); jobs = again.next_portion(1)) {
    again.add(jobs, run_portion(again.encoded(jobs), here()).results);
  }
  again.finish("complete");
  EXPECT_EQ(exported("s"), expected(40));
}

}  // namespace
}  // namespace lober::detail

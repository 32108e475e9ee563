// Curves that portions hand on to those after them.
#include "engine/batch/queue/kept_curves.hpp"

#include <fstream>
#include <mutex>
#include <sstream>
#include <thread>

#include "engine/batch/export/export.hpp"
#include "engine/batch/shared_run.hpp"
#include "lober/curve/files.hpp"
#include "tests/engine/batch/scratch_folder.hpp"

namespace lober::detail {
namespace {

class KeptCurvesTest : public ScratchFolder {
 protected:
  static constexpr std::size_t points = 4000;

  KeptCurvesTest() {
    for (int k = 0; k < 12; ++k) write_npy(path("c." + std::to_string(k)), wavy(points, k));
    write("c.bad", "0 0\n1 1\n1 0\n0 1\n");  // crosses itself
    write_job("");
  }
  void write_job(const std::string& options) const {
    write("job.toml", "operation = \"overlay\"\ncurves = \"c.*\"\npairs = \"all\"\n" + options);
  }
  [[nodiscard]] std::string exported(const std::string& store) const {
    export_results(Store::open(path(store)), path("out.jsonl"), ExportFormat::json_lines);
    std::stringstream text;
    text << std::ifstream(path("out.jsonl")).rdbuf();
    return text.str();
  }
  /// The export of one process that keeps nothing.
  [[nodiscard]] std::string expected(const std::string& store) const {
    (void)run_batch(read_manifest(path("job.toml")), {path(store), {}, {.threads = 1}, {}});
    return exported(store);
  }
  /// The same by portions of 9 jobs, `threads` at a time.
  std::string by_portions(const std::string& store, KeptCurves& kept, std::size_t memory = 0, int threads = 1) const {
    SharedRun run(read_manifest(path("job.toml")), {path(store), {}, {}, {}});
    std::vector<std::uint32_t> jobs;
    for (auto more = run.next_portion(1); !more.empty(); more = run.next_portion(1)) {
      jobs.insert(jobs.end(), more.begin(), more.end());
    }
    std::mutex mutex;
    std::size_t next = 0;
    const auto work = [&] {
      std::unique_lock lock(mutex);
      while (next < jobs.size()) {
        const std::size_t count = std::min<std::size_t>(9, jobs.size() - next);
        const std::span<const std::uint32_t> mine = std::span(jobs).subspan(next, count);
        next += count;
        const std::string portion = run.encoded(mine);
        lock.unlock();
        const PortionOptions options{
            .manifest_path = path("job.toml"), .queue = {.threads = 1, .memory = memory}, .kept = &kept};
        const std::string results = run_portion(portion, options).results;
        lock.lock();
        run.add(mine, results);
      }
    };
    std::vector<std::thread> others;
    for (int k = 1; k < threads; ++k) others.emplace_back(work);
    work();
    for (std::thread& other : others) other.join();
    run.finish("complete");
    return exported(store);
  }
};

constexpr std::chrono::seconds no_age{0};

TEST_F(KeptCurvesTest, EachFileIsReadOnce) {
  KeptCurves kept(std::size_t{1} << 30, no_age);
  EXPECT_EQ(by_portions("s", kept), expected("whole"));
  EXPECT_EQ(kept.counts().kept, 13U);
  EXPECT_GT(kept.counts().found, 13U);
  EXPECT_EQ(kept.counts().occupied_bytes, 0U);
  EXPECT_GT(kept.counts().idle_bytes, 12 * points * sizeof(Point));
  const std::uint64_t found = kept.counts().found;
  EXPECT_EQ(by_portions("t", kept), exported("whole"));  // another run
  EXPECT_EQ(kept.counts().kept, 13U);
  EXPECT_GT(kept.counts().found, found + 12);
}

TEST_F(KeptCurvesTest, AFileThatChangesIsReadAgain) {
  KeptCurves kept(std::size_t{1} << 30, no_age);
  const std::string before = by_portions("s", kept);
  write_npy(path("c.3"), wavy(points, 77));  // of the same size
  const std::string after = by_portions("t", kept);
  EXPECT_NE(after, before);
  EXPECT_EQ(after, expected("whole"));
  EXPECT_EQ(kept.counts().kept, 14U);
  EXPECT_EQ(kept.counts().curves, 13U);
  std::filesystem::remove(path("c.5"));
  write("c.5", "0 0\n2 0\n0 2\n");
  EXPECT_EQ(by_portions("u", kept), expected("whole2"));
}

// A clock of a file system has ticks: a file that was changed in this one may change again without a sign.
TEST_F(KeptCurvesTest, AFileThatHasJustChangedIsNotKept) {
  KeptCurves kept(std::size_t{1} << 30, std::chrono::hours(1));
  EXPECT_EQ(by_portions("s", kept), expected("whole"));
  EXPECT_EQ(kept.counts().kept, 0U);
  EXPECT_EQ(kept.counts().curves, 0U);
}

TEST_F(KeptCurvesTest, MemoryIsWithinTheBudget) {
  const std::string whole = expected("whole");
  for (const std::size_t budget : {std::size_t{1}, 3 * points * 21, 6 * points * 21}) {
    KeptCurves kept(budget, no_age);
    EXPECT_EQ(by_portions("s" + std::to_string(budget), kept, budget), whole);
    EXPECT_LE(kept.counts().idle_bytes, budget);
    EXPECT_GT(kept.counts().dropped, 0U);
    EXPECT_EQ(kept.counts().occupied_bytes, 0U);
  }
  KeptCurves kept(std::size_t{1} << 30, no_age);
  (void)by_portions("s", kept);
  const std::size_t all = kept.counts().idle_bytes;
  kept.occupy(static_cast<std::ptrdiff_t>((std::size_t{1} << 30) - all / 2));  // by what others take
  EXPECT_LE(kept.counts().idle_bytes, all / 2);
  EXPECT_GT(kept.counts().idle_bytes, all / 4);
  kept.set_budget(1);
  EXPECT_EQ(kept.counts().curves, 0U);
  kept.occupy(-static_cast<std::ptrdiff_t>((std::size_t{1} << 30) - all / 2));
}

TEST_F(KeptCurvesTest, SeveralPortionsAtATimeShareThem) {
  const std::string whole = expected("whole");
  for (const std::size_t budget : {4 * points * 21, std::size_t{1} << 30}) {
    KeptCurves kept(budget, no_age);
    EXPECT_EQ(by_portions("s" + std::to_string(budget), kept, 3 * points * 21, 4), whole);
    EXPECT_EQ(kept.counts().occupied_bytes, 0U);
  }
}

// A fault that one run looks for is none in another, nor in another group of the same run.
TEST_F(KeptCurvesTest, CurvesArePreparedForWhatARunWants) {
  KeptCurves kept(std::size_t{1} << 30, no_age);
  const auto failures = [](const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find("is not simple", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  EXPECT_EQ(failures(by_portions("s", kept)), 12U);
  write_job("options = { check_simple = false }\n");
  const std::string other = by_portions("t", kept);
  EXPECT_EQ(other, expected("whole"));
  EXPECT_EQ(failures(other), 0U);
  write("job.toml", R"(curves = "c.*"
[[group]]
operation = "overlay"
options = { check_simple = false }
[[group]]
operation = "overlay"
[[group]]
operation = "winding"
)");
  const std::string both = by_portions("u", kept);
  EXPECT_EQ(both, expected("whole2"));
  EXPECT_EQ(failures(both), 12U);
  EXPECT_EQ(kept.counts().curves, 13U);
}

TEST_F(KeptCurvesTest, ComputedCurvesAreGrownOnce) {
  write("job.toml",
        "operation = \"tangle\"\npairs = [[{ system = \"henon\", manifold = \"unstable\", iterates = 6, tolerance = "
        "1e-3 }, "
        "{ system = \"henon\", manifold = \"stable\", iterates = 6, tolerance = 1e-3 }]]\n");
  KeptCurves kept(std::size_t{1} << 30, no_age);
  EXPECT_EQ(by_portions("s", kept), expected("whole"));
  EXPECT_EQ(by_portions("t", kept), exported("whole"));
  EXPECT_EQ(kept.counts().kept, 2U);
  EXPECT_EQ(kept.counts().found, 2U);
}

}  // namespace
}  // namespace lober::detail

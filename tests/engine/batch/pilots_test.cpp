// Estimates of the time of jobs against the processor time that they take.
#include "engine/batch/manifest/pilots.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/processor_time.hpp"
#include "engine/batch/operations/operation.hpp"
#include "lober/base/error.hpp"
#include "tests/engine/batch/scratch_folder.hpp"

namespace lober::detail {
namespace {

class Pilots : public ScratchFolder {
 protected:
  Plan plan_of(const std::string& text) {
    write("job.toml", text);
    return make_plan(read_manifest(path("job.toml")));
  }
  // With whole pilots, however slow the machine is.
  double estimated(const std::string& text) {
    const Piloted found = run_pilots(plan_of(text), unlimited);
    return std::accumulate(found.seconds.begin(), found.seconds.end(), 0.0);
  }
  static constexpr PilotLimits unlimited{std::numeric_limits<double>::infinity(),
                                         std::numeric_limits<double>::infinity()};
  double taken(const std::string& text) {
    const Plan plan = plan_of(text);
    double seconds = 0;
    with_threads(1, [&] {
      const double start = processor_seconds();
      for (const Job& job : plan.jobs) {
        const JobGroup& group = plan.group_of(job);
        (void)group.operation->run({{}, Allowance()}, group.options);
      }
      seconds = processor_seconds() - start;
    });
    return seconds;
  }
};

TEST_F(Pilots, EscapesAreEstimatedWithinAFactorOfThree) {
  for (const char* const batch :
       {"options = { system = \"capsize\" }\n",
        "options = { system = \"capsize\" }\ngrid = { crossings = \"1:4:1\" }\n",
        "options = { system = \"capsize\", monte_carlo = 0 }\ngrid = { energy = \"0.251:0.263:0.003\" }\n",
        "options = { system = \"capsize\", tolerance = 1e-7 }\n",
        "options = { system = \"capsize\", tolerance = 1e-3 }\n",
        "options = { system = \"capsize\", crossings = 0 }\ngrid = { energy = \"0.251:0.301:0.01\" }\n",
        "options = { system = \"capsize\", crossings = 2, monte_carlo = 100000 }\n"}) {
    const std::string text = std::string("operation = \"escape\"\n") + batch;
    const double forecast = estimated(text), true_seconds = taken(text);
    EXPECT_LT(std::fabs(std::log(forecast / true_seconds)), std::log(3)) << text << forecast << " and " << true_seconds;
  }
}

TEST_F(Pilots, TheyAreSpreadOverAGrid) {
  const Plan grid = plan_of(
      "operation = \"escape\"\noptions = { system = \"capsize\", monte_carlo = 0, crossings = 0, tolerance = 1e-2 }\n"
      "grid = { energy = \"0.251:0.300:0.0001\" }\n");
  const Piloted found = run_pilots(grid, unlimited);
  EXPECT_EQ(found.jobs.size(), 491U);
  EXPECT_EQ(found.run, 9U);
  for (const double seconds : found.seconds) EXPECT_GT(seconds, 0);
  // One at least, however short the time.
  EXPECT_EQ(run_pilots(grid, {0, unlimited.clock}).run, 1U);
  const Estimate with_pilots = estimate(grid, path("job.toml"));
  EXPECT_GE(with_pilots.pilots, 1U);
  EXPECT_LE(with_pilots.pilots, 9U);
  EXPECT_GT(with_pilots.core_seconds, 0);
  write("curve", "0 0\n1 0\n0 1\n");
  EXPECT_EQ(estimate(plan_of("operation = \"regions\"\ncurves = \"curve\"\n"), path("job.toml")).pilots, 0U);
}

// A job that fails takes the time until then, not that of the work.
TEST_F(Pilots, JobsThatFailTakeNoTime) {
  EXPECT_LT(estimated("operation = \"escape\"\noptions = { system = \"capsize\", energy = 0.2 }\n"),
            estimated("operation = \"escape\"\noptions = { system = \"capsize\" }\n") / 3);
}

}  // namespace
}  // namespace lober::detail

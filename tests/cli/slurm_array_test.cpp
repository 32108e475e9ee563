// examples/slurm_batch.sh, with the variables that Slurm sets for the tasks of an array. scripts/slurm-check.sh runs it
// under Slurm.

#include "tests/cli/program.hpp"
#include "tests/paths.hpp"

namespace lober::cli {
namespace {

class SlurmArray : public ProgramTest {
 protected:
  SlurmArray() {
    for (int k = 0; k < 12; ++k) write_curve("separ." + std::to_string(k), flower(300, 5 + k, 0.3, {0.01 * k, 0}));
    write("job.toml", "operation = \"overlay\"\ncurves = \"separ.*\"\noptions = { lobes = true }\n");
    EXPECT_EQ(run({"batch", "run", "job.toml", "--store", "whole"}).status, 0);
  }
  Outcome submit(const std::string& variables) const {
    return run_in_bash("export SLURM_CPUS_PER_TASK=1 SLURM_MEM_PER_CPU=100 " + variables + "\n. " + LOBER_SOURCE_DIR +
                       "/examples/slurm_batch.sh job.toml");
  }
  Outcome task(int number, int first, int count) const {
    return submit("SLURM_ARRAY_TASK_ID=" + std::to_string(number) + " SLURM_ARRAY_TASK_MIN=" + std::to_string(first) +
                  " SLURM_ARRAY_TASK_COUNT=" + std::to_string(count));
  }
  std::string exported(const std::string& store) const {
    const Outcome outcome = run({"batch", "export", store, "--format", "jsonl"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  }
};

TEST_F(SlurmArray, TasksAndTheirMergerGiveTheBytesOfOneProcess) {
  for (const int number : {3, 1, 2}) {
    const Outcome outcome = task(number, 1, 3);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
  const Outcome merged = submit("SLURM_JOB_ID=7");
  EXPECT_EQ(merged.out, "66 done, 0 failed, 0 to do\n") << merged.err;
  EXPECT_EQ(exported("job.results"), exported("whole"));
}

TEST_F(SlurmArray, MayCountFromNoughtAndBecomeSmallerAfterTasksThatDied) {
  EXPECT_EQ(task(0, 0, 4).status, 0);
  EXPECT_EQ(task(2, 0, 4).status, 0);
  EXPECT_EQ(submit("SLURM_JOB_ID=7").out, "32 done, 0 failed, 34 to do\n");
  for (const int number : {0, 1}) EXPECT_EQ(task(number, 0, 2).status, 0);
  EXPECT_EQ(submit("SLURM_JOB_ID=7").out, "66 done, 0 failed, 0 to do\n");
  EXPECT_EQ(exported("job.results"), exported("whole"));
}

}  // namespace
}  // namespace lober::cli

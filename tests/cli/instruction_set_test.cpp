// LOBER_ISA: other copies of the kernels, the same bytes.

#include <cstdlib>

#include "kernels/cpu.hpp"
#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

class InstructionSets : public ProgramTest {
 protected:
  InstructionSets() {
    write_curve("a.dat", flower(20000, 300, 0.3, {0, 0}));
    write_curve("b.dat", flower(20000, 301, 0.3, {0.01, 0.02}));
  }
  ~InstructionSets() override { unsetenv("LOBER_ISA"); }  // NOLINT(concurrency-mt-unsafe): one thread

  Outcome run_with(std::string_view name) const {
    setenv("LOBER_ISA", std::string(name).c_str(), 1);  // NOLINT(concurrency-mt-unsafe): one thread
    return run({"overlay", "a.dat", "b.dat", "--json", "-"});
  }
};

TEST_F(InstructionSets, GiveTheSameBytes) {
  const std::string expected = without_timing(run({"overlay", "a.dat", "b.dat", "--json", "-"}).out);
  EXPECT_NE(expected.find("\"crossings\""), std::string::npos);
  for (const std::string_view name : instruction_set_names()) {
    const Outcome outcome = run_with(name);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(without_timing(outcome.out), expected) << name;
  }
}

TEST_F(InstructionSets, UnknownOnesAreRefused) {
  const Outcome outcome = run_with("avx3");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("LOBER_ISA is avx3"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace lober::cli

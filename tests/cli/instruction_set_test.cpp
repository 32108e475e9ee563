// LOBER_ISA and --threads: other copies of the kernels, other numbers of threads, the same bytes.

#include <cstdlib>

#include "kernels/cpu.hpp"
#include "tests/cli/program.hpp"

namespace lober::cli {
using namespace lober::detail;
namespace {

class InstructionSets : public ProgramTest {
 protected:
  InstructionSets() {
    write_curve("a.dat", flower(20000, 300, 0.3, {0, 0}));
    write_curve("b.dat", flower(20000, 301, 0.3, {0.01, 0.02}));
  }
  ~InstructionSets() override { unsetenv("LOBER_ISA"); }  // NOLINT(concurrency-mt-unsafe): one thread

  Outcome run_with(std::string_view name, const std::vector<std::string>& arguments) const {
    setenv("LOBER_ISA", std::string(name).c_str(), 1);  // NOLINT(concurrency-mt-unsafe): one thread
    return run(arguments);
  }
  // The JSON without its timing; `needle` has to occur in it.
  void expect_same_bytes(std::vector<std::string> arguments, const std::string& needle) const {
    arguments.insert(arguments.end(), {"--json", "-", "--threads", "1"});
    const Outcome alone = run(arguments);
    EXPECT_EQ(alone.status, 0) << alone.err;
    EXPECT_NE(alone.out.find(needle), std::string::npos) << alone.out;
    const char* threads = "7";
    for (const std::string_view name : instruction_set_names()) {
      arguments.back() = threads;
      const Outcome outcome = run_with(name, arguments);
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_EQ(without_timing(outcome.out), without_timing(alone.out)) << name << ", " << threads << " threads";
      threads = "2";
    }
  }
};

TEST_F(InstructionSets, OverlayHasTheSameBytes) {
  expect_same_bytes({"overlay", "a.dat", "b.dat"}, "\"crossings\"");
}

TEST_F(InstructionSets, TransportHasTheSameBytes) {
  expect_same_bytes({"transport", "ovp", "--param", "gamma=0.5", "--iterates", "3", "--tolerance", "1e-4"},
                    "\"flux21\"");
}

TEST_F(InstructionSets, EscapeHasTheSameBytes) {
  expect_same_bytes({"escape", "capsize", "--energy", "0.25307", "--crossings", "1", "--tolerance", "1e-3"},
                    "\"energy\"");
}

TEST_F(InstructionSets, UnknownOnesAreRefused) {
  const Outcome outcome = run_with("avx3", {"overlay", "a.dat", "b.dat"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("LOBER_ISA is avx3"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace lober::cli

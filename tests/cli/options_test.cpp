// Messages of the program for command lines that cannot be understood.
#include <filesystem>
#include <sstream>

#include "tests/cli/program.hpp"
#include "tests/paths.hpp"

namespace lober::cli {
namespace {

class Options : public ProgramTest {};

TEST_F(Options, AreRefusedInOneSentence) {
  struct Case {
    std::vector<std::string> arguments;
    const char* message;
  };
  const std::vector<Case> cases{
      {{"overlay"}, "C1 is missing (see lober overlay --help)"},
      {{"overlay", "a", "b", "c"}, "unexpected argument \"c\" (see lober overlay --help)"},
      {{"overlay", "a", "b", "--thread", "1"},
       "there is no option --thread; did you mean --threads? (see lober overlay --help)"},
      {{"overlay", "a", "b", "--bogus"}, "there is no option --bogus (see lober overlay --help)"},
      {{"overlay", "a", "b", "--threads"}, "--threads needs a value, N (see lober overlay --help)"},
      {{"overlay", "a", "b", "--threads", "1", "--threads", "2"},
       "--threads is given twice (see lober overlay --help)"},
      {{"overlay", "a", "b", "--threads", "x"},
       "--threads: x is not a whole number from 1 to 4096 (see lober overlay --help)"},
      {{"overlay", "a", "b", "--index", "foo"},
       "--index: \"foo\" is not auto, tree, grid or kd (see lober overlay --help)"},
      {{"grow", "--system", "henon", "--from", "1"}, "--from takes 2 values, X,Y, not 1 (see lober grow --help)"},
      {{"grow", "--system", "henon", "--from", "1,2,3"}, "--from takes 2 values, X,Y, not 3 (see lober grow --help)"},
      {{"grow", "--frm"}, "there is no option --frm; did you mean --from? (see lober grow --help)"},
      {{"escape", "capsize", "--energy", "x"}, "--energy: \"x\" cannot be read as a number (see lober escape --help)"},
      {{"overley", "a", "b"}, "\"overley\" is neither a command nor a file; did you mean overlay? (see lober --help)"},
      {{"image", "standard", "--circle", "3,0,0.5", "--budget", "5"},
       "there is no option --budget (see lober image --help)"},
      {{"grow"}, "--system is missing (see lober grow --help)"},
      {{"--bogus"}, "unknown option --bogus (see lober --help)"},
  };
  for (const Case& one : cases) {
    const Outcome outcome = run(one.arguments);
    EXPECT_EQ(outcome.status, 2) << one.message;
    EXPECT_EQ(outcome.out, "") << one.message;
    EXPECT_EQ(outcome.err, std::string("lober: ") + one.message + "\n");
  }
}

// A file whose name begins with '-' is named by ./ or behind --.
TEST_F(Options, FilesWhoseNamesBeginWithADash) {
  write_curve("-dash", box(0, 0, 1, 1));
  write_curve("square", box(0, 0, 1, 1));
  EXPECT_EQ(run({"overlay", "square", "./-dash"}).status, 0);
  EXPECT_EQ(run({"overlay", "--areas-only", "--", "-dash", "square"}).status, 0);
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& message) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "lober: " + message + "\n");
  };
  refused({"overlay", "-dash", "square"},
          "there is no option -dash; the file of that name is ./-dash (see lober overlay --help)");
  refused({"overlay", "square", "-dash#0"},
          "there is no option -dash#0; the file of that name is ./-dash#0 (see lober overlay --help)");
  refused({"winding", "--", "-dash", "--at", "0.5,0.5"},
          "unexpected argument \"--at\" behind --, which ends the options (see lober winding --help)");
  refused({"simplify", "--", "-dash", "--tolerance", "0"},
          "unexpected argument \"--tolerance\" behind --, which ends the options (see lober simplify --help)");
  refused({"overlay", "--bogus", "--", "-dash", "square"}, "there is no option --bogus (see lober overlay --help)");
  refused({"overlay", "--", "-dash"}, "C2 is missing (see lober overlay --help)");
}

// Each in a folder with the examples, and with a manifest job.toml and the store of its second shard.
TEST_F(Options, ExamplesOfTheHelpRun) {
  std::filesystem::create_directory_symlink(std::filesystem::path(LOBER_SOURCE_DIR) / "examples",
                                            folder() / "examples");
  write("job.toml", "operation = \"overlay\"\ncurves = \"examples/resonance*.dat\"\n");
  ASSERT_EQ(run({"batch", "run", "job.toml", "--quiet", "--shard", "2/2", "--store", "job2.results"}).status, 0);
  ASSERT_EQ(run({"batch", "run", "job.toml", "--quiet", "--store", "more.results"}).status, 0);
  std::vector<std::string> helps{"--help",
                                 "tangle --system henon --help",
                                 "transport --manifolds a --help",
                                 "batch --help",
                                 "batch run --help",
                                 "batch check --help",
                                 "batch status --help",
                                 "batch export --help",
                                 "batch merge --help",
                                 "batch manifest --help",
                                 "batch operations --help"};
  std::istringstream commands(run({"--generate", "commands"}).out);
  for (std::string command; std::getline(commands, command);) {
    if (command != "batch") helps.push_back(command + " --help");
  }
  EXPECT_GE(helps.size(), 30U);
  for (const std::string& help : helps) {
    std::istringstream text(run_in_bash("lober " + help).out);
    std::size_t examples = 0;
    for (std::string line; std::getline(text, line) && !line.starts_with("Usage:");) {
      if (!line.starts_with("  lober ")) continue;
      const Outcome outcome = run_in_bash(line);
      EXPECT_EQ(outcome.status, 0) << line << "\n" << outcome.err;
      EXPECT_TRUE(!outcome.out.empty() || line.find('>') != std::string::npos) << line;
      ++examples;
    }
    EXPECT_GE(examples, 2U) << help;
  }
}

}  // namespace
}  // namespace lober::cli

// Messages of the program for command lines that cannot be understood.
#include <filesystem>
#include <iterator>
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
       "there is no option --thread; is --threads meant? (see lober overlay --help)"},
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
      {{"grow", "--frm"}, "--system is missing (see lober grow --help)"},
      {{"escape", "capsize", "--energy", "x"}, "--energy: \"x\" cannot be read as a number (see lober escape --help)"},
      {{"overley", "a", "b"}, "\"overley\" is neither a command nor a file; did you mean overlay? (see lober --help)"},
      {{"--bogus"}, "unknown option --bogus (see lober --help)"},
  };
  for (const Case& one : cases) {
    const Outcome outcome = run(one.arguments);
    EXPECT_EQ(outcome.status, 2) << one.message;
    EXPECT_EQ(outcome.out, "") << one.message;
    EXPECT_EQ(outcome.err, std::string("lober: ") + one.message + "\n");
  }
}

TEST_F(Options, ExamplesOfTheHelpRun) {
  std::filesystem::create_directory_symlink(std::filesystem::path(LOBER_SOURCE_DIR) / "examples",
                                            folder() / "examples");
  std::size_t ran = 0;
  for (const std::vector<std::string>& help : std::vector<std::vector<std::string>>{{"overlay"},
                                                                                    {"interior"},
                                                                                    {"regions"},
                                                                                    {"tangle"},
                                                                                    {"tangle", "--system", "henon"},
                                                                                    {"densify"},
                                                                                    {"simplify"},
                                                                                    {"transport"},
                                                                                    {"transport", "--manifolds", "a"},
                                                                                    {"sweep"},
                                                                                    {"escape"},
                                                                                    {"fixed-points"},
                                                                                    {"levels"},
                                                                                    {"section"},
                                                                                    {"grow"},
                                                                                    {"image"}}) {
    std::vector<std::string> arguments = help;
    arguments.emplace_back("--help");
    std::istringstream text(run(arguments).out);
    std::size_t examples = 0;
    for (std::string line; std::getline(text, line) && !line.starts_with("Usage:");) {
      if (!line.starts_with("  lober ")) continue;
      std::istringstream words(line.substr(8));
      const std::vector<std::string> command{std::istream_iterator<std::string>(words), {}};
      const Outcome outcome = run(command);
      EXPECT_EQ(outcome.status, 0) << line << "\n" << outcome.err;
      EXPECT_NE(outcome.out, "") << line;
      ++examples;
    }
    EXPECT_GT(examples, 0U) << help.back();
    ran += examples;
  }
  EXPECT_GE(ran, 20U);
}

}  // namespace
}  // namespace lober::cli

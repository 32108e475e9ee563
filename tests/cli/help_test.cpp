// The help of each command, and --version.

#include <algorithm>
#include <set>
#include <sstream>

#include "cli/program/commands.hpp"
#include "cli/program/wrapped_text.hpp"
#include "lober/base/version.hpp"
#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

class Help : public ProgramTest {
 protected:
  [[nodiscard]] std::string text(std::vector<std::string> words) const {
    words.emplace_back("--help");
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }
  // The words of each command and subcommand, and of the other forms of tangle and transport.
  [[nodiscard]] std::vector<std::vector<std::string>> commands() const {
    std::vector<std::vector<std::string>> list{{"tangle", "--system", "henon"}, {"transport", "--manifolds", "u"}};
    std::istringstream names(run({"--generate", "commands"}).out);
    for (std::string name; std::getline(names, name);) {
      if (name != "batch") list.push_back({name});
    }
    for (const char* const verb : {"run", "check", "status", "export", "merge", "manifest", "operations"}) {
      list.push_back({"batch", verb});
    }
    return list;
  }
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// The longest line, but for command lines, which have to be copied in one piece.
std::size_t longest_line(const std::string& text) {
  std::size_t longest = 0;
  for (const std::string& line : lines_of(text)) {
    if (!line.starts_with("  lober ")) longest = std::max(longest, line.size());
  }
  return longest;
}

TEST_F(Help, BeginsWithTheTaskAndExamplesAndEndsWithTheReference) {
  const std::vector<std::vector<std::string>> all = commands();
  EXPECT_GE(all.size(), 25U);
  for (const std::vector<std::string>& words : all) {
    const std::string help = text(words);
    const std::string name = words[0] == "batch" ? "lober batch " + words[1] : "lober " + words[0];
    SCOPED_TRACE(name);
    const std::size_t examples = help.find("\n\nExamples:\n  lober "), usage = help.find("\n\nUsage: " + name);
    EXPECT_LT(25U, examples) << help;  // a sentence
    ASSERT_NE(usage, std::string::npos) << help;
    EXPECT_LT(examples, usage);
    const std::vector<std::string> before = lines_of(help.substr(0, usage));
    EXPECT_GE(
        std::count_if(before.begin(), before.end(), [](const auto& line) { return line.starts_with("  lober "); }), 2);
    std::string anchor = name;
    std::replace(anchor.begin(), anchor.end(), ' ', '-');
    EXPECT_EQ(lines_of(help).back(),
              "Reference: share/doc/lober/html/reference.html#" + anchor + " or docs/reference.md");
    EXPECT_NE(help.find("\nRunning:\n"), std::string::npos);
    EXPECT_NE(help.find("  -h, --help "), std::string::npos);
  }
}

TEST_F(Help, FitsTheWidth) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{}, {"batch"}, {"overlay"}, {"image"}}) {
    for (const auto& [columns, most] : {std::pair<const char*, std::size_t>{nullptr, 100},
                                        {"80", 80},
                                        {"93", 93},
                                        {"120", 120},
                                        {"40", 80},
                                        {"300", 120},
                                        {"wide", 100}}) {
      const Environment environment("COLUMNS", columns);
      const std::size_t longest = longest_line(text(words));
      EXPECT_LE(longest, most);
      EXPECT_GE(longest, most - 12);  // and uses it
    }
  }
}

TEST_F(Help, FitsTheTerminal) {
  if (!is_installed("script")) GTEST_SKIP() << "script, which makes a terminal, is not installed";
  const Environment environment("COLUMNS", nullptr);
  for (const std::size_t columns : {90U, 60U, 200U}) {
    const Outcome outcome =
        run_in_bash("script -qec 'stty cols " + std::to_string(columns) + "; lober overlay --help' /dev/null");
    const std::size_t longest = longest_line(outcome.out) - 1;  // the terminal adds a carriage return
    const std::size_t most = std::clamp(columns, std::size_t{80}, std::size_t{120});
    EXPECT_LE(longest, most) << outcome.out;
    EXPECT_GE(longest, most - 12);
  }
}

TEST_F(Help, GroupsOptions) {
  const std::string help = text({"overlay"});
  const auto at = [&](const std::string& words) {
    const std::size_t found = help.find(words);
    EXPECT_NE(found, std::string::npos) << words;
    return found;
  };
  const std::size_t inputs = at("\nCurves and inputs:\n"), computation = at("\nComputation:\n"),
                    accuracy = at("\nAccuracy:\n"), results = at("\nResults and files:\n"),
                    pictures = at("\nPictures:\n"), running = at("\nRunning:\n");
  EXPECT_TRUE(inputs < computation && computation < accuracy && accuracy < results && results < pictures &&
              pictures < running);
  const auto expect_in = [&](const std::string& option, std::size_t group, std::size_t next) {
    const std::size_t found = at("\n  " + option);
    EXPECT_TRUE(group <= found && found < next) << option;
  };
  expect_in("C1 ", inputs, computation);
  expect_in("--rule RULE", inputs, computation);
  expect_in("--areas-only", computation, accuracy);
  expect_in("--smooth", accuracy, results);
  expect_in("--json FILE", results, pictures);
  expect_in("--window X0,Y0,X1,Y1", pictures, running);
  expect_in("--threads N", running, help.size());
  EXPECT_NE(help.find("Needs --picture."), std::string::npos);
  // --boundary names a file here, and is a curve to begin with there.
  EXPECT_LT(text({"tangle"}).find("Results and files"), text({"tangle"}).find("--boundary FILE"));
  EXPECT_LT(text({"image"}).find("\n  --boundary"), text({"image"}).find("Accuracy"));
}

TEST_F(Help, IsWhatHelpPrints) {
  EXPECT_EQ(run({"help"}).out, text({}));
  EXPECT_EQ(run({"help", "overlay"}).out, text({"overlay"}));
  EXPECT_EQ(run({"help", "batch", "run"}).out, text({"batch", "run"}));
  EXPECT_EQ(run({"help", "doctor"}).out, text({"doctor"}));
  const std::string help = text({});
  for (const std::vector<std::string>& words : commands()) {
    EXPECT_NE(help.find("\n  lober " + words[0] + " "), std::string::npos) << words[0];
  }
  EXPECT_EQ(run({"-h"}).out, help);
}

TEST_F(Help, NothingIsAnsweredInOneLine) {
  const Outcome outcome = run({});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "lober: no command is given (see lober --help)\n");
}

TEST_F(Help, VersionIsTheSameEverywhere) {
  const std::string line = std::string("lober ") + version() + "\n";
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--version"},
                                                {"overlay", "--version"},
                                                {"overlay", "a", "b", "--version"},
                                                {"batch", "run", "--version"},
                                                {"regions", "--version"}}) {
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, line);
    EXPECT_EQ(outcome.err, "");
  }
  const Outcome verbose = run({"--version", "--verbose"});
  EXPECT_EQ(verbose.status, 0);
  EXPECT_TRUE(verbose.out.starts_with(line));
  for (const char* const word : {"TBB 20", "SQLite 3.", "-O"}) {
    EXPECT_NE(verbose.out.find(word), std::string::npos) << verbose.out;
  }
  EXPECT_EQ(run({"--version", "--bogus"}).status, 2);
}

TEST(WrappedText, BreaksBetweenWords) {
  EXPECT_EQ(wrapped("", 10), "");
  EXPECT_EQ(wrapped("one two three", 9), "one two\nthree");
  EXPECT_EQ(wrapped("one two three", 13), "one two three");
  EXPECT_EQ(wrapped("one  two three", 9, 2), "one two\n  three");
  EXPECT_EQ(wrapped("one two", 9, 4, 4), "one\n    two");
  EXPECT_EQ(wrapped("a longer-than-the-line b", 8), "a\nlonger-than-the-line\nb");
  EXPECT_EQ(list_entry("-o FILE", "output", 12, 40), "  -o FILE   output\n");
  EXPECT_EQ(list_entry("--output FILE", "output", 12, 40), "  --output FILE\n            output\n");
}

// The source of help, manual pages and completions.
TEST(Descriptions, AreComplete) {
  std::size_t forms = 0;
  for (const Command& command : all_commands()) {
    EXPECT_FALSE(command.title.empty()) << command.name;
    for (const CommandDescription& form : forms_of(command)) {
      ++forms;
      std::set<std::string> names;
      for (const OptionDescription& option : form.options) {
        SCOPED_TRACE(form.name + ": " + option.label());
        EXPECT_TRUE(option.meaning.ends_with(".") || option.meaning.ends_with(")")) << option.meaning;
        EXPECT_FALSE(option.position.empty() && option.names.empty());
        EXPECT_EQ(option.kind == ValueKind::choice, !option.choices.empty());
        EXPECT_EQ(option.kind == ValueKind::none, option.value.empty());
        EXPECT_NE(option.value, "TEXT");  // a name that says nothing
        for (const std::string& name : option.names) EXPECT_TRUE(names.insert(name).second) << name;
      }
      EXPECT_TRUE(names.contains("--help"));
    }
  }
  EXPECT_GE(forms, 30U);
}

}  // namespace
}  // namespace lober::cli

// The view of people at a terminal and of programs: progress, hints, rows as they are ready, tables as Markdown.

#include <fcntl.h>
#include <sys/wait.h>

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "cli/program/progress_text.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/programs.hpp"
#include "tests/cli/pseudo_terminal.hpp"

namespace lober::cli {
namespace {

class AtATerminal : public ProgramTest {
 protected:
  void SetUp() override {
    write_curve("a", flower(400, 7, 0.3, {0, 0}));
    write_curve("b", flower(400, 7, 0.3, {0.2, 0.1}));
  }
  // Runs `lober ARGUMENTS` with standard error, and standard output too, on a terminal; all that is written there.
  [[nodiscard]] std::string seen(const std::string& arguments, const std::string& redirection = "> TTY 2>&1") const {
    const Terminal terminal;
    const int keep_open = open(terminal.name().c_str(), O_RDWR | O_NOCTTY);
    std::string line = "exec " + std::string(LOBER_PROGRAM) + " " + arguments + " " + redirection;
    line.replace(line.find("TTY"), 3, terminal.name());
    const pid_t process = start_in(folder(), {"sh", "-c", line});
    std::string text;
    int status = 0;
    while (waitpid(process, &status, WNOHANG) == 0) text += terminal.read_for(0.1);
    text += terminal.read_for(0.2);
    close(keep_open);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << line << '\n' << text;
    EXPECT_EQ(text.find('\x1b'), std::string::npos) << "an escape sequence";
    std::erase(text, '\r');
    return text;
  }
};

TEST_F(AtATerminal, NamesTheFilesThatWereWritten) {
  const std::string files = "overlay a b --lobes lobes.geojson --svg picture.svg --json o.json";
  const std::string text = seen(files, "> out 2> TTY");
  std::size_t lobes = 0;  // as the table has them
  const std::string table = read("out");
  for (const char* const pairing : {"C1 \\ C2: ", "C2 \\ C1: "}) {
    ASSERT_NE(table.find(pairing), std::string::npos) << table;
    lobes += std::stoul(table.substr(table.find(pairing) + std::string(pairing).size()));
  }
  EXPECT_GT(lobes, 0U);
  EXPECT_NE(text.find("wrote lobes.geojson (" + std::to_string(lobes) + " lobes, "), std::string::npos) << text;
  EXPECT_NE(text.find("picture.svg ("), std::string::npos) << text;
  EXPECT_NE(text.find("); open it in a web browser\n"), std::string::npos) << text;
  EXPECT_NE(text.find("wrote o.json ("), std::string::npos) << text;
  EXPECT_EQ(seen(files + " --quiet", "> out 2> TTY"), "");
  EXPECT_EQ(run_in_bash("lober " + files).err, "");
}

TEST_F(AtATerminal, PrintsTheRowsOfASweepOnce) {
  const std::string sweep = "transport standard --sweep K=0.9:1.2:0.1 --quiet";
  EXPECT_EQ(seen(sweep), run_in_bash("lober " + sweep).out);
}

TEST_F(AtATerminal, PrintsTheLinesOfTransportOnce) {
  const std::string transport = "transport standard --iterates 2 --quiet";
  const auto lines = [](const std::string& text) {
    std::multiset<std::string> all;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      if (!line.empty()) all.insert(line);
    }
    return all;
  };
  const std::string rows_first = seen(transport), piped = run_in_bash("lober " + transport).out;
  EXPECT_EQ(lines(rows_first), lines(piped));
  EXPECT_LT(rows_first.find("T12 by boundaries"), rows_first.find("saddle (")) << rows_first;
}

TEST_F(AtATerminal, WritesObjectsForPrograms) {
  for (const char* const command :
       {"overlay a b", "transport standard --iterates 3", "systems", "winding a --at 0,0"}) {
    const Outcome outcome = run_in_bash(std::string("lober ") + command + " --progress json --quiet");
    EXPECT_EQ(outcome.status, 0);
    std::istringstream stream(outcome.err);
    Json last;
    std::size_t count = 0;
    for (std::string line; std::getline(stream, line); ++count) {
      last = Json::parse(line);
      EXPECT_EQ(members(last), (std::set<std::string>{"command", "status", "what", "fraction", "amount", "unit", "rate",
                                                      "seconds", "seconds_left"}));
      if (!last["fraction"].is_null()) {
        EXPECT_LE(last["fraction"].get<double>(), 1);
      }
    }
    EXPECT_GE(count, 2U) << command;
    EXPECT_EQ(last["status"], "done");
    EXPECT_EQ(last["fraction"], 1);
    EXPECT_LE(static_cast<double>(count), 3 + 5 * last["seconds"].get<double>());
  }
}

TEST_F(AtATerminal, TheLastObjectSaysThatItFailed) {
  const Outcome outcome = run({"overlay", "a", "missing", "--progress", "json"});
  EXPECT_EQ(outcome.status, 1);
  const std::size_t message = outcome.err.find("lober: missing");
  ASSERT_NE(message, std::string::npos) << outcome.err;
  const std::size_t last = outcome.err.rfind('{', message);
  const Json object = Json::parse(outcome.err.substr(last, message - last));
  EXPECT_EQ(object["status"], "failed");
  EXPECT_EQ(object["what"], "reading");
}

TEST_F(AtATerminal, EveryCommandHasTheOptions) {
  std::istringstream names(run({"--generate", "commands"}).out);
  std::size_t count = 0;
  for (std::string name; std::getline(names, name); ++count) {
    std::vector<std::string> words{"help", name};
    if (name == "batch") words.emplace_back("export");
    const std::string help = run(words).out;
    for (const char* const option : {"--progress KIND", "-q, --quiet", "-v, --verbose"}) {
      EXPECT_NE(help.find(option), std::string::npos) << name << ' ' << option;
    }
  }
  EXPECT_GT(count, 15U);
}

TEST_F(AtATerminal, VerboseReportsPhasesOnEveryCommand) {
  const Outcome outcome = run({"winding", "a", "--at", "0,0", "--verbose"});
  EXPECT_NE(outcome.err.find("lober: seconds: reading "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("winding numbers "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(", total "), std::string::npos) << outcome.err;
}

TEST_F(AtATerminal, TablesAreMarkdownWhereAskedFor) {
  const Outcome outcome = run({"overlay", "a", "b", "--table", "md"});
  EXPECT_NE(outcome.out.find("\n\n| area of |  | +- rounding |"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("| lobe | area | centroid | holes | crossings |\n| ---: | ---: | :---: | ---: | :--- |\n"),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("| C1 \\\\ C2 |"), std::string::npos) << outcome.out;
  std::istringstream stream(outcome.out);
  for (std::string line; std::getline(stream, line);) {
    EXPECT_TRUE(line.empty() || line.starts_with("- ") || (line.starts_with("| ") && line.ends_with(" |"))) << line;
  }
}

TEST_F(AtATerminal, OtherReportsAreMarkdownToo) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> commands{
      {{"formats"}, "| format | endings | read | written | files |"},
      {{"systems"}, "| system | equations, and the map |"},
      {{"systems", "henon"}, "| parameter | value | meaning and range |"},
      {{"densify", "a", "--max-length", "0.1", "-o", "d.npy"}, "| step | points | rounds |"},
      {{"section", "capsize", "--exit-times", "--iterates", "2", "--picture", "p.svg"},
       "| leave after crossing | orbits | share (%) |"},
      {{"grow", "henon", "--unstable", "--iterates", "2"}, "- growing ended after the iterates asked for"}};
  for (auto [arguments, expected] : commands) {
    arguments.insert(arguments.end(), {"--table", "md"});
    const Outcome outcome = run(arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find(expected), std::string::npos) << outcome.out;
    std::istringstream stream(outcome.out);
    for (std::string line; std::getline(stream, line);) {
      EXPECT_TRUE(line.empty() || line.starts_with("- ") || (line.starts_with("| ") && line.ends_with(" |"))) << line;
    }
  }
}

TEST(ProgressLine, FitsTheTerminal) {
  const ProgressState state{"reading a file whose name is longer than the terminal is wide.txt", 0.5, 0, "", 600, 0};
  EXPECT_LE(progress_line(state, 50).size(), 50U);
  EXPECT_NE(progress_line(state, 50).find("about 10 min left"), std::string::npos);
  EXPECT_EQ(progress_line({"a\x1b[2Jb", 0, 0, "", 5, 0}), "a?[2Jb: 5 s, time left not known yet");
}

}  // namespace
}  // namespace lober::cli

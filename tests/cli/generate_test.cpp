// Manual pages and completions: the tools that read them find nothing wrong, and shells complete by them.

#include <algorithm>
#include <set>
#include <sstream>

#include "lober/dynamics/systems.hpp"
#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

class Generate : public ProgramTest {
 protected:
  [[nodiscard]] std::string generate(std::vector<std::string> words) const {
    words.insert(words.begin(), "--generate");
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }
  [[nodiscard]] std::vector<std::string> commands() const {
    std::vector<std::string> names;
    std::istringstream list(generate({"commands"}));
    for (std::string name; std::getline(list, name);) names.push_back(name);
    EXPECT_GE(names.size(), 20U);
    return names;
  }
  // The words that bash offers for the last of these, one a line.
  [[nodiscard]] std::set<std::string> bash_offers(const std::string& words) const {
    return offers(
        run_in_bash("source <(lober --generate complete-bash)\n"
                    "complete_words() { COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _lober;"
                    " printf '%s\\n' \"${COMPREPLY[@]}\"; }\n"
                    "complete_words " +
                    words));
  }
  [[nodiscard]] static std::set<std::string> offers(const Outcome& outcome) {
    EXPECT_EQ(outcome.err, "");
    std::set<std::string> words;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) {
      if (!line.empty()) words.insert(line);
    }
    return words;
  }
};

using Words = std::set<std::string>;

TEST_F(Generate, ManualPagesHaveAllSections) {
  const Environment date("SOURCE_DATE_EPOCH", "86400");
  const std::string page = generate({"man"});
  EXPECT_TRUE(page.starts_with(".TH LOBER 1 1970-01-02 ")) << page.substr(0, 80);
  for (const char* const section :
       {"NAME", "SYNOPSIS", "DESCRIPTION", "COMMANDS", "EXIT STATUS", "ENVIRONMENT", "FILES", "EXAMPLES", "SEE ALSO"}) {
    EXPECT_NE(page.find(std::string("\n.SH \"") + section + "\"\n"), std::string::npos) << section;
  }
  for (const std::string& command : commands()) {
    EXPECT_NE(page.find("\n.B lober " + command), std::string::npos) << command;
    EXPECT_TRUE(generate({"man", command}).starts_with(".TH LOBER-")) << command;
  }
  const std::string overlay = generate({"man", "overlay"});
  for (const char* const words :
       {".B \\-\\-json FILE\n", ".SS \"Pictures\"\n", "auto, tree, grid or kd.", ".B lober overlay\n", "lober(1)"}) {
    EXPECT_NE(overlay.find(words), std::string::npos) << words << "\n" << overlay;
  }
  EXPECT_NE(generate({"man", "grow"}).find("Built-in systems: abc, capsize"), std::string::npos);
  EXPECT_NE(generate({"man", "batch"}).find("\n.SH \"OPTIONS OF lober batch export STORE\"\n"), std::string::npos);
  EXPECT_EQ(run({"--generate", "man", "overlay", "more"}).status, 2);
  EXPECT_EQ(run({"--generate"}).status, 2);
}

// Each page by itself, so that a message names its command.
TEST_F(Generate, ManualPagesAreReadWithoutAWarning) {
  const bool groff = is_installed("groff"), mandoc = is_installed("mandoc");
  if (!groff && !mandoc) GTEST_SKIP() << "neither groff nor mandoc is installed";
  std::vector<std::string> pages = commands();
  pages.emplace_back();
  for (const std::string& name : pages) {
    SCOPED_TRACE("lober " + name);
    write("page.1", name.empty() ? generate({"man"}) : generate({"man", name}));
    if (groff) {
      const Outcome shown = run_other("groff", {"-man", "-Tutf8", "-ww", "-P-cbou", "page.1"});
      EXPECT_EQ(shown.status, 0);
      EXPECT_EQ(shown.err, "");
      EXPECT_NE(shown.out.find("EXIT STATUS"), std::string::npos);
    }
    if (mandoc) {
      EXPECT_EQ(run_other("mandoc", {"-T", "lint", "page.1"}).out, "");
    }
  }
}

TEST_F(Generate, BashCompletesCommandsAndOptions) {
  EXPECT_EQ(bash_offers("lober ov"), Words{"overlay"});
  EXPECT_EQ(bash_offers("lober --v"), Words{"--version"});
  EXPECT_EQ(bash_offers("lober help fix"), Words{"fixed-points"});
  EXPECT_EQ(bash_offers("lober batch ex"), Words{"export"});
  EXPECT_EQ(bash_offers("lober --generate complete-"), (Words{"complete-bash", "complete-fish", "complete-zsh"}));
  EXPECT_EQ(bash_offers("lober overlay a b --lo"), Words{"--lobes"});
  EXPECT_EQ(bash_offers("lober batch export x --f"), Words{"--format"});
  const std::set<std::string> all = bash_offers("lober ''");
  for (const std::string& command : commands()) EXPECT_TRUE(all.contains(command)) << command;
}

TEST_F(Generate, BashCompletesValues) {
  write("curve.dat", "0 0\n");
  write("other file.dat", "0 0\n");
  EXPECT_EQ(bash_offers("lober overlay a b --rule ''"), (Words{"nonzero", "evenodd", "positive", "negative"}));
  EXPECT_EQ(bash_offers("lober overlay a b --rule = non"), Words{"nonzero"});
  EXPECT_EQ(bash_offers("lober overlay a b --rule ="), (Words{"nonzero", "evenodd", "positive", "negative"}));
  EXPECT_EQ(bash_offers("lober overlay a b --threads ''"), Words{});
  EXPECT_EQ(bash_offers("lober overlay cur"), Words{"curve.dat"});
  EXPECT_EQ(bash_offers("lober overlay curve.dat oth"), Words{"other file.dat"});
  EXPECT_EQ(bash_offers("lober overlay a b --json cur"), Words{"curve.dat"});
  EXPECT_EQ(bash_offers("lober a.dat cur"), Words{"curve.dat"});  // of a published form
  EXPECT_EQ(bash_offers("lober grow hen"), Words{"henon"});
  EXPECT_EQ(bash_offers("lober grow ovp --param ''"), (Words{"gamma=", "eps=", "phase="}));
  EXPECT_EQ(bash_offers("lober schema regi"), Words{"regions"});
  EXPECT_EQ(bash_offers("lober batch export x --operation regi"), Words{"regions"});
  std::set<std::string> systems;
  for (const SystemInfo& info : list_systems()) systems.insert(info.name);
  EXPECT_EQ(bash_offers("lober transport ''"), systems);
}

TEST_F(Generate, FishCompletes) {
  if (!is_installed("fish")) GTEST_SKIP() << "fish is not installed";
  write("lober.fish", generate({"complete-fish"}));
  write("curve.dat", "0 0\n");
  const auto fish_offers = [&](const std::string& line) {
    const Environment home("HOME", folder().c_str());
    std::set<std::string> words;
    for (const std::string& found :
         offers(run_other("fish", {"--no-config", "-c", "source lober.fish; complete -C'" + line + "'"}))) {
      words.insert(found.substr(0, found.find('\t')));
    }
    return words;
  };
  EXPECT_TRUE(fish_offers("lober ov").contains("overlay"));
  EXPECT_EQ(fish_offers("lober overlay --ru"), Words{"--rule"});
  const std::set<std::string> options = fish_offers("lober overlay --");
  for (const char* const option : {"--json", "--lobes", "--rule", "--threads", "--verify"}) {
    EXPECT_TRUE(options.contains(option)) << option;
  }
  EXPECT_FALSE(options.contains("--unstable"));
  EXPECT_EQ(fish_offers("lober overlay a b --rule "), (Words{"nonzero", "evenodd", "positive", "negative"}));
  EXPECT_EQ(fish_offers("lober overlay cur"), Words{"curve.dat"});
  EXPECT_EQ(fish_offers("lober batch ex"), Words{"export"});
  EXPECT_EQ(fish_offers("lober batch export --for"), Words{"--format"});
  EXPECT_EQ(fish_offers("lober help fix"), Words{"fixed-points"});
  EXPECT_TRUE(fish_offers("lober grow hen").contains("henon"));
  EXPECT_EQ(fish_offers("lober grow ovp --param ga"), Words{"gamma="});
  EXPECT_EQ(fish_offers("lober schema regi"), Words{"regions"});
}

// A zsh of its own on a terminal of its own, whose completion is asked by a key.
TEST_F(Generate, ZshCompletes) {
  if (!is_installed("zsh")) GTEST_SKIP() << "zsh is not installed";
  std::filesystem::create_directory(folder() / "functions");
  write("functions/_lober", generate({"complete-zsh"}));
  write("curve.dat", "0 0\n");
  write("offers.zsh", R"zsh(zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell 'PS1=; PS2=; fpath=($PWD/functions $fpath); autoload -U compinit; compinit -u -D'
zpty -w shell 'stty -echo; compadd() { local -a found; builtin compadd -O found "$@"; print -rl -- "offer "$^found >>offers.txt; builtin compadd "$@"; }'
zpty -w shell 'touch ready'
integer waited=0
until [[ -e ready ]] || (( waited++ > 300 )); do sleep 0.1; done
zpty -w -n shell "$1"$'\t'
waited=0
until [[ -s offers.txt ]] || (( waited++ > 50 )); do sleep 0.1; done
sleep 0.3
zpty -d shell
)zsh");
  const auto zsh_offers = [&](const std::string& line) {
    for (const char* const name : {"ready", "offers.txt"}) std::filesystem::remove(folder() / name);
    (void)run_other("zsh", {"-f", "offers.zsh", line});
    std::set<std::string> words;
    std::istringstream lines(read("offers.txt"));
    for (std::string found; std::getline(lines, found);) {
      if (found.size() > 6) words.insert(found.substr(6));
    }
    return words;
  };
  EXPECT_TRUE(zsh_offers("lober ov").contains("overlay"));
  EXPECT_TRUE(zsh_offers("lober overlay --ru").contains("--rule"));
  EXPECT_EQ(zsh_offers("lober overlay a b --rule "), (Words{"nonzero", "evenodd", "positive", "negative"}));
  EXPECT_TRUE(zsh_offers("lober overlay cur").contains("curve.dat"));
  EXPECT_TRUE(zsh_offers("lober batch ex").contains("export"));
  EXPECT_TRUE(zsh_offers("lober batch export --for").contains("--format"));
  EXPECT_TRUE(zsh_offers("lober grow hen").contains("henon"));
  EXPECT_TRUE(zsh_offers("lober grow ovp --param ").contains("gamma="));
}

TEST_F(Generate, TheReferenceHasEveryOption) {
  const std::string reference = generate({"markdown"});
  for (const char* const words : {"\n## lober overlay\n", "\n## lober batch run\n", "| `--rule RULE` |",
                                  "\nlober transport --manifolds FILE [options]\n", "`-o, --output FILE`"}) {
    EXPECT_NE(("\n" + reference).find(words), std::string::npos) << words;
  }
}

}  // namespace
}  // namespace lober::cli

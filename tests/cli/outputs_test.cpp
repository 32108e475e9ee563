// Files that a command may write over: never an input, never under the name of another format, and by the published
// form nothing but an earlier result.

#include <array>
#include <cstdlib>

#include "lober/curve/files.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/programs.hpp"
#include "tests/paths.hpp"

namespace lober::cli {
namespace {

namespace fs = std::filesystem;

class Outputs : public ProgramTest {
 protected:
  void SetUp() override {
    write_curve("a.dat", box(0, 0, 2, 2));
    write_curve("b.dat", box(1, 1, 3, 3));
    write_curve("u.dat", std::vector<Point>{{0, 0}, {10, 0}});
    write_curve("s.dat", std::vector<Point>{{9, 3}, {7, -1}, {5, 1}, {3, -1}, {1.9, 0.1}});
    fs::create_hard_link(folder() / "a.dat", folder() / "hard");
    fs::create_symlink("a.dat", folder() / "soft");
    fs::create_directory(folder() / "sub");
    fs::create_symlink("..", folder() / "sub/up");
  }

  void expect_refused(const std::vector<std::string>& arguments, const std::string& words, int status = 2) {
    const std::string before = read("a.dat") + read("u.dat");
    const Outcome outcome = run(arguments);
    std::string command = "lober";
    for (const std::string& argument : arguments) command += " " + argument;
    EXPECT_EQ(outcome.status, status) << command << '\n' << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << command << '\n' << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << command << '\n' << outcome.err;
    EXPECT_EQ(read("a.dat") + read("u.dat"), before) << command;
  }
};

TEST_F(Outputs, AreNoInputsHoweverNamed) {
  const std::string absolute = folder() / "a.dat";
  for (const std::string& name : {std::string("a.dat"), std::string("./a.dat"), std::string("sub/../a.dat"), absolute,
                                  std::string("sub/up/a.dat"), std::string("hard"), std::string("soft")}) {
    expect_refused({"overlay", "a.dat", "b.dat", "--lobes", name}, "overwrite");
    expect_refused({"overlay", name, "b.dat", "--lobes", "a.dat"}, "overwrite");
    expect_refused({"overlay", "b.dat", "a.dat#0", "--lobes", name, "--rule", "evenodd"}, "overwrite");
    expect_refused({"a.dat", "b.dat", name}, "overwrite");
    expect_refused({"-light", "b.dat", "a.dat", name}, "overwrite");
  }
  expect_refused({"interior", "a.dat", "b.dat", "--json", "hard"}, "overwrite");
  expect_refused({"densify", "a.dat", "-o", "a.dat", "--max-length", "1"}, "-o would overwrite the input");
  expect_refused({"densify", "b.dat", "a.dat", "--crossings", "-o", "sub/up/a.dat"}, "overwrite");
  expect_refused({"tangle", "u.dat", "s.dat", "--graph", "./u.dat"}, "overwrite");
  expect_refused({"u.dat", "s.dat", "x", "./u.dat", "y", "0", "0", "1"}, "overwrite");
  // A zone whose title holds the mark of a zone.
  write("z.dat", "ZONE T=\"p#1\"\n0 0\n2 0\n2 2\nZONE T=\"q\"\n1 1\n3 1\n3 3\n");
  expect_refused({"overlay", "z.dat#p#1", "b.dat", "--lobes", "z.dat"}, "overwrite");
}

TEST_F(Outputs, AreNotWhatStandardInputComesFrom) {
  const std::string command =
      "cd '" + folder().string() + "' && " LOBER_PROGRAM " overlay - b.dat --lobes a.dat <a.dat 2>err";
  const std::string before = read("a.dat");
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 2);
  EXPECT_EQ(read("a.dat"), before);
  EXPECT_NE(read("err").find("overwrite"), std::string::npos);
}

TEST_F(Outputs, AreNotAmongTheFilesOfABatch) {
  write("m.toml", "operation = \"overlay\"\ncurves = [\"a.dat\", \"b.dat\"]\npairs = \"all\"\n");
  expect_refused({"batch", "run", "m.toml", "--json", "a.dat"}, "JSON");
  fs::create_hard_link(folder() / "a.dat", folder() / "a.json");
  expect_refused({"batch", "run", "m.toml", "-q", "--json", "a.json"}, "overwrite");
  fs::create_hard_link(folder() / "m.toml", folder() / "m.json");
  const std::string manifest = read("m.toml");
  expect_refused({"batch", "run", "m.toml", "--json", "m.json"}, "overwrite");
  EXPECT_EQ(read("m.toml"), manifest);
  ASSERT_EQ(run({"batch", "run", "m.toml", "-q"}).status, 0);
  fs::create_symlink("m.results", folder() / "m.csv");
  const std::string store = read("m.results");
  expect_refused({"batch", "export", "m.results", "-o", "m.csv"}, "overwrite");
  EXPECT_EQ(read("m.results"), store);
}

TEST_F(Outputs, AreNotTheLibraryOfASystem) {
  fs::copy_file(LOBER_EXAMPLES "/quadratic_map.so", folder() / "map.so");
  fs::create_hard_link(folder() / "map.so", folder() / "out.json");
  const std::string library = read("map.so");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"transport", "./map.so"},
        {"tangle", "--system", "map.so"},
        {"escape", "map.so", "--energy", "1"},
        {"grow", "./map.so", "--unstable", "--tolerance", "1", "--iterates", "1"}}) {
    std::vector<std::string> arguments = command;
    arguments.insert(arguments.end(), {"--json", "out.json"});
    expect_refused(arguments, "overwrite");
    EXPECT_EQ(read("map.so"), library) << command[0];
  }
}

TEST_F(Outputs, HaveTheEndingsOfTheirFormats) {
  using Arguments = std::vector<std::string>;
  const auto refused = [&](Arguments command, const char* option, const char* name, const char* accepted) {
    command.insert(command.end(), {option, name});
    expect_refused(command, accepted);
    EXPECT_FALSE(exists(name)) << name;
  };
  const Arguments overlay{"overlay", "a.dat", "b.dat"}, tangle{"tangle", "u.dat", "s.dat"};
  refused(overlay, "--svg", "x.json", ".svg or .pdf or .png");
  refused(overlay, "--data", "x.svg", ".csv or .json");
  refused(overlay, "--lobes", "x.npy", ".geojson");
  refused(overlay, "--lobes", "x.mat", ".npz");
  refused(overlay, "--crossings", "x.dat", ".csv");
  refused(overlay, "--json", "x.svg", ".json");
  refused({"interior", "a.dat", "b.dat"}, "--json", "x.toml", ".json");
  refused(tangle, "--pips", "x.h5", ".csv");
  refused(tangle, "--boundary", "x.PNG", ".dat");
  refused(tangle, "--graph", "x.dot", ".json");
  refused({"tangle", "--system", "henon"}, "--lobes", "x.shp", ".dat");
  refused({"transport", "henon"}, "--picture", "x.npy", ".svg");
  refused({"escape", "capsize"}, "--svg", "x.csv", ".svg");
  refused({"grow", "henon", "--unstable", "--tolerance", "1e-3", "--iterates", "1"}, "-o", "x.svg", ".npy");
  refused({"a.dat"}, "b.dat", "x.npy", "<rslt>");
  for (const char* name : {"x.JSON", "x", "x.0.6", "x.K=2"}) {
    EXPECT_EQ(run({"overlay", "a.dat", "b.dat", "--json", name}).status, 0) << name;
  }
}

// --format names the format whatever the ending is; several curves need one that holds them.
TEST_F(Outputs, HaveTheFormatThatIsNamed) {
  write_curve("a", box(0, 0, 2, 2));
  write_curve("b", box(1, 1, 3, 3));
  EXPECT_EQ(run({"overlay", "a", "b", "--lobes", "l.foo", "--format", "csv"}).status, 0);
  EXPECT_NE(read("l.foo").find("x,y,curve"), std::string::npos);
  EXPECT_EQ(read_curve_file(folder() / "l.foo").zones.size(), 2U);
  for (const std::vector<std::string>& none : {std::vector<std::string>{"overlay", "a", "b", "--format", "csv"},
                                               std::vector<std::string>{"tangle", "a", "b", "--format", "csv"},
                                               std::vector<std::string>{"levels", "capsize", "--format", "csv"}}) {
    const Outcome unused = run(none);
    EXPECT_EQ(unused.status, 2);
    EXPECT_NE(unused.err.find("--format needs "), std::string::npos) << unused.err;
  }
  const Outcome ending = run({"overlay", "a", "b", "--lobes", "l.foo"});
  EXPECT_EQ(ending.status, 2);
  EXPECT_NE(ending.err.find("or name a format by --format"), std::string::npos) << ending.err;
  for (const std::vector<std::string>& extra : {std::vector<std::string>{"--lobes", "l.npy"},
                                                std::vector<std::string>{"--lobes", "l.csv", "--format", "npy"}}) {
    std::vector<std::string> arguments{"overlay", "a", "b"};
    arguments.insert(arguments.end(), extra.begin(), extra.end());
    const Outcome one = run(arguments);
    EXPECT_EQ(one.status, 2) << one.err;
    EXPECT_NE(one.err.find("holds one; use .csv, .txt, .dat (tecplot)"), std::string::npos) << one.err;
  }
}

// Tables of text say where they come from, and are read back.
TEST_F(Outputs, OfTextHaveNotes) {
  write_curve("a", box(0, 0, 2, 2));
  for (const char* const name : {"d.csv", "d.txt"}) {
    ASSERT_EQ(run({"densify", "a", "--max-length", "0.5", "-o", name}).status, 0);
    const std::string text = read(name);
    EXPECT_TRUE(text.starts_with("# lober: ")) << text;
    EXPECT_NE(text.find("\n# input 1: a sha256 "), std::string::npos) << text;
    EXPECT_EQ(read_curve_file(folder() / name).zones.at(0).points.size(), 16U);
  }
  EXPECT_FALSE(run({"densify", "a", "--max-length", "0.5", "-o", "-"}).out.starts_with("#"));
}

TEST_F(Outputs, StandardInputIsReadOnce) {
  write("two", "ZONE\n0 0\n1 0\n1 1\nZONE\n0 0\n1 0\n0 1\n");
  for (const char* const line : {"lober overlay - - < two", "cat two | lober overlay -#0 -#1"}) {
    const Outcome twice = run_in_bash(line);
    EXPECT_EQ(twice.status, 2) << line;
    EXPECT_NE(twice.err.find("standard input is named twice"), std::string::npos) << twice.err;
  }
  EXPECT_EQ(run_in_bash("lober overlay -#0 -#1 --areas-only < two").status, 0);  // a file, which is opened twice
  EXPECT_EQ(run_in_bash("lober overlay -#0 two#1 --areas-only < two").status, 0);
}

TEST_F(Outputs, OfThePublishedFormReplaceEarlierResultsOnly) {
  write_curve("c.dat", box(5, 5, 6, 6));
  const std::string curve = read("c.dat");
  expect_refused({"a.dat", "b.dat", "c.dat"}, "four numbers");
  expect_refused({"-light", "a.dat", "b.dat", "c.dat"}, "four numbers");
  EXPECT_EQ(read("c.dat"), curve);
  EXPECT_FALSE(exists("c12.dat"));
  for (const char* content : {"3\t1e-14\t3\t1e-14\n", "3 nan 0 0", ""}) {
    write("result", content);
    EXPECT_EQ(run({"a.dat", "b.dat", "result"}).status, 0) << content;
  }
  for (const char* content : {"3 0 3\n", "1 2 3 4 5\n", "1 2\n3 4\n", "1 2 3 x\n"}) {
    write("result", content);
    expect_refused({"a.dat", "b.dat", "result"}, "four numbers");
    EXPECT_EQ(read("result"), content);
  }
  expect_refused({"u.dat", "s.dat", "x", "c.dat", "y", "0", "0", "1"}, "<manifile>");
  EXPECT_EQ(read("c.dat"), curve);
  for (int times = 0; times < 2; ++times) {
    EXPECT_EQ(run({"u.dat", "s.dat", "x", "m", "y", "0", "0", "1", "l"}).status, 0) << times;
  }
}

TEST_F(Outputs, AreNotMadeByASlipOfACommand) {
  write("m.toml", "operation = \"overlay\"\n");
  const std::string manifest = read("m.toml");
  expect_refused({"bathc", "run", "m.toml"}, "did you mean batch?");
  EXPECT_EQ(read("m.toml"), manifest);
  for (const auto& [slip, meant] : {std::pair{"Overlay", "overlay"},
                                    {"overaly", "overlay"},
                                    {"interor", "interior"},
                                    {"grwo", "grow"},
                                    {"trans", "transport"},
                                    {"tangel", "tangle"}}) {
    expect_refused({slip, "a.dat", "b.dat"}, std::string("did you mean ") + meant + "?");
  }
  // A file of that name is a curve.
  write_curve("bathc", box(0, 0, 1, 1));
  EXPECT_EQ(run({"bathc", "a.dat", "result"}).status, 0);
}

}  // namespace
}  // namespace lober::cli

// Requests that cannot be met are refused in one line, with the right exit status, and leaves files as they were.

#include <algorithm>

#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

class BadInput : public ProgramTest {
 protected:
  void SetUp() override {
    write_curve("good", box(0, 0, 1, 1));
    for (const char* name : {"out", "c12.dat", "c10.dat"}) write(name, precious);
  }
  // An earlier result, which the published form may replace when all goes well.
  static constexpr const char* precious = "0.5\t1e-14\t0.25\t1e-14\n";

  void expect_failure(const std::vector<std::string>& arguments, int status, std::string_view words) {
    const Outcome outcome = run(arguments);
    std::string command = "lober";
    for (const std::string& argument : arguments) command += " " + argument;
    EXPECT_EQ(outcome.status, status) << command << '\n' << outcome.err;
    EXPECT_EQ(outcome.out, "") << command;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << command << '\n' << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("lober: ") && outcome.err.ends_with("\n")) << command << '\n' << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << command << '\n' << outcome.err;
    for (const char* name : {"out", "c12.dat", "c10.dat"}) EXPECT_EQ(read(name), precious) << command << ' ' << name;
    for (const auto& entry : std::filesystem::directory_iterator(folder())) {
      EXPECT_EQ(entry.path().string().find(".part-"), std::string::npos) << command << ' ' << entry.path();
    }
  }

  // In either place, and by the published command lines.
  void expect_bad_data(const std::string& curve, std::string_view words) {
    expect_bad_for_all_but_light(curve, words);
    expect_failure({"-light", curve, "good", "out"}, 1, words);
  }
  void expect_bad_for_all_but_light(const std::string& curve, std::string_view words) {
    expect_failure({"overlay", curve, "good", "--json", "out"}, 1, words);
    expect_failure({"overlay", "good", curve, "--lobes", "out"}, 1, words);
    expect_failure({"good", curve, "out"}, 1, words);
    expect_failure({"interior", curve, "good", "--json", "out"}, 1, words);
    expect_failure({"interior", "good", curve, "--method", "ends", "--json", "out"}, 1, words);
    expect_failure({"-light", curve, "good", "out", "-DENS", "2", "3"}, 1, words);
  }
};

TEST_F(BadInput, MissingFile) {
  expect_bad_data("nowhere.dat", "nowhere.dat: ");
}

TEST_F(BadInput, Folder) {
  std::filesystem::create_directory(folder() / "folder");
  expect_bad_data("folder", "folder: ");
}

TEST_F(BadInput, NoPoints) {
  write("empty", "");
  expect_bad_data("empty", "empty: ");
  write("header", "VARIABLES=\"x\"\"y\"\nZONE T=\"a\"\n");
  expect_bad_data("header", "header:");
}

TEST_F(BadInput, NumbersThatAreNotFinite) {
  write("nan", "0 0\n1 0\nnan 1\n");
  expect_bad_data("nan", "nan:3: ");
  write("inf", "0 0\n1 -inf\n0 1\n");
  expect_bad_data("inf", "inf:2: ");
  write("huge", "0 0\n1 0\n0 1e999\n");
  expect_bad_data("huge", "huge:3: ");
}

TEST_F(BadInput, OneColumn) {
  write("column", "0\n1\n2\n");
  expect_bad_data("column", "column:1: ");
}

TEST_F(BadInput, GarbageLine) {
  write("garbage", "# comment\n0 0\n1 0\nhello world\n0 1\n");
  expect_bad_data("garbage", "garbage:4: ");
}

TEST_F(BadInput, FewerThanThreeDistinctVertices) {
  write("two", "0 0\n1 0\n1 0\n0 0\n0 0\n");
  expect_bad_data("two", "two: ");
  write("one", "1 2\n");
  expect_bad_data("one", "one: ");
}

TEST_F(BadInput, ZoneThatIsNotThere) {
  write("zones", "ZONE T=\"a\"\n0 0\n1 0\n0 1\nZONE T=\"b\"\n0 0\n1 0\n0 1\n");
  expect_bad_data("zones", "zones: ");  // which one?
  expect_bad_data("zones#7", "7");
  expect_bad_data("zones#c", "\"c\"");
}

// -light without -DENS takes such curves (published_form_test.cpp).
TEST_F(BadInput, CurveThatIsNotSimple) {
  write_curve("bow", std::vector<Point>{{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  expect_bad_for_all_but_light("bow", "not simple: segments 0 and 2 meet at (1, 1)");
  write_curve("pinched", std::vector<Point>{{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}});
  expect_bad_for_all_but_light("pinched", "pinched: ");
  write_curve("flat", std::vector<Point>{{0, 0}, {1, 1}, {2, 2}});
  expect_bad_for_all_but_light("flat", "flat: ");
}

TEST_F(BadInput, OutputThatCannotBeWritten) {
  write_curve("other", box(0.5, 0.5, 2, 2));
  for (const char* option : {"--json", "--lobes", "--crossings", "--svg"}) {
    expect_failure({"overlay", "good", "other", option, "nowhere/file"}, 1, "nowhere/file: cannot be written");
    // Nothing else is written either.
    const char* const another = std::string_view(option) == "--json" ? "--svg" : "--json";
    expect_failure({"overlay", "good", "other", another, "out", option, "nowhere/file"}, 1, "nowhere/file");
  }
  expect_failure({"good", "other", "nowhere/file"}, 1, "nowhere/file: cannot be written");
  expect_failure({"-light", "good", "other", "nowhere/file"}, 1, "nowhere/file: cannot be written");
  expect_failure({"interior", "good", "other", "--json", "nowhere/file"}, 1, "nowhere/file: cannot be written");
}

TEST_F(BadInput, CommandsThatCannotBeUnderstood) {
  expect_failure({}, 2, "lober --help");
  expect_failure({"frobnicate"}, 2, "frobnicate");
  expect_failure({"good", "good"}, 2, "<c1> <c2> <rslt>");
  expect_failure({"good", "good", "out", "more"}, 2, "more");
  expect_failure({"-x", "good", "good", "out"}, 2, "-x");
  expect_failure({"overlay"}, 2, "C1");
  expect_failure({"interior"}, 2, "C1");
  expect_failure({"interior", "good"}, 2, "C2");
  expect_failure({"interior", "good", "good", "--lobes", "out"}, 2, "--lobes");
  expect_failure({"-light"}, 2, "-light <c1> <c2> <rslt>");
  expect_failure({"-light", "good", "good"}, 2, "-light <c1> <c2> <rslt>");
  expect_failure({"-light", "good", "good", "out", "more"}, 2, "more");
  expect_failure({"overlay", "good"}, 2, "C2");
  expect_failure({"overlay", "good", "good", "good"}, 2, "good");
  expect_failure({"overlay", "good", "good", "--frobnicate"}, 2, "--frobnicate");
  expect_failure({"overlay", "good", "good", "--json"}, 2, "--json");
}

TEST_F(BadInput, OptionsThatMakeNoSense) {
  expect_failure({"overlay", "good", "good", "--index", "rtree"}, 2, "rtree");
  expect_failure({"overlay", "good", "good", "--threads", "0"}, 2, "--threads");
  expect_failure({"overlay", "good", "good", "--threads", "-3"}, 2, "--threads");
  expect_failure({"overlay", "good", "good", "--threads", "many"}, 2, "--threads");
  expect_failure({"good", "good", "out", "-DENS"}, 2, "-DENS");
  expect_failure({"good", "good", "out", "-DENS", "2"}, 2, "-DENS");
  expect_failure({"good", "good", "out", "-DENS", "2", "x"}, 2, "-DENS");
  expect_failure({"good", "good", "out", "-DENS", "-2", "3"}, 2, "-DENS");
  expect_failure({"-light", "good", "good", "out", "-DENS"}, 2, "-DENS");
  expect_failure({"-light", "good", "good", "out", "-DENS", "1"}, 2, "-DENS");
  expect_failure({"-light", "good", "good", "out", "-DENS", "1", "1e3"}, 2, "-DENS");
  expect_failure({"interior", "good", "good", "--passes", "-3"}, 2, "--passes");
  expect_failure({"interior", "good", "good", "--passes", "3", "--points", "-1"}, 2, "--points");
  expect_failure({"interior", "good", "good", "--passes", "3", "--points", "2000000"}, 2, "--points");
  expect_failure({"interior", "good", "good", "--threads", "0"}, 2, "--threads");
}

// As a variable of the shell gives that was never set.
TEST_F(BadInput, OptionsThatAreEmpty) {
  expect_failure({"overlay", "good", "good", "--json", ""}, 2, "--json has an empty value");
  expect_failure({"overlay", "", "good"}, 2, "C1 has an empty value");
  expect_failure({"tangle", "good", "", "--svg="}, 2, "--picture");
  expect_failure({"densify", "good", "-o", "", "--max-length", "1"}, 2, "empty");
  expect_failure({"batch", "run", "good", "--shard", ""}, 2, "--shard has an empty value");
  expect_failure({"batch", "run", "good", "--memory", ""}, 2, "--memory has an empty value");
}

TEST_F(BadInput, NamesThatATerminalWouldObey) {
  expect_failure({"overlay", "no\x1B[31mwhere\n", "good"}, 1, "no?[31mwhere");
}

TEST_F(BadInput, OptionsThatContradictEachOther) {
  expect_failure({"overlay", "good", "good", "--areas-only", "--lobes", "out"}, 2, "--areas-only");
  expect_failure({"overlay", "good", "good", "--areas-only", "--svg", "out"}, 2, "--areas-only");
  expect_failure({"interior", "good", "good", "--passes", "1", "--points", "2"}, 2, "--passes");
  expect_failure({"overlay", "good", "good", "--json", "new", "--lobes", "./new"}, 2, "both write");
  expect_failure({"overlay", "good", "good", "--json", "-", "--lobes", "-"}, 2, "both write");
  expect_failure({"overlay", "out", "good", "--json", "out"}, 2, "overwrite the input");
  expect_failure({"overlay", "out#0", "good", "--json", "out"}, 2, "overwrite the input");
  expect_failure({"c12.dat", "good", "result"}, 2, "overwrite the input");
}

TEST_F(BadInput, HelpAndVersionAreNoErrors) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--help"},
                                                    {"-h"},
                                                    {"--version"},
                                                    {"overlay", "--help"},
                                                    {"interior", "--help"},
                                                    {"tangle", "--help"},
                                                    {"help"},
                                                    {"help", "transport"},
                                                    {"help", "batch", "run"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("lober"), std::string::npos);
  }
}

}  // namespace
}  // namespace lober::cli
